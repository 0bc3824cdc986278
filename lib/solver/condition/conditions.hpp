#pragma once
#include <memory>
#include <vector>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/force.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Applies the deck's boundary conditions, initial velocities, prescribed motions, loads and damping to a structure
/// that build_structure() made from the same model; forces are appended to the existing ones. Contradictions,
/// references to missing things and unsupported kinds are failures with keyword, file and line; conditions that are
/// allowed but have no effect are warnings.
[[nodiscard]] SolverStatus apply_conditions(const model::Model& model, Structure& structure,
                                            std::vector<std::unique_ptr<Force>>& forces, Diagnostics& diagnostics);

}  // namespace gapcheck::solver
