#pragma once
#include <string>

#include "model/model.hpp"
#include "solver/material/material.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// Materials 015 and 098: yield stress, heating and failure. Constants with which it would yield at rest, melt at room
/// temperature or fail without flow are failures.
[[nodiscard]] SolverStatus set_johnson_cook(const model::Material& material, Material& result);

/// What 015 adds in solids, besides the equation of state: G, PC and SPALL.
[[nodiscard]] SolverResult<Hydrodynamic> build_johnson_cook_hydro(const model::Material& material);

/// In shells it needs E and has no limit of tension.
[[nodiscard]] SolverStatus check_johnson_cook_shell(const model::Material& material);

/// Which field is not calculated; empty: none.
[[nodiscard]] std::string johnson_cook_not_calculated(const model::JohnsonCook& data);

}  // namespace gapcheck::solver
