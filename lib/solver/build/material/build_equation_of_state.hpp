#pragma once
#include <string>

#include "model/model.hpp"
#include "solver/material/material.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// What material 010 says besides its equation of state, which add_equation_of_state() adds.
[[nodiscard]] SolverResult<Hydrodynamic> build_hydro(const model::Material& material);

/// Gives a solid's material the equation of state of its part; 009 becomes a fluid by it. Nothing for materials that
/// use none. A missing or unreadable equation of state, one without stiffness at rest, a table that is not in order and
/// cutoffs above zero are failures.
[[nodiscard]] SolverStatus add_equation_of_state(const model::Model& model, const model::Part& part,
                                                 Material& material);

/// What of an equation of state is not calculated; empty: all is.
[[nodiscard]] std::string state_not_calculated(const model::EquationOfState& state);
/// The same of material 010.
[[nodiscard]] std::string hydro_not_calculated(const model::Hydro& data);

}  // namespace gapcheck::solver
