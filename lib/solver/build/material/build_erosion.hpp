#pragma once
#include <optional>
#include <string>

#include "model/model.hpp"
#include "solver/material/erosion.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// The limits of a material's *MAT_ADD_EROSION; nothing if it has none. Limits that are met at rest or by any load, or
/// never, two definitions for one material, and curves are failures.
[[nodiscard]] SolverResult<std::optional<Erosion>> build_erosion(const model::Model& model,
                                                                 const model::Material& material);

/// Which field of it is not calculated; empty: none.
[[nodiscard]] std::string erosion_not_calculated(const model::Erosion& data);

}  // namespace gapcheck::solver
