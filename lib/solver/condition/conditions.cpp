#include "solver/condition/conditions.hpp"

#include "solver/condition/condition_builder.hpp"

namespace gapcheck::solver {

SolverStatus apply_conditions(const model::Model& model, Structure& structure,
                              std::vector<std::unique_ptr<Force>>& forces, Diagnostics& diagnostics) {
  ConditionBuilder builder(model, structure, forces, diagnostics);
  // Motions that begin with an acceleration start from the initial velocities.
  for (const auto apply : {apply_body_properties, apply_boundary, apply_initial_velocities, apply_prescribed_motions,
                           apply_joints, apply_loads, apply_airbags, apply_beam_preloads, apply_initial_stresses,
                           apply_section_preloads, apply_linear_constraints}) {
    apply(builder);
    if (builder.failed()) return builder.status();
  }
  structure.rigid.start(structure.state);
  return {};
}

}  // namespace gapcheck::solver
