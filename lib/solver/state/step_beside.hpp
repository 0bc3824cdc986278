#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// What bounds the step of a force from above: the square of its highest frequency and the greatest rate of damping.
struct ForceRates {
  double squared_frequency = 0, damping = 0;

  /// Central differences with velocities half a step behind are stable for ω² dt² + 2 c dt <= 4; `room`: what elements
  /// leave of the four.
  [[nodiscard]] double step_in(double room) const {
    return room / (damping + std::sqrt(damping * damping + room * squared_frequency));
  }
};

/// The longest stable step of a force at the nodes of elements. A force that fits beside the elements' own step leaves
/// it alone; others bring the elements to 0.9 of their critical step, or below it.
[[nodiscard]] inline double step_beside(const State& state, const ForceRates& rates) {
  const double usual = rates.step_in(4 - usual_share);
  if (state.elements_share <= usual_share) return usual;
  if (rates.step_in(4 - state.elements_share) >= state.coming) return std::numeric_limits<double>::infinity();
  return std::min(usual, state.coming * std::sqrt(usual_share / state.elements_share));
}

}  // namespace gapcheck::solver
