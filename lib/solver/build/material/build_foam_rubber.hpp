#pragma once
#include <string>

#include "model/model.hpp"
#include "solver/material/material.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// Materials 006, 007, 057, 063, 077 and 181. Curves that are missing or do not pass through the origin, and constants
/// without stiffness at rest, are failures.
[[nodiscard]] SolverStatus set_foam_rubber(const model::Model& model, const model::Material& material,
                                           Material& result);

/// Foams with BVFLAG = 0 have none.
[[nodiscard]] inline bool has_bulk_viscosity(const Material& material) {
  return !material.finite || material.finite->bulk_viscosity;
}

/// Which field of such a material is not calculated; empty: none.
[[nodiscard]] std::string foam_rubber_not_calculated(const model::Model& model, const model::Material& material);

}  // namespace gapcheck::solver
