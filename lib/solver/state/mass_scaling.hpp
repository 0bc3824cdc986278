#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/contact/contact.hpp"
#include "solver/state/state.hpp"
#include "solver/state/summary.hpp"

namespace gapcheck::solver {

/// Mass scaling of *CONTROL_TIMESTEP: DT2MS below zero adds mass to elements whose initial step is too small until it
/// is |DT2MS| TSSFAC; above zero all elements get that step. During the run elements whose step falls below it get more
/// mass, unless MS1ST says otherwise; none loses it (Keyword User's Manual, Vol. I, *CONTROL_TIMESTEP).
struct MassScaling {
  double step = 0;         ///< target for the elements; 0: no scaling
  bool all = false;        ///< also elements with a longer step
  double step_factor = 1;  ///< TSSFAC, on the manual's element step

  MassScaling() = default;
  explicit MassScaling(const model::Controls& controls)
      : step(std::abs(controls.dt2ms) * controls.tssfac), all(controls.dt2ms > 0), step_factor(controls.tssfac) {}

  /// The step of an element, from the manual's and the bound of its frequency.
  [[nodiscard]] double own(double manual_step, double stable_step) const {
    return std::min(step_factor * manual_step, stable_step / step_slack);
  }
  /// Factor on the mass of an element with this step during the run.
  [[nodiscard]] double growth(double own_step) const {
    constexpr double rounding = 1e-9;
    return own_step > 0 && own_step < (1 - rounding) * step ? step / own_step * (step / own_step) : 1;
  }
  /// Factor on an element's own mass, from its steps: the manual's and the bound of its frequency.
  [[nodiscard]] double factor(double manual_step, double stable_step) const {
    const double present = own(manual_step, stable_step);
    if (!(step > 0) || !(present > 0) || (!all && present >= step)) return 1;
    return step / present * (step / present);
  }
};

/// What mass scaling has added in a cycle. Nodes keep their velocity: `energy` is ½ m v² of the new mass.
struct AddedMass {
  double mass = 0, energy = 0;
  std::uint64_t elements = 0;
  /// Nodes of rigid bodies get none.
  void give(State& state, std::uint32_t node, double more, double inertia) {
    if (state.in_body(node)) return;
    state.mass[node] += more;
    state.inertia[node] += inertia;
    mass += more;
    energy += more / 2 * state.v[node].squaredNorm() + inertia / 2 * state.w[node].squaredNorm();
  }
  void add(const AddedMass& other) {
    mass += other.mass;
    energy += other.energy;
    elements += other.elements;
  }
};

/// The elements of a kind whose steps are watched.
struct WatchedSteps {
  MassScaling scaling;
  std::vector<double> step;  ///< by element, at the last evaluation; empty: they are not watched
  std::vector<double> mass;  ///< by element
  void start(const MassScaling& wanted, std::size_t elements) {
    scaling = wanted;
    step.assign(elements, std::numeric_limits<double>::infinity());
    mass.assign(elements, 0);
  }
  void note(std::size_t element, double manual_step, double stable_step) {
    if (!step.empty()) step[element] = scaling.own(manual_step, stable_step);
  }
  /// Calls grow(element, factor) for those whose step is too small; one after the other.
  template <class Grow>
  void grow_where_needed(const Grow& grow) {
    for (std::size_t i = 0; i < step.size(); ++i)
      if (const double factor = scaling.growth(step[i]); factor > 1 && mass[i] > 0) {
        grow(i, factor);
        mass[i] *= factor;
      }
  }
};

}  // namespace gapcheck::solver
