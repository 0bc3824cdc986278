#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/condition/relaxation.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/force.hpp"
#include "solver/state/motion.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Shared by the functions that apply a deck's conditions to a structure: look-ups and the first failure.
class ConditionBuilder {
 public:
  ConditionBuilder(const model::Model& deck, Structure& target, std::vector<std::unique_ptr<Force>>& list,
                   Diagnostics& messages)
      : model(deck), structure(target), forces(list), diagnostics(messages), relaxing(relaxes(deck)) {}

  const model::Model& model;
  Structure& structure;
  std::vector<std::unique_ptr<Force>>& forces;
  Diagnostics& diagnostics;
  const bool relaxing;  ///< a dynamic relaxation comes before the run

  [[nodiscard]] bool failed() const { return !status_.ok(); }
  [[nodiscard]] const SolverStatus& status() const { return status_; }
  /// Keeps the first failure only. The message begins with the keyword.
  void fail(Failure::Kind kind, std::string_view keyword, model::Place place, std::string_view message);
  void warn(std::string_view keyword, model::Place place, std::string_view message);

  /// A node or the members of a set; empty after a failure.
  [[nodiscard]] std::vector<NodeIndex> nodes(const model::NodeChoice& choice, std::string_view keyword,
                                             model::Place place);
  [[nodiscard]] std::vector<PartIndex> part_set(std::int64_t id, std::string_view keyword, model::Place place);
  /// The rigid body of a part or nodal rigid body.
  [[nodiscard]] std::optional<std::size_t> body(std::int64_t id, std::string_view keyword, model::Place place);
  /// A curve over time in the model's unit of time; nullptr after a failure. Ordinates are as written.
  [[nodiscard]] std::shared_ptr<const TimeCurve> curve(std::int64_t id, std::string_view keyword, model::Place place);
  /// When a curve acts on what it scales or moves; a curve that is not defined: in the run.
  [[nodiscard]] Phases phases(std::int64_t curve) const;
  /// The axes of a local system, as columns; nothing after a failure.
  [[nodiscard]] std::optional<Matrix> system(std::int64_t id, std::string_view keyword, model::Place place);
  /// Lets the nodes' degrees of freedom have these axes. A failure names a node of a rigid body, or one that has
  /// constraints in other axes.
  void use_axes(const std::vector<NodeIndex>& nodes, const Matrix& axes, std::string_view keyword, model::Place place);
  /// A failure if one of the nodes has axes of its own.
  void refuse_axes(const std::vector<NodeIndex>& nodes, std::string_view keyword, model::Place place);
  /// A failure if a local system is named.
  void refuse_system(std::int64_t system, std::string_view keyword, model::Place place);

 private:
  std::map<std::int64_t, std::shared_ptr<const TimeCurve>> curves_;
  SolverStatus status_;
};

/// What the deck says about a rigid body besides its elements: constraints of the leading part's material, mass
/// properties of a part that no other part leads, or those of the nodal rigid body; by body.
struct BodyProperties {
  model::BodyConstraint constraint;
  const model::BodyInertia* inertia = nullptr;
  std::string_view keyword;
  model::Place place;
};
[[nodiscard]] std::vector<BodyProperties> body_properties(const model::Model& model, const Structure& structure);

/// Nodes of elements of all kinds that belong to the parts, each once, ascending; `wanted`: by part.
[[nodiscard]] std::vector<NodeIndex> nodes_of_parts(const model::Model& model, const std::vector<bool>& wanted);

// Each applies one kind of condition to the structure.
void apply_body_properties(ConditionBuilder& builder);
/// Joins rigid bodies. A failure names nodes that are in no rigid body or in the same, or that give no axis.
void apply_joints(ConditionBuilder& builder);
void apply_loads(ConditionBuilder& builder);
/// Adds the deck's airbags. A failure names a set, surface, curve or constant that cannot be used, or what is not
/// calculated of them.
void apply_airbags(ConditionBuilder& builder);
/// Lets degrees of freedom follow the equations of *CONSTRAINED_LINEAR_GLOBAL and _LOCAL, or each other
/// (*CONSTRAINED_NODE_SET). A failure names nodes that cannot, or what is not calculated together with them.
void apply_linear_constraints(ConditionBuilder& builder);
void apply_boundary(ConditionBuilder& builder);
void apply_prescribed_motions(ConditionBuilder& builder);
void apply_initial_velocities(ConditionBuilder& builder);
/// Gives the beams of *INITIAL_AXIAL_FORCE_BEAM their preload. A failure names a set, curve or KBEND that cannot be
/// used, a beam with two preloads, or one that is not integrated.
void apply_beam_preloads(ConditionBuilder& builder);
/// Gives shells and solids the stresses and plastic strains of *INITIAL_STRESS_SHELL, _SOLID and their sets. A failure
/// names cards that do not fit the element or its material, or what is not calculated of them.
void apply_initial_stresses(ConditionBuilder& builder);
/// Gives the solids of cross-sections the normal stress of *INITIAL_STRESS_SECTION. A failure names a section, curve,
/// set or vector that cannot be used, or what is not calculated.
void apply_section_preloads(ConditionBuilder& builder);

}  // namespace gapcheck::solver
