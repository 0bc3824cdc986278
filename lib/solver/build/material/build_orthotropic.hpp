#pragma once
#include <array>
#include <string>

#include "model/model.hpp"
#include "solver/material/material.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// Materials 002 and 034 in shells. Moduli that are no positive energy are failures.
[[nodiscard]] SolverStatus set_orthotropic(const model::Material& material, Material& result);

/// Which field is not calculated; empty: none.
[[nodiscard]] std::string orthotropic_not_calculated(const model::Orthotropic& data);

/// The angle from a shell's x axis to the material's axis a by AOPT 0, 2 and 3; `axes`: of the shell, as columns.
/// Nothing where the vectors of the card give no direction in its plane.
[[nodiscard]] std::optional<double> material_angle(const model::Orthotropic& data, const Matrix& axes);

/// Turns the material of the shell that was added last.
[[nodiscard]] SolverStatus turn_material(const model::Material& material, const Matrix& axes, double& angle);

}  // namespace gapcheck::solver
