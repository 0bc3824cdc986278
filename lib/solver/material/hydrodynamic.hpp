#pragma once
#include <cstdint>
#include <limits>

#include "solver/material/equation_of_state.hpp"

namespace gapcheck::solver {

/// What happens in tension (keyword manual, volume II, SPALL).
enum class Spall : std::uint8_t {
  cutoff,     ///< 1: the pressure stays at the cutoff
  principal,  ///< 2: once the greatest principal stress reaches −PC there is neither deviator nor tension any more
  pressure,   ///< 3: the same once the pressure falls below PC
};

/// A material whose pressure comes from an equation of state.
struct Hydrodynamic {
  EquationOfState state;
  double shear = 0;                                          ///< G; 0: a fluid
  double bulk = 0;                                           ///< of the state at rest
  double viscosity = 0;                                      ///< μ of a fluid
  double cutoff = -std::numeric_limits<double>::infinity();  ///< least pressure, not above zero
  Spall spall = Spall::cutoff;
  /// Relative volumes at which it fails.
  double least_volume = 0, largest_volume = std::numeric_limits<double>::infinity();
};

}  // namespace gapcheck::solver
