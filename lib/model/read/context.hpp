#pragma once
#include <cstdint>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "keyword/card.hpp"
#include "keyword/cases.hpp"
#include "keyword/transformation.hpp"
#include "model/entity/raw_sets.hpp"
#include "model/model.hpp"

namespace gapcheck::model {

/// The words of a keyword's name after the family: "THICKNESS", "OFFSET" of *ELEMENT_SHELL_THICKNESS_OFFSET.
struct Options {
  std::vector<std::string_view> words;
  [[nodiscard]] bool has(std::string_view word) const;
  [[nodiscard]] bool any(std::initializer_list<std::string_view> some) const;
  /// How many of them the name has.
  [[nodiscard]] std::size_t count(std::initializer_list<std::string_view> some) const;
};

/// What all readers of one deck share while the model is built. Lives as long as read_model().
struct Context {
  const keyword::Deck& deck;
  Diagnostics& diagnostics;
  Model& model;
  RawSets sets;
  std::map<std::int64_t, std::uint32_t> section_of_id, material_of_id;
  std::uint32_t interfaces = 0;  ///< contacts so far that count
  keyword::Cases cases = keyword::Cases(deck);
  /// Parts of particles that the run makes, which need no *PART.
  std::vector<Part> later_particles = {};
  std::map<std::uint32_t, Vector> part_moves = {};                     ///< of *PART_MOVE, by position of the part
  std::map<std::int64_t, const keyword::Block*> transformations = {};  ///< once *NODE_TRANSFORM asked for them
  std::map<std::int64_t, std::optional<keyword::Placement>> placements = {};
  std::set<std::int64_t> placements_reported = {};  ///< transformations whose faults have been reported
  /// Rows of *NODE_TRANSFORM that wait until everything is read.
  struct NodeMove {
    const Set<NodeIndex>* set;
    std::int64_t transformation;
    Place place;
  };
  std::vector<NodeMove> node_moves = {};
  std::map<std::int64_t, Result<Eigen::Matrix3d>> systems = {};  ///< local axes, once a move asked for them
  std::set<std::int64_t> moving_systems = {};                    ///< *DEFINE_COORDINATE_NODES with FLAG = 1
  bool systems_read = false;
  std::size_t transformed_nodes = 0;     ///< by *NODE_TRANSFORM so far
  std::size_t immediate_moves_read = 0;  ///< rows with IMMED = 1 in decks with boxes
  std::size_t immediate_moves = 0;       ///< of these with transformations that refer to nodes
  double spot_thinning = 0;              ///< SPOTHIN of *CONTROL_CONTACT
  Place spot_thinning_place = {};
  /// Rows of a *DEFINE_TABLE that wait for the curves that follow it; last first.
  std::vector<std::pair<std::int64_t, std::size_t>> waiting_rows = {};

  [[nodiscard]] static Place place(const keyword::Block& block, std::uint32_t line) { return {block.file, line}; }
  /// "line 40 of a.k"
  [[nodiscard]] std::string where(Place place) const;
  void warning(Place place, std::string message);
  void error(Place place, std::string message);
  /// An error about an id, unless the line has one already: then its field could not be read.
  void bad_id(Place place, std::string message);
  /// `kind`: node or element, where the file may have another id.
  void duplicate(std::string_view what, std::int64_t id, Place first, Place again,
                 keyword::IdKind kind = keyword::IdKind::plain);
  /// The id, and in brackets that of the file if *INCLUDE_AUTO_OFFSET shifted it.
  [[nodiscard]] std::string id_text(FileIndex file, keyword::IdKind kind, std::int64_t id) const;
  void unknown(std::string message, Place place);

  [[nodiscard]] const keyword::Transform& transform(const keyword::Block& block) const {
    return deck.transform(block.transform);
  }
  /// The id with the offset of the block's include; zero stays zero.
  [[nodiscard]] std::int64_t with_offset(const keyword::Block& block, keyword::IdKind kind, std::int64_t id) const;
  /// The curve in a card that was cut into real numbers, with its offset; 0: none, or not an id.
  [[nodiscard]] std::int64_t curve_id(const keyword::Block& block, double value) const;
  /// A length of the block in the model's unit.
  [[nodiscard]] double length(const keyword::Block& block, double value) const {
    return value * transform(block).length_factor;
  }
  /// A stress of the block in the model's units.
  [[nodiscard]] double stress(const keyword::Block& block, double value) const {
    const keyword::Transform& units = transform(block);
    return value * units.mass_factor / (units.length_factor * units.time_factor * units.time_factor);
  }
  /// The decay constant of friction of the block, one over a velocity, in the model's units.
  [[nodiscard]] double decay(const keyword::Block& block, double value) const {
    return value * transform(block).time_factor / transform(block).length_factor;
  }
  /// The part's position, or none.
  [[nodiscard]] PartIndex part(std::int64_t id) const;
};

/// True (and the line is skipped) if the next line is blank; for keywords whose rows must not be blank.
[[nodiscard]] bool skip_blank(keyword::CardReader& reader);
/// Skips at most `count` lines; a hostile count costs no more than the existing lines.
void skip_lines(keyword::CardReader& reader, std::int64_t count);

using keyword::Block;
using keyword::Card;
using keyword::CardReader;

// One reader per family of keywords; each reads one block.
void read_nodes(Context& context, const Block& block, const Options& options);
void read_shells(Context& context, const Block& block, const Options& options);
void read_solids(Context& context, const Block& block, const Options& options);
void read_thick_shells(Context& context, const Block& block, const Options& options);
void read_beams(Context& context, const Block& block, const Options& options);
void read_discrete(Context& context, const Block& block, const Options& options);
void read_masses(Context& context, const Block& block, const Options& options);
void read_inertias(Context& context, const Block& block, const Options& options);
void read_particles(Context& context, const Block& block, const Options& options);
void read_parts(Context& context, const Block& block, const Options& options);
void read_later_particles(Context& context, const Block& block, const Options& options);
void read_part_move(Context& context, const Block& block, const Options& options);
void read_node_transform(Context& context, const Block& block, const Options& options);
void read_section_shell(Context& context, const Block& block, const Options& options);
void read_section_solid(Context& context, const Block& block, const Options& options);
void read_section_thick_shell(Context& context, const Block& block, const Options& options);
void read_section_beam(Context& context, const Block& block, const Options& options);
void read_section_discrete(Context& context, const Block& block, const Options& options);
void read_section_particle(Context& context, const Block& block, const Options& options);
void read_section_other(Context& context, const Block& block, const Options& options);
void read_material(Context& context, const Block& block, const Options& options);
void read_equation_of_state(Context& context, const Block& block, const Options& options);
void read_erosion(Context& context, const Block& block, const Options& options);
void read_smooth_curve(Context& context, const Block& block, const Options& options);
void read_curve(Context& context, const Block& block, const Options& options);
void read_table(Context& context, const Block& block, const Options& options);
void read_set(Context& context, const Block& block, const Options& options);
void read_part_tree(Context& context, const Block& block, const Options& options);
void read_box(Context& context, const Block& block, const Options& options);
void read_nodal_rigid_body(Context& context, const Block& block, const Options& options);
void read_extra_nodes(Context& context, const Block& block, const Options& options);
void read_rigid_bodies(Context& context, const Block& block, const Options& options);
void read_spc(Context& context, const Block& block, const Options& options);
void read_prescribed_motion(Context& context, const Block& block, const Options& options);
void read_vector(Context& context, const Block& block, const Options& options);
void read_initial_velocity(Context& context, const Block& block, const Options& options);
void read_initial_velocity_node(Context& context, const Block& block, const Options& options);
void read_initial_velocity_generation(Context& context, const Block& block, const Options& options);
void read_initial_velocity_rigid_body(Context& context, const Block& block, const Options& options);
void read_initial_stress_shell(Context& context, const Block& block, const Options& options);
void read_initial_stress_solid(Context& context, const Block& block, const Options& options);
void read_cross_section(Context& context, const Block& block, const Options& options);
void read_section_preload(Context& context, const Block& block, const Options& options);
void read_beam_preload(Context& context, const Block& block, const Options& options);
void read_spot_weld(Context& context, const Block& block, const Options& options);
void read_joint(Context& context, const Block& block, const Options& options);
void read_generalized_weld(Context& context, const Block& block, const Options& options);
void read_linear_constraint(Context& context, const Block& block, const Options& options);
void read_joined_set(Context& context, const Block& block, const Options& options);
void read_interpolation(Context& context, const Block& block, const Options& options);
void read_concentrated_load(Context& context, const Block& block, const Options& options);
void read_segment_load(Context& context, const Block& block, const Options& options);
void read_shell_load(Context& context, const Block& block, const Options& options);
void read_airbag(Context& context, const Block& block, const Options& options);
void read_body_load(Context& context, const Block& block, const Options& options);
void read_body_load_parts(Context& context, const Block& block, const Options& options);
void read_part_damping(Context& context, const Block& block, const Options& options);
void read_global_damping(Context& context, const Block& block, const Options& options);
void read_relative_damping(Context& context, const Block& block, const Options& options);
void read_integration_shell(Context& context, const Block& block, const Options& options);
void read_hourglass(Context& context, const Block& block, const Options& options);
void read_control_hourglass(Context& context, const Block& block, const Options& options);
void read_control_bulk_viscosity(Context& context, const Block& block, const Options& options);
void read_control_accuracy(Context& context, const Block& block, const Options& options);
void read_rigid_wall(Context& context, const Block& block, const Options& options);
void read_contact(Context& context, const Block& block, const Options& options);
void read_control_contact(Context& context, const Block& block, const Options& options);
void read_control_shell(Context& context, const Block& block, const Options& options);
void read_control_solid(Context& context, const Block& block, const Options& options);
void read_control_solution(Context& context, const Block& block, const Options& options);
void read_control_relaxation(Context& context, const Block& block, const Options& options);
void read_control_timestep(Context& context, const Block& block, const Options& options);
void read_control_units(Context& context, const Block& block, const Options& options);
void read_control_termination(Context& context, const Block& block, const Options& options);
void read_title(Context& context, const Block& block, const Options& options);
void read_database(Context& context, const Block& block, const Options& options);
void read_intfor(Context& context, const Block& block, const Options& options);
void read_intfor_values(Context& context, const Block& block, const Options& options);
void read_unwritten_database(Context& context, const Block& block, const Options& options);
void read_history_elements(Context& context, const Block& block, const Options& options);
void read_unwritten_history(Context& context, const Block& block, const Options& options);
void read_control_output(Context& context, const Block& block, const Options& options);
void read_history_nodes(Context& context, const Block& block, const Options& options);
void read_friction_table(Context& context, const Block& block, const Options& options);

/// The three or four cards of mass, centre, inertia and initial velocity of a rigid body.
[[nodiscard]] BodyInertia read_body_inertia(Context& context, CardReader& reader);

/// Yield data of one material after its first card (`card`, fields of ten columns by position); nothing if the material
/// has none that is read. `name`: "PLASTIC_KINEMATIC".
[[nodiscard]] std::optional<Plasticity> read_plasticity(Context& context, CardReader& reader, const Card& card,
                                                        std::string_view name);

/// Materials 066, 067, 068 and 071 after their first card (fields of ten columns by position); nothing for others.
/// `name`: "CABLE_DISCRETE_BEAM".
[[nodiscard]] std::optional<DiscreteBeamMaterial> read_discrete_beam(const Context& context, CardReader& reader,
                                                                     const Card& card, std::string_view name);

/// Materials S01 to S05, S07 and S08, from their first card (fields of ten columns by position); nothing for others.
/// `name`: "SPRING_ELASTIC".
[[nodiscard]] std::optional<DiscreteMaterial> read_discrete_material(const Context& context, const Block& block,
                                                                     const Card& card, std::string_view name);

/// What 009 says of fluids, from its first card (fields of ten columns by position).
[[nodiscard]] Fluid read_fluid(const Context& context, const Block& block, const Card& card);
/// Material 010 after its first card. `name`: as written, with its options.
[[nodiscard]] Hydro read_hydro(const Context& context, CardReader& reader, const Card& card, std::string_view name);
/// Constants of foams and rubbers other than 027 and their moduli at small strains; nothing for others. `whole_name`:
/// with options.
void read_foam_rubber(Context& context, CardReader& reader, const Card& card, std::string_view name,
                      std::string_view whole_name, Material& material);
/// Materials 015 and 098 after their first card. `name`: "JOHNSON_COOK" or "SIMPLIFIED_JOHNSON_COOK".
[[nodiscard]] JohnsonCook read_johnson_cook(const Context& context, CardReader& reader, const Card& card,
                                            std::string_view name);

/// Data of a spotweld material after its first card (fields of ten columns by position). `name`: as written, without
/// MAT_ and with three digits: "SPOTWELD_TITLE", "100".
[[nodiscard]] SpotWeld read_spotweld(Context& context, CardReader& reader, const Card& card, std::string_view name);

/// The constraint codes of a block of nodes, once the nodes can be found by their ids.
void read_node_constraints(Context& context, const Block& block);

// What remains to be done once all blocks of a kind are read.
void finish_nodes(Context& context);
void finish_parts(Context& context);
/// Sections of shells without ELFORM take THEORY of *CONTROL_SHELL.
void finish_sections(Context& context);
/// Elastic constants of materials whose pressure is that of an equation of state: its slope at rest.
void finish_equations_of_state(Context& context);
/// Materials 002 and 034; `card`: the first.
[[nodiscard]] Orthotropic read_orthotropic(const Context& context, CardReader& reader, const Card& card, bool fabric);
/// Young's and bulk modulus of 027 at small strains, G = 2 (A + B).
void set_small_strain_moduli(Material& material);
/// Once all curves are read: the stiffness that foams take from them, and constants that are fitted to a test (027).
void finish_foams(Context& context);
/// The axes of *DEFINE_COORDINATE_SYSTEM, _NODES or _VECTOR, as columns; the error says why they are not known.
[[nodiscard]] Result<Eigen::Matrix3d> axes_of_system(Context& context, std::int64_t id);
/// Puts the axes of a system that a condition names into Model::systems; nothing for 0.
void note_system(Context& context, std::int64_t id);
/// Moves the nodes of the parts that *PART_MOVE names.
void finish_part_moves(Context& context);
/// Moves the nodes of the rows of *NODE_TRANSFORM without IMMED = 1, which have waited.
void finish_node_transforms(Context& context);
void finish_elements(Context& context);
void resolve_sets(Context& context);
void finish_contacts(Context& context);

}  // namespace gapcheck::model
