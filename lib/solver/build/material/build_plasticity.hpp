#pragma once
#include <string>

#include "model/model.hpp"
#include "solver/material/material.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// Material 018: σ = K (ε₀ + ε̄)^N in pieces of 2 % of the strain, off by less than 1e-4; ε₀ by SIGY, or where K εᴺ
/// meets Hooke's line.
[[nodiscard]] SolverStatus set_power_law(const model::Material& material, Material& result);

/// What 081 and 123 add to 024: damage from EPPF to EPPFR; EPSTHIN, EPSMAJ and NUMINT. Contradictions are failures.
[[nodiscard]] SolverStatus set_own_failure(const model::Material& material, Material& result);

/// Which field of these is not calculated; empty: none.
[[nodiscard]] std::string plasticity_not_calculated(const model::Material& material);

}  // namespace gapcheck::solver
