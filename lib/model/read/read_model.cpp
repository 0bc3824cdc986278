#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "keyword/known_keywords.hpp"
#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

using Read = void (*)(Context&, const Block&, const Options&);

/// Things that refer to others are read after them, wherever they are in the deck.
enum class Phase : std::uint8_t { nodes, properties, parts, elements, boxes, sets, part_moves, moves, rest };
constexpr std::size_t phases = 9;

/// Keywords that change the geometry or the sets but are not read yet: skipping them silently would give wrong answers.
void warn_unread(Context& context, const Block& block, const Options&) {
  context.warning(Context::place(block, block.line),
                  fmt::format("*{} is not read; what it defines or changes takes no part in the checks", block.name));
}

struct KeywordFamily {
  std::string_view name;
  Phase phase;
  Read read;
  std::string_view options{};      ///< words that may follow the name; "*": any
  bool warn_about_others = false;  ///< whether the name with any other word deserves a warning
};

constexpr std::string_view set_options =
    "TITLE LIST GENERATE INCREMENT GENERAL COLUMN ADD ADVANCED INTERSECT COLLECT SMOOTH";

constexpr KeywordFamily keyword_families[] = {
    {"NODE", Phase::nodes, read_nodes},
    {"NODE_MERGE", Phase::rest, warn_unread, "*"},
    {"NODE_THICKNESS", Phase::rest, warn_unread, "*"},
    {"NODE_TRANSFORM", Phase::moves, read_node_transform, "", true},
    {"ELEMENT_SHELL", Phase::elements, read_shells, "THICKNESS BETA MCID OFFSET DOF COMPOSITE LONG SHL4 TO SHL8", true},
    {"ELEMENT_SHELL_SOURCE_SINK", Phase::rest, nullptr},
    {"ELEMENT_SOLID", Phase::elements, read_solids,
     "ORTHO DOF FORMAT2 H20 H27 H64 T15 T20 H8TOH20 H8TOH27 H8TOH64 T4TOT10 T4TOT15 TET4TOTET10", true},
    {"ELEMENT_TSHELL", Phase::elements, read_thick_shells, "BETA COMPOSITE", true},
    {"ELEMENT_BEAM", Phase::elements, read_beams, "THICKNESS SECTION PID OFFSET ORIENTATION SCALAR SCALR WARPAGE ELBOW",
     true},
    {"ELEMENT_BEAM_PULLEY", Phase::rest, nullptr},
    {"ELEMENT_BEAM_SOURCE", Phase::rest, nullptr},
    {"ELEMENT_DISCRETE", Phase::elements, read_discrete, "LCO"},
    {"ELEMENT_DISCRETE_SPHERE", Phase::rest, warn_unread, "*"},
    {"ELEMENT_GENERATE", Phase::rest, warn_unread, "*"},
    {"ELEMENT_MASS", Phase::elements, read_masses},
    {"ELEMENT_INERTIA", Phase::elements, read_inertias, "OFFSET"},
    {"ELEMENT_SPH", Phase::elements, read_particles, "VOLUME"},
    {"PART", Phase::parts, read_parts,
     "INERTIA REPOSITION CONTACT PRINT AVERAGED ATTACHMENT NODES FIELD COMPOSITE TSHELL LONG"},
    {"PART_COMPOSITE_IGA_SHELL", Phase::rest, warn_unread, "*"},
    {"PART_DUPLICATE", Phase::rest, warn_unread, "*"},
    {"PART_MOVE", Phase::part_moves, read_part_move, "", true},
    {"PART_STACKED_ELEMENTS", Phase::rest, warn_unread, "*"},
    {"DEFINE_ADAPTIVE_SOLID_TO_DES", Phase::properties, read_later_particles, "ID"},
    {"DEFINE_ADAPTIVE_SOLID_TO_SPH", Phase::properties, read_later_particles, "ID"},
    {"SECTION", Phase::properties, read_section_other, "*"},
    {"SECTION_SHELL", Phase::properties, read_section_shell, "TITLE MISC EFG THERMAL XFEM", true},
    {"SECTION_SOLID", Phase::properties, read_section_solid, "TITLE EFG MISC PERI SPG", true},
    {"SECTION_TSHELL", Phase::properties, read_section_thick_shell, "TITLE"},
    {"SECTION_BEAM", Phase::properties, read_section_beam, "TITLE"},
    {"SECTION_BEAM_AISC", Phase::properties, read_section_other, "*"},
    {"SECTION_DISCRETE", Phase::properties, read_section_discrete, "TITLE"},
    {"SECTION_SPH", Phase::properties, read_section_particle, "TITLE ELLIPSE USER INTERACTION"},
    {"MAT", Phase::properties, read_material, "*"},
    {"MAT_ADD", Phase::properties, nullptr, "*"},
    {"MAT_ADD_EROSION", Phase::properties, read_erosion, "TITLE"},
    {"MAT_THERMAL", Phase::properties, nullptr, "*"},
    {"EOS", Phase::properties, read_equation_of_state, "*"},
    {"DEFINE_CURVE", Phase::properties, read_curve, "TITLE"},
    {"DEFINE_CURVE_SMOOTH", Phase::properties, read_smooth_curve, "TITLE"},
    {"DEFINE_TABLE", Phase::properties, read_table, "TITLE 2D"},
    {"SET_NODE", Phase::sets, read_set, set_options, true},
    {"SET_PART", Phase::sets, read_set, set_options, true},
    {"SET_PART_TREE", Phase::sets, read_part_tree, "TITLE", true},
    {"SET_SEGMENT", Phase::sets, read_set, set_options, true},
    {"SET_SHELL", Phase::sets, read_set, set_options, true},
    {"SET_SOLID", Phase::sets, read_set, set_options, true},
    {"SET_TSHELL", Phase::sets, read_set, set_options, true},
    {"SET_BEAM", Phase::sets, read_set, set_options, true},
    {"SET_DISCRETE", Phase::sets, read_set, set_options, true},
    {"DEFINE_BOX", Phase::boxes, read_box, "TITLE LOCAL"},
    {"CONSTRAINED_NODAL_RIGID_BODY", Phase::rest, read_nodal_rigid_body, "TITLE SPC INERTIA OVERRIDE THERMAL"},
    {"CONSTRAINED_EXTRA_NODES", Phase::rest, read_extra_nodes, "NODE SET"},
    {"CONSTRAINED_RIGID_BODIES", Phase::rest, read_rigid_bodies, "SET"},
    {"BOUNDARY_SPC_NODE", Phase::rest, read_spc, "ID BIRTH DEATH"},
    {"BOUNDARY_SPC_SET", Phase::rest, read_spc, "ID BIRTH DEATH"},
    {"BOUNDARY_PRESCRIBED_MOTION_NODE", Phase::rest, read_prescribed_motion, "ID"},
    {"BOUNDARY_PRESCRIBED_MOTION_SET", Phase::rest, read_prescribed_motion, "ID"},
    {"BOUNDARY_PRESCRIBED_MOTION_RIGID", Phase::rest, read_prescribed_motion, "ID"},
    {"DEFINE_VECTOR", Phase::rest, read_vector, "TITLE"},
    {"INITIAL_VELOCITY", Phase::rest, read_initial_velocity},
    {"INITIAL_VELOCITY_NODE", Phase::rest, read_initial_velocity_node},
    {"INITIAL_VELOCITY_GENERATION", Phase::rest, read_initial_velocity_generation},
    {"INITIAL_VELOCITY_RIGID_BODY", Phase::rest, read_initial_velocity_rigid_body},
    {"INITIAL_AXIAL_FORCE_BEAM", Phase::rest, read_beam_preload},
    {"INITIAL_STRESS_SHELL", Phase::rest, read_initial_stress_shell, "SET"},
    {"INITIAL_STRESS_SOLID", Phase::rest, read_initial_stress_solid, "SET"},
    {"INITIAL_STRESS_SECTION", Phase::rest, read_section_preload},
    {"DATABASE_CROSS_SECTION_PLANE", Phase::rest, read_cross_section, "ID"},
    {"DATABASE_CROSS_SECTION_SET", Phase::rest, read_cross_section, "ID"},
    {"CONSTRAINED_SPOTWELD", Phase::rest, read_spot_weld, "ID FILTERED FORCE"},
    {"CONSTRAINED_GENERALIZED_WELD_SPOT", Phase::rest, read_generalized_weld, "ID"},
    {"CONSTRAINED_LINEAR_GLOBAL", Phase::rest, read_linear_constraint},
    {"CONSTRAINED_LINEAR_LOCAL", Phase::rest, read_linear_constraint},
    {"CONSTRAINED_NODE_SET", Phase::rest, read_joined_set, "ID"},
    {"CONSTRAINED_INTERPOLATION", Phase::rest, read_interpolation, "LOCAL"},
    {"CONSTRAINED_JOINT", Phase::rest, read_joint, "SPHERICAL REVOLUTE CYLINDRICAL PLANAR UNIVERSAL TRANSLATIONAL ID"},
    {"LOAD_NODE_POINT", Phase::rest, read_concentrated_load},
    {"LOAD_NODE_SET", Phase::rest, read_concentrated_load},
    {"LOAD_RIGID_BODY", Phase::rest, read_concentrated_load},
    {"LOAD_SEGMENT", Phase::rest, read_segment_load, "ID"},
    {"LOAD_SEGMENT_SET", Phase::rest, read_segment_load, "ID"},
    {"LOAD_SHELL_ELEMENT", Phase::rest, read_shell_load, "ID"},
    {"LOAD_SHELL_SET", Phase::rest, read_shell_load, "ID"},
    {"AIRBAG_SIMPLE_PRESSURE_VOLUME", Phase::rest, read_airbag, "ID"},
    {"AIRBAG_SIMPLE_AIRBAG_MODEL", Phase::rest, read_airbag, "ID"},
    {"LOAD_BODY_X", Phase::rest, read_body_load},
    {"LOAD_BODY_Y", Phase::rest, read_body_load},
    {"LOAD_BODY_Z", Phase::rest, read_body_load},
    {"LOAD_BODY_RX", Phase::rest, read_body_load},
    {"LOAD_BODY_RY", Phase::rest, read_body_load},
    {"LOAD_BODY_RZ", Phase::rest, read_body_load},
    {"LOAD_BODY_VECTOR", Phase::rest, read_body_load},
    {"LOAD_BODY_PARTS", Phase::rest, read_body_load_parts},
    {"DAMPING_PART_MASS", Phase::rest, read_part_damping, "SET"},
    {"DAMPING_GLOBAL", Phase::rest, read_global_damping},
    {"DAMPING_RELATIVE", Phase::rest, read_relative_damping},
    {"HOURGLASS", Phase::properties, read_hourglass, "TITLE"},
    {"INTEGRATION_SHELL", Phase::properties, read_integration_shell},
    {"CONTROL_HOURGLASS", Phase::rest, read_control_hourglass},
    {"CONTROL_BULK_VISCOSITY", Phase::rest, read_control_bulk_viscosity},
    {"CONTROL_ACCURACY", Phase::rest, read_control_accuracy},
    {"RIGIDWALL_PLANAR", Phase::rest, read_rigid_wall, "ID ORTHO FINITE MOVING FORCES DISPLAY", true},
    {"RIGIDWALL_GEOMETRIC", Phase::rest, read_rigid_wall, "FLAT PRISM CYLINDER SPHERE INTERIOR MOTION DISPLAY ID",
     true},
    {"CONTROL_CONTACT", Phase::rest, read_control_contact},
    {"CONTROL_SHELL", Phase::rest, read_control_shell},
    {"CONTROL_SOLID", Phase::rest, read_control_solid},
    {"CONTROL_SOLUTION", Phase::rest, read_control_solution},
    {"CONTROL_DYNAMIC_RELAXATION", Phase::rest, read_control_relaxation},
    {"CONTROL_TIMESTEP", Phase::rest, read_control_timestep},
    {"CONTROL_TERMINATION", Phase::rest, read_control_termination},
    {"CONTROL_UNITS", Phase::rest, read_control_units},
    {"TITLE", Phase::rest, read_title},
    {"DATABASE_BINARY_D3PLOT", Phase::rest, read_database},
    {"DATABASE_GLSTAT", Phase::rest, read_database},
    {"DATABASE_MATSUM", Phase::rest, read_database},
    {"DATABASE_NODOUT", Phase::rest, read_database},
    {"DATABASE_NODOUT_HF", Phase::rest, read_unwritten_database},
    {"DATABASE_RCFORC", Phase::rest, read_database},
    {"DATABASE_SLEOUT", Phase::rest, read_database},
    {"DATABASE_NCFORC", Phase::rest, read_database},
    {"DATABASE_ABSTAT", Phase::rest, read_database},
    {"DATABASE_BNDOUT", Phase::rest, read_database},
    {"DATABASE_DEFORC", Phase::rest, read_database},
    {"DATABASE_DISBOUT", Phase::rest, read_unwritten_database},
    {"DATABASE_ELOUT", Phase::rest, read_database},
    {"DATABASE_JNTFORC", Phase::rest, read_database},
    {"DATABASE_NODFOR", Phase::rest, read_unwritten_database},
    {"DATABASE_RBDOUT", Phase::rest, read_database},
    {"DATABASE_RWFORC", Phase::rest, read_database},
    {"DATABASE_SBTOUT", Phase::rest, read_unwritten_database},
    {"DATABASE_SECFORC", Phase::rest, read_database, "FILTER"},
    {"DATABASE_SPCFORC", Phase::rest, read_database},
    {"DATABASE_SPHOUT", Phase::rest, read_unwritten_database},
    {"DATABASE_SSSTAT", Phase::rest, read_unwritten_database},
    {"DATABASE_SWFORC", Phase::rest, read_database},
    {"DATABASE_TPRINT", Phase::rest, read_unwritten_database},
    {"DATABASE_BINARY_D3THDT", Phase::rest, read_unwritten_database},
    {"DATABASE_BINARY_INTFOR", Phase::rest, read_intfor, "FILE"},
    {"DATABASE_EXTENT_INTFOR", Phase::rest, read_intfor_values},
    {"DATABASE_HISTORY_NODE", Phase::rest, read_history_nodes, "ID SET LOCAL"},
    {"DATABASE_HISTORY_SOLID", Phase::rest, read_history_elements, "ID SET"},
    {"DATABASE_HISTORY_BEAM", Phase::rest, read_history_elements, "ID SET"},
    {"DATABASE_HISTORY_SHELL", Phase::rest, read_history_elements, "ID SET"},
    {"DATABASE_HISTORY_TSHELL", Phase::rest, read_unwritten_history, "ID SET"},
    {"CONTROL_OUTPUT", Phase::rest, read_control_output},
    {"DEFINE_FRICTION", Phase::rest, read_friction_table, "TITLE"},
    {"CONTACT", Phase::rest, read_contact, "*"},
};

/// What is done with one keyword's name.
struct Plan {
  Read read = nullptr;  ///< nullptr: skipped
  Phase phase = Phase::rest;
  Options options = {};
  keyword::Standing standing = keyword::Standing::known;
  std::size_t unknown = 0;  ///< position in Model::unknown_keywords, if the name is not known and there is room
};

bool contains_word(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const std::size_t cut = std::min(words.find(' '), words.size());
    if (words.substr(0, cut) == word) return true;
    words.remove_prefix(std::min(cut + 1, words.size()));
  }
  return false;
}

/// The family with the longest name that the keyword begins with, and the words after it.
Plan plan_for(std::string_view name) {
  const KeywordFamily* family = nullptr;
  for (const KeywordFamily& candidate : keyword_families) {
    const bool matches = name.starts_with(candidate.name) &&
                         (name.size() == candidate.name.size() || name[candidate.name.size()] == '_');
    if (matches && (family == nullptr || candidate.name.size() > family->name.size())) family = &candidate;
  }
  if (family == nullptr || family->read == nullptr) return {};
  Plan plan;
  plan.read = family->read;
  plan.phase = family->phase;
  std::string_view rest = name.substr(family->name.size());
  while (!rest.empty()) {
    rest.remove_prefix(1);
    const std::size_t cut = std::min(rest.find('_'), rest.size());
    const std::string_view word = rest.substr(0, cut);
    if (family->options != "*" && !contains_word(family->options, word))
      return family->warn_about_others ? Plan{warn_unread, Phase::rest, {}} : Plan{};
    plan.options.words.push_back(word);
    rest.remove_prefix(cut);
  }
  return plan;
}

/// The plan for a name, and an entry among the unknown keywords if it is none of the manual's.
Plan plan_for_new(const Block& block, Model& model) {
  Plan plan = plan_for(block.name);
  if (block.name.empty()) return plan;  // an error of its own
  plan.standing = keyword::standing_of(block.name);
  if (plan.standing == keyword::Standing::known) return plan;
  // What is said of the unknown name says the same.
  if (plan.read == warn_unread) plan.read = nullptr;
  plan.unknown = model.unknown_keywords.size();
  if (plan.unknown >= most_unknown_keywords)
    ++model.more_unknown_keywords;
  else
    model.unknown_keywords.push_back({block.name, Context::place(block, block.line), 0, plan.read != nullptr});
  return plan;
}

void count_unknown(const Plan& plan, Model& model) {
  if (plan.standing != keyword::Standing::known && plan.unknown < model.unknown_keywords.size())
    ++model.unknown_keywords[plan.unknown].count;
}

void skip_block(const Block& block, Model& model) {
  ++model.skipped_keywords[block.name];
  model.skipped_bytes += block.body.size();
}

void read_blocks(Context& context) {
  std::unordered_map<std::string_view, Plan> plans;
  struct PlannedBlock {
    const Block* block;
    const Plan* plan;
  };
  std::array<std::vector<PlannedBlock>, phases> planned;
  for (const Block& block : context.deck.blocks()) {
    const auto [entry, is_new] = plans.try_emplace(block.name);
    if (is_new) entry->second = plan_for_new(block, context.model);
    const Plan& plan = entry->second;
    count_unknown(plan, context.model);
    if (plan.read == nullptr || plan.read == warn_unread) skip_block(block, context.model);
    if (plan.read != nullptr) planned[static_cast<std::size_t>(plan.phase)].push_back({&block, &plan});
  }
  const auto run = [&](Phase phase) {
    for (const PlannedBlock& next : planned[static_cast<std::size_t>(phase)])
      next.plan->read(context, *next.block, next.plan->options);
  };
  run(Phase::nodes);
  finish_nodes(context);
  run(Phase::properties);
  run(Phase::parts);
  finish_parts(context);
  finish_equations_of_state(context);
  run(Phase::elements);
  finish_elements(context);
  run(Phase::boxes);
  run(Phase::sets);
  resolve_sets(context);
  run(Phase::part_moves);
  finish_part_moves(context);
  run(Phase::moves);
  finish_node_transforms(context);
  run(Phase::rest);
  finish_sections(context);
  for (const PlannedBlock& next : planned[static_cast<std::size_t>(Phase::nodes)])
    read_node_constraints(context, *next.block);
  finish_foams(context);
  finish_contacts(context);
}

void sort_faults(std::vector<Fault>& faults) {
  const auto key = [](const Fault& fault) { return std::tuple(fault.kind, fault.place.file, fault.place.line); };
  std::stable_sort(faults.begin(), faults.end(), [&](const Fault& a, const Fault& b) { return key(a) < key(b); });
}

}  // namespace

Result<Model> read_model(const keyword::Deck& deck, Diagnostics& diagnostics) {
  Model model;
  for (const keyword::SourceFile& file : deck.files()) model.files.push_back(file.path);
  Context context{deck, diagnostics, model, {}, {}, {}, 0};
  read_blocks(context);
  sort_faults(model.faults);
  keyword::warn_of_unused_parameters(deck, diagnostics);
  return {std::move(model)};
}

}  // namespace gapcheck::model
