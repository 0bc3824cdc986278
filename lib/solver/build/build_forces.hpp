#pragma once
#include <memory>
#include <vector>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/force.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Adds the rigid walls, springs and dampers of a deck to the forces. Call it when the structure has all its masses and
/// constraints. What is not calculated is reported in `diagnostics`; springs without a supported material are a
/// failure.
[[nodiscard]] SolverStatus add_walls_and_springs(const model::Model& model, const Structure& structure,
                                                 std::vector<std::unique_ptr<Force>>& forces, Diagnostics& diagnostics);

}  // namespace gapcheck::solver
