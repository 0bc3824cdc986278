#pragma once
#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/element/hourglass.hpp"

namespace gapcheck::solver {

/// Hourglass control and bulk viscosity of a part's elements.
struct ElementControl {
  Hourglass hourglass;
  double quadratic_viscosity = 1.5, linear_viscosity = 0.06;
};

enum class ElementFamily : std::uint8_t { shells, solids };

/// What *HOURGLASS says for the part (HGID), otherwise *CONTROL_HOURGLASS, otherwise `otherwise`. IHQ 1 to 3 are
/// viscous, 4 and 5 stiffness. 6 and 7 are those of shells too; in solids they are assumed strains. 8 and above are
/// calculated as the last of these, with a warning. Zero is the solver's default, viscous with a coefficient of 0.1.
/// QB is QM where it is not given, QW is QB. An undefined HGID is a warning.
[[nodiscard]] ElementControl element_control(const model::Model& model, const model::Part& part, ElementFamily family,
                                             Hourglass otherwise, Diagnostics& diagnostics);

}  // namespace gapcheck::solver
