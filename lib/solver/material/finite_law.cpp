#include "solver/material/finite_law.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// What hysteresis leaves of a law with the energy W below W_max: the energy φ(W), its slope and its second slope,
/// φ' = HU + (1 − HU) (W / W_max)^SHAPE.
struct Weakened {
  double energy = 0, factor = 1, second = 0;
};

Weakened weakened(const FiniteLaw& law, double energy, double most) {
  if (!law.weakens() || !(most > 0) || energy < 0) return {energy, 1, 0};
  const double ratio = std::min(energy / most, 1.0), power = std::pow(ratio, law.shape), lost = 1 - law.unloading;
  Weakened result;
  result.energy = energy * (law.unloading + lost * power / (law.shape + 1));
  result.factor = law.unloading + lost * power;
  // φ'' is needed for a bound over a step in which the ratio may grow to 1. It multiplies the square of the force,
  // which grows with W, so φ''(W_max) W_max / W does.
  constexpr double least = 1e-3;
  result.second = lost * law.shape / (most * std::max(ratio, least));
  return result;
}

/// Of the whole history on the curve: what a growth of W_max takes, (1 − HU) SHAPE / (SHAPE + 1) of it.
double taken_by_growth(const FiniteLaw& law, double growth) {
  return law.weakens() ? (1 - law.unloading) * law.shape / (law.shape + 1) * growth : 0;
}

double branch_energy(const FiniteLaw& law, const Symmetric& stress) {
  return law.branch_modulus > 0 ? contract(stress, stress) / (2 * law.branch_modulus) : 0;
}

/// q̇ = ED D − BETA1 q in axes that turn with the spin; the exact solution for a constant D.
void update_branch(const FiniteLaw& law, const Matrix& gradient, double dt, double volume, FiniteHistory& history) {
  if (!(law.branch_modulus > 0) || !(dt > 0)) return;
  const Vector spin(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0), gradient(1, 0) - gradient(0, 1));
  const Symmetric before = rotated(history.branch, spin_rotation(dt / 2 * spin));
  const Symmetric rate = rotated(to_symmetric(gradient), spin_rotation(dt / 4 * spin));
  const double passed = law.branch_decay * dt, kept = std::exp(-passed);
  const double share = passed > 0 ? -std::expm1(-passed) / passed : 1;
  for (std::size_t i = 0; i < 6; ++i) history.branch[i] = kept * before[i] + law.branch_modulus * share * dt * rate[i];
  Symmetric mean = before;
  for (std::size_t i = 0; i < 6; ++i) mean[i] = (before[i] + history.branch[i]) / 2;
  const double work = dt * contract(mean, rate);
  history.lost += volume * (work - branch_energy(law, history.branch) + branch_energy(law, before));
}

/// What the strain rate adds to the law, by the rate of this step and of those before it.
RateLaws::Excess rate_excess(const RateLaws& laws, const Vector& x, const Matrix& axes, const Matrix& gradient,
                             double dt, FiniteHistory& history) {
  if (dt > 0) {
    const Vector rates_of_x = (axes.transpose() * gradient * axes).diagonal();
    constexpr double steps = 12;
    const bool by_time = laws.window > 0;
    history.rate.add(laws.present(x, rates_of_x), by_time ? dt : 1, by_time ? laws.window : steps);
  }
  return laws.excess(x, history.rate.mean());
}

/// The work of the stress that the rate adds is not stored.
void lose_excess_work(const Symmetric& excess, const Matrix& gradient, double dt, FiniteHistory& history) {
  const Vector spin(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0), gradient(1, 0) - gradient(0, 1));
  const Symmetric before = rotated(history.excess, spin_rotation(dt / 2 * spin));
  const Symmetric rate = rotated(to_symmetric(gradient), spin_rotation(dt / 4 * spin));
  history.lost += dt / 2 * (contract(before, rate) + contract(excess, rate));
  history.excess = excess;
}

/// W_max grows with W, or falls back towards it.
void update_most(const FiniteLaw& law, double energy, double dt, FiniteHistory& history) {
  if (energy >= history.most_energy) {
    history.lost += taken_by_growth(law, energy - history.most_energy);
    history.most_energy = energy;
  } else if (law.healing > 0 && law.weakens()) {
    const double before = weakened(law, energy, history.most_energy).energy;
    history.most_energy = energy + (history.most_energy - energy) * std::exp(-law.healing * dt);
    history.lost -= weakened(law, energy, history.most_energy).energy - before;
  }
}

}  // namespace

FinitePoint update_finite(const FiniteLaw& law, const Matrix& f, const Matrix& gradient, double dt,
                          FiniteHistory& history) {
  const Eigen::SelfAdjointEigenSolver<Matrix> squares(f * f.transpose());
  const Vector x = squares.eigenvalues().array().log() / 2;
  const Matrix& axes = squares.eigenvectors();
  const double volume = std::exp(x.sum());
  if (!history.torn && law.elastic->tears(x)) {
    history.torn = true;
    history.lost += law.elastic->shape(x, false).energy - law.elastic->shape(x, true).energy;
  }
  PrincipalResponse response = law.elastic->shape(x, history.torn);
  update_most(law, response.energy, dt, history);
  const Weakened left = weakened(law, response.energy, history.most_energy);
  const PrincipalResponse rest = law.elastic->volume(x);
  Vector force = left.factor * response.force + rest.force;
  if (law.weakens()) response.slope += left.second * response.force * response.force.transpose();
  response.force += rest.force;
  response.slope += rest.slope;
  update_branch(law, gradient, dt, volume, history);

  FinitePoint point;
  if (law.rates) {
    const RateLaws::Excess excess = rate_excess(*law.rates, x, axes, gradient, dt, history);
    const Vector added = left.factor * excess.force;
    force += added;
    response.force += excess.force;
    response.slope += excess.slope;
    const double of_rate = law.rates->engineering ? std::exp(x.cwiseAbs().maxCoeff()) : 1;
    point.viscosity = excess.force_over_rate.norm() * of_rate * history.rate.newest_share();
    lose_excess_work(to_symmetric(axes * added.asDiagonal() * axes.transpose()), gradient, dt, history);
  }
  point.stress = to_symmetric(axes * force.asDiagonal() * axes.transpose() / volume);
  for (std::size_t i = 0; i < 6; ++i) point.stress[i] += history.branch[i];
  point.energy = left.energy + rest.energy + volume * branch_energy(law, history.branch);
  point.bound = principal_stiffness_bound(x, response) + volume * law.branch_modulus;
  return point;
}

}  // namespace gapcheck::solver
