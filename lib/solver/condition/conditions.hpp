#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/force.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Puts the deck's boundary conditions, initial velocities, prescribed motions, loads and damping on a structure that
/// build_structure() made of the same model; forces go behind those that are there. What contradicts itself, names
/// things that are not there or is of a kind that is not calculated is a failure with keyword, file and line; what is
/// allowed but has no effect is a warning.
[[nodiscard]] std::optional<Failure> apply_conditions(const model::Model& model, Structure& structure,
                                                      std::vector<std::unique_ptr<Force>>& forces,
                                                      Diagnostics& diagnostics);

}  // namespace gapcheck::solver
