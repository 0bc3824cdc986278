#include "solver/discrete/discrete_beam.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// Turns axes so that r lies along a line.
void align(const Vector& line, Matrix& axes) {
  const double length = line.norm();
  if (!(length > 0)) return;
  axes = Eigen::Quaterniond::FromTwoVectors(Vector(axes.col(0)), line / length).toRotationMatrix() * axes;
}

Vector spin_of_axes(const DiscreteBeam& beam, const BeamEnds& ends, const Matrix& axes) {
  Vector spin = beam.scoor < 0 ? ends.w[0] : beam.scoor > 0 ? ends.w[1] : Vector((ends.w[0] + ends.w[1]) / 2);
  for (int i = 0; i < 3; ++i)
    if (beam.fixed[static_cast<std::size_t>(i)]) spin -= spin.dot(axes.col(i)) * axes.col(i);
  return spin;
}

/// Forces and what they have dissipated, of one degree of freedom.
struct Pull {
  double force = 0, dissipated = 0;
};

Pull pull_of(const DiscreteLaw& law, std::size_t i, double rate, double dt, DiscreteState& state) {
  Pull pull;
  const double change = dt * rate;
  state.way[i] += change;
  if (law.yield.empty()) {
    pull.force = law.stiffness * state.way[i];
  } else {
    double& held = state.elastic[i];
    const double before = held;
    held += law.stiffness * change;
    if (const double size = std::abs(held); size > law.yield.stress(state.plastic_way[i])) {
      const double flow = law.yield.solve(size, law.stiffness, state.plastic_way[i], 1).increment;
      const double sign = held > 0 ? 1 : -1;
      state.plastic_way[i] += flow;
      held -= sign * law.stiffness * flow;
      pull.dissipated = sign * flow * (before + held) / 2;
    }
    pull.force = held;
  }
  const double damped = law.damping * rate + law.viscous.at(rate);
  pull.dissipated += change * (damped + state.damped[i]) / 2;
  state.damped[i] = damped;
  pull.force += law.force.at(state.way[i]) + law.preload + damped;
  return pull;
}

/// The stable step of masses m / 2 and inertias I / 2 at the ends: rates of the six ways are B (v, ω), and B M⁻¹ Bᵀ has
/// the entries 4 / m δᵢⱼ + (d² δᵢⱼ − dᵢ dⱼ) / I of translations, the second with couples only, and 4 / I of rotations.
double stable_step(const DiscreteBeam& beam, const DiscreteState& state, const Vector& way) {
  const Vector d = beam.couples() ? Vector(state.axes.transpose() * way) : Vector(Vector::Zero());
  const auto mobility = [&](int i, int j) {
    const double turning = state.inertia > 0 ? ((i == j ? d.squaredNorm() : 0) - d[i] * d[j]) / state.inertia : 0;
    return (i == j && state.mass > 0 ? 4 / state.mass : 0) + turning;
  };
  const auto bound = [&](const auto& of) {
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      double row = 0;
      for (int j = 0; j < 3; ++j)
        row += std::abs(mobility(i, j)) *
               std::sqrt(of(beam.laws[static_cast<std::size_t>(i)]) * of(beam.laws[static_cast<std::size_t>(j)]));
      most = std::max(most, row);
      if (state.inertia > 0) most = std::max(most, 4 / state.inertia * of(beam.laws[static_cast<std::size_t>(i + 3)]));
    }
    return most;
  };
  const double squared = bound([](const DiscreteLaw& law) { return law.largest_stiffness(); });
  // Rates are half a step old: ω² dt² + 2 c dt <= 4.
  const double damping = bound([](const DiscreteLaw& law) { return law.largest_damping(); });
  const double sum = damping + std::sqrt(damping * damping + 4 * squared);
  return sum > 0 ? 4 / sum : std::numeric_limits<double>::infinity();
}

bool fails(const DiscreteBeam& beam, const std::array<double, 6>& force, const std::array<double, 6>& way) {
  double by_force = 0, by_way = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    if (beam.failure_force[i] > 0) by_force += std::pow(force[i] / beam.failure_force[i], 2);
    if (beam.failure_way[i] > 0) by_way += std::pow(way[i] / beam.failure_way[i], 2);
  }
  return by_force >= 1 || by_way >= 1;
}

}  // namespace

bool DiscreteBeam::can_fail() const {
  if (cable) return cable->failure_strain > 0 || cable->failure_force > 0;
  return std::any_of(failure_force.begin(), failure_force.end(), [](double limit) { return limit > 0; }) ||
         std::any_of(failure_way.begin(), failure_way.end(), [](double limit) { return limit > 0; });
}

Matrix discrete_axes(const DiscreteBeam& beam, const Matrix* axes, const Vector& way, const Vector& third) {
  Matrix result = Matrix::Identity();
  const Vector across = way.cross(third);
  if (axes != nullptr) {
    result = *axes;
  } else if (way.norm() > 0 && across.norm() > 1e-9 * way.norm() * third.norm()) {
    result.col(0) = way.normalized();
    result.col(2) = across.normalized();
    result.col(1) = result.col(2).cross(result.col(0));
  }
  if (beam.follows_line()) align(way, result);
  return result;
}

void begin_discrete(const DiscreteBeam& beam, const Vector& way, DiscreteState& state) {
  state.mass = beam.mass;
  state.inertia = beam.inertia;
  const double length = way.norm();
  if (beam.cable) {
    const Cable& cable = *beam.cable;
    if (!(state.mass > 0)) state.mass = beam.density * cable.area * length;
    state.unstressed = state.reference = length - cable.offset;
    state.base = cable.end > 0 ? 0 : cable.force;
    state.stored_at_start = stored_energy(beam, state, length);
    return;
  }
  if (state.inertia > 0) return;
  double translation = 0, rotation = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    translation = std::max({translation, beam.laws[i].largest_stiffness()});
    rotation = std::max({rotation, beam.laws[i + 3].largest_stiffness()});
  }
  if (translation > 0) state.inertia = state.mass * rotation / translation;
  if (beam.couples()) state.inertia = std::max(state.inertia, state.mass * length * length / 4);
}

DiscreteForces discrete_forces(const DiscreteBeam& beam, const BeamEnds& ends, double dt, DiscreteState& state) {
  DiscreteForces out;
  const Vector way = ends.x[1] - ends.x[0], rate = ends.v[1] - ends.v[0], middle = way - dt / 2 * rate;
  const Vector spin = spin_of_axes(beam, ends, state.axes);
  Matrix axes = spin_rotation(dt / 2 * spin) * state.axes;
  state.axes = spin_rotation(dt * spin) * state.axes;
  if (beam.follows_line()) {
    align(middle, axes);
    align(way, state.axes);
  }
  Vector apart = rate;
  if (beam.couples()) apart -= ((ends.w[0] + ends.w[1]) / 2).cross(middle);
  const Vector ways = axes.transpose() * apart, turns = axes.transpose() * (ends.w[1] - ends.w[0]);
  std::array<double, 6> pulls{};
  Vector force = Vector::Zero(), moment = Vector::Zero();
  for (std::size_t i = 0; i < 6; ++i) {
    const auto axis = static_cast<Eigen::Index>(i % 3);
    const Pull pull = pull_of(beam.laws[i], i, i < 3 ? ways[axis] : turns[axis], dt, state);
    (i < 3 ? force : moment) += pull.force * state.axes.col(axis);
    out.dissipated += pull.dissipated;
    pulls[i] = pull.force;
  }
  const Vector couple = beam.couples() ? Vector(way.cross(force) / 2) : Vector(Vector::Zero());
  out.force = {-force, force};
  out.moment = {-moment - couple, moment - couple};
  out.axial = pulls[0];
  out.step = stable_step(beam, state, way);
  out.failed = fails(beam, pulls, state.way);
  out.good = std::isfinite(force.sum() + moment.sum());
  return out;
}

}  // namespace gapcheck::solver
