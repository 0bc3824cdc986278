#include <algorithm>
#include <cmath>

#include "solver/discrete/discrete_beam.hpp"

namespace gapcheck::solver {
namespace {

double cable_stiffness(const Cable& cable, const DiscreteState& state) {
  if (cable.stiffness > 0) return cable.stiffness;
  return cable.young * cable.area / state.unstressed;
}

double tension(const Cable& cable, const DiscreteState& state, double length) {
  const double longer = length - state.reference;
  const double more = cable.stress.empty() ? cable_stiffness(cable, state) * longer
                                           : cable.area * cable.stress.at(longer / state.unstressed);
  return std::max(state.base + more, 0.0);
}

double cable_energy(const Cable& cable, const DiscreteState& state, double length) {
  if (cable.stress.empty()) {
    const double stiffness = cable_stiffness(cable, state), force = tension(cable, state, length);
    return stiffness > 0 ? force * force / (2 * stiffness) : force * (length - state.unstressed);
  }
  const double longer = (length - state.reference) / state.unstressed;
  return state.unstressed * cable.stress.integral_above_zero(longer, state.base, cable.area);
}

double step_of(const Cable& cable, const DiscreteState& state, double force, double length) {
  const double slope =
      cable.stress.empty() ? cable_stiffness(cable, state) : cable.area * cable.stress.steepest() / state.unstressed;
  const double stiffest = std::max(slope, force / length);  // across it moves like a string
  return stiffest > 0 ? std::sqrt(state.mass / stiffest) : std::numeric_limits<double>::infinity();
}

}  // namespace

DiscreteForces cable_forces(const Cable& cable, const BeamEnds& ends, double time, double dt, DiscreteState& state) {
  DiscreteForces out;
  const Vector way = ends.x[1] - ends.x[0], rate = ends.v[1] - ends.v[0];
  const double length = way.norm();
  if (!(length > 0) || !std::isfinite(length) || !(state.unstressed > 0)) return out;
  const double until = cable.end > 0 ? std::max(cable.end, cable.start + cable.ramp) : 0;
  if (time < until) {
    const double before = (way - dt * rate).norm(), stored = cable_energy(cable, state, before);
    const double force = tension(cable, state, before);
    state.base = time < cable.start ? 0 : cable.force;
    if (cable.ramp > 0) state.base *= std::clamp((time - cable.start) / cable.ramp, 0.0, 1.0);
    state.reference = length;
    out.supplied = cable_energy(cable, state, length) - stored - (force + state.base) / 2 * (length - before);
  }
  const double force = tension(cable, state, length);
  out.force[1] = force / length * way;
  out.force[0] = -out.force[1];
  out.axial = force;
  out.step = step_of(cable, state, force, length);
  const double strain = length / state.unstressed - 1;
  out.failed = (cable.failure_strain > 0 && strain >= cable.failure_strain) ||
               (cable.failure_force > 0 && force >= cable.failure_force);
  out.good = std::isfinite(force);
  return out;
}

double stored_energy(const DiscreteBeam& beam, const DiscreteState& state, double length) {
  if (beam.cable) return cable_energy(*beam.cable, state, length) - state.stored_at_start;
  double energy = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const DiscreteLaw& law = beam.laws[i];
    const double way = state.way[i];
    energy += law.preload * way + law.force.integral(way);
    if (law.stiffness > 0)
      energy +=
          law.yield.empty() ? law.stiffness / 2 * way * way : state.elastic[i] * state.elastic[i] / (2 * law.stiffness);
  }
  return energy;
}

}  // namespace gapcheck::solver
