#pragma once
#include <string>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/condition/spring_law.hpp"
#include "solver/state/failure.hpp"

namespace gapcheck::solver {

/// Why a spring or damper of this material is not calculated as its card says; empty if it is.
[[nodiscard]] std::string spring_not_calculated(const model::Material& material);

/// The law of a spring or damper. Another material, constants out of range and curves that are missing or do not have
/// the shape that the law asks for are failures; the curve over the rate of S04 is left out with a warning.
[[nodiscard]] SolverResult<SpringLaw> build_spring_law(const model::Model& model, const model::Material& material,
                                                       bool torsional, Diagnostics& diagnostics);

}  // namespace gapcheck::solver
