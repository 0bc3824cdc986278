#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "keyword/deck.hpp"
#include "model/contact/contact.hpp"
#include "model/entity/airbag.hpp"
#include "model/entity/beam_preload.hpp"
#include "model/entity/boundary.hpp"
#include "model/entity/cross_section.hpp"
#include "model/entity/curve.hpp"
#include "model/entity/equation_of_state.hpp"
#include "model/entity/erosion.hpp"
#include "model/entity/initial_stress.hpp"
#include "model/entity/initial_velocity.hpp"
#include "model/entity/interpolation.hpp"
#include "model/entity/joint.hpp"
#include "model/entity/linear_constraint.hpp"
#include "model/entity/loads.hpp"
#include "model/entity/mesh.hpp"
#include "model/entity/output.hpp"
#include "model/entity/part.hpp"
#include "model/entity/rigid_wall.hpp"
#include "model/entity/sets.hpp"
#include "model/entity/weld.hpp"
#include "model/unknown_keyword.hpp"

namespace gapcheck::model {

/// A contradiction in the deck; the audit reports it as a finding and continues with the rest.
struct Fault {
  enum class Kind : std::uint8_t { duplicate_id, unknown_reference } kind;
  std::string message;  ///< "element 12 is defined again (first in line 40 of a.k)"
  Place place;
};

/// Nodes that one rigid link holds together: *CONSTRAINED_NODAL_RIGID_BODY, _EXTRA_NODES, _RIGID_BODIES.
struct RigidGroup {
  enum class Kind : std::uint8_t { nodal_rigid_body, extra_nodes, merged_parts } kind;
  std::int64_t id = 0;
  std::vector<NodeIndex> nodes;        ///< nodal_rigid_body, extra_nodes
  std::vector<PartIndex> parts;        ///< extra_nodes: the one part; merged_parts: both
  BodyConstraint constraint;           ///< nodal_rigid_body with _SPC
  std::optional<BodyInertia> inertia;  ///< nodal_rigid_body with _INERTIA
  Place place;
};

/// A move that the deck asks for and that the nodes of the model have not made, or not surely as the solver makes it.
struct NotMoved {
  std::string keyword;  ///< without `*`
  std::string why;
  Place place;
};

struct Model {
  std::string title;  ///< the first *TITLE
  Mesh mesh;
  std::vector<Part> parts;  ///< in input order
  std::map<std::int64_t, PartIndex> part_of_id;
  /// Parts of the particles that failing solids become (*DEFINE_ADAPTIVE_SOLID_TO_DES, _SPH), ascending.
  std::vector<PartIndex> later_particles;
  std::vector<Section> sections;
  std::vector<Material> materials;
  std::map<std::int64_t, EquationOfState> equations_of_state;
  std::vector<Erosion> erosions;         ///< *MAT_ADD_EROSION, in input order
  std::map<std::int64_t, Curve> curves;  ///< *DEFINE_CURVE
  std::map<std::int64_t, Table> tables;  ///< *DEFINE_TABLE, *DEFINE_TABLE_2D
  Sets sets;
  std::map<std::int64_t, Box> boxes;
  std::vector<Contact> contacts;  ///< every *CONTACT_ that is an interface, in input order
  std::vector<ContactExclusion> exclusions;
  std::map<std::int64_t, FrictionTable> friction_tables;
  std::vector<RigidGroup> rigid_groups;
  std::vector<Joint> joints;                  ///< in input order
  std::vector<Interpolation> interpolations;  ///< in input order
  std::vector<LinearConstraint> linear_constraints;
  std::vector<JoinedSet> joined_sets;
  std::vector<Weld> welds;                  ///< in input order
  std::vector<RigidWall> rigid_walls;       ///< in input order
  std::vector<SinglePointConstraint> spcs;  ///< these and what follows: in input order
  std::vector<NodeConstraint> node_constraints;
  std::vector<PrescribedMotion> prescribed_motions;
  std::map<std::int64_t, DirectionVector> vectors;
  std::map<std::int64_t, LocalSystem> systems;  ///< those that supports, loads and vectors name
  std::vector<InitialVelocity> initial_velocities;
  std::vector<NodeVelocity> node_velocities;
  std::vector<BeamPreload> beam_preloads;
  std::vector<InitialStress> initial_stresses;
  std::vector<CrossSection> cross_sections;
  std::vector<SectionPreload> section_preloads;
  Loads loads;
  std::vector<Airbag> airbags;                         ///< in the order of the deck
  std::map<std::int64_t, HourglassControl> hourglass;  ///< *HOURGLASS
  std::map<std::int64_t, ShellRule> shell_rules;       ///< *INTEGRATION_SHELL
  Controls controls;
  Output output;
  std::vector<std::string> files;                         ///< paths, by FileIndex
  std::vector<NotMoved> not_moved;                        ///< for runs, which begin where the solver does
  std::vector<Fault> faults;                              ///< by kind and place; complete (the report groups them)
  std::vector<UnknownKeyword> unknown_keywords;           ///< one per name, by their first place; at most a thousand
  std::uint64_t more_unknown_keywords = 0;                ///< names beyond these
  std::map<std::string, std::uint64_t> skipped_keywords;  ///< name → blocks that were not used
  std::uint64_t skipped_bytes = 0;

  [[nodiscard]] const Part& part(PartIndex index) const { return parts[index.value]; }
  [[nodiscard]] const Contact& contact(ContactIndex index) const { return contacts[index.value]; }
  [[nodiscard]] bool rigid(PartIndex index) const;
  /// "line 40 of a.k"
  [[nodiscard]] std::string where(Place place) const;
  /// The path of a place's file; empty if there is none.
  [[nodiscard]] std::string file(Place place) const;
};

/// Builds the model from a deck's blocks. Unreadable input goes to `diagnostics` (an error there means exit code 2),
/// contradictions to Model::faults. The result is an error only if nothing can be read at all.
Result<Model> read_model(const keyword::Deck& deck, Diagnostics& diagnostics);

}  // namespace gapcheck::model
