#pragma once
#include <algorithm>
#include <cmath>

#include "model/contact/contact.hpp"
#include "solver/state/summary.hpp"

namespace gapcheck::solver {

/// Mass scaling of *CONTROL_TIMESTEP: DT2MS below zero adds mass to elements whose initial step is too small until it
/// is |DT2MS| TSSFAC; above zero all elements get that step. Later in the run no more mass is added.
struct MassScaling {
  double step = 0;         ///< target for the elements; 0: no scaling
  bool all = false;        ///< also elements with a longer step
  double step_factor = 1;  ///< TSSFAC, on the manual's element step

  MassScaling() = default;
  explicit MassScaling(const model::Controls& controls)
      : step(std::abs(controls.dt2ms) * controls.tssfac), all(controls.dt2ms > 0), step_factor(controls.tssfac) {}

  /// Factor on an element's own mass, from its steps: the manual's and the bound of its frequency.
  [[nodiscard]] double factor(double manual_step, double stable_step) const {
    const double own = std::min(step_factor * manual_step, stable_step / step_slack);
    if (!(step > 0) || !(own > 0) || (!all && own >= step)) return 1;
    return step / own * (step / own);
  }
};

}  // namespace gapcheck::solver
