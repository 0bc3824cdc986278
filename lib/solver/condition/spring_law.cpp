#include "solver/condition/spring_law.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace gapcheck::solver {

double SpringLaw::force(double elongation) const {
  double sum = stiffness * elongation;
  if (curve.size() == 1) return sum + curve[0][1];
  if (curve.size() < 2) return sum;
  const auto above = std::upper_bound(curve.begin() + 1, curve.end() - 1, elongation,
                                      [](double u, const std::array<double, 2>& point) { return u < point[0]; });
  const auto& [u0, f0] = *(above - 1);
  const auto& [u1, f1] = *above;
  return sum + f0 + (f1 - f0) * (elongation - u0) / (u1 - u0);
}

double SpringLaw::energy(double elongation) const {
  // Linear between points and beyond the first and the last: the trapezoidal rule is exact between breaks.
  std::vector<double> breaks{0};
  const auto inside = [&](double u) { return elongation > 0 ? u > 0 && u < elongation : u < 0 && u > elongation; };
  for (const auto& point : curve)
    if (inside(point[0])) breaks.push_back(point[0]);
  breaks.push_back(elongation);
  if (elongation < 0) std::sort(breaks.begin(), breaks.end(), std::greater<>());
  double sum = 0;
  for (std::size_t i = 1; i < breaks.size(); ++i)
    sum += (breaks[i] - breaks[i - 1]) * (force(breaks[i]) + force(breaks[i - 1])) / 2;
  return sum;
}

double SpringLaw::largest_stiffness() const {
  double largest = 0;
  for (std::size_t i = 1; i < curve.size(); ++i)
    largest = std::max(largest, std::abs((curve[i][1] - curve[i - 1][1]) / (curve[i][0] - curve[i - 1][0])));
  return std::max(std::abs(stiffness) + largest + std::abs(transient), loading.steepest());
}

double SpringLaw::largest_damping() const { return std::abs(damping) + rates.steepest(); }

Vector SpringLaw::update(const Vector& elongation, double dt, double time, SpringHistory& history) const {
  Vector force = Vector::Zero();
  switch (kind) {
    case Kind::elastic:
      break;
    case Kind::elastoplastic:
      force = flow(elongation, history);
      break;
    case Kind::maxwell:
      force = relax(elongation, dt, time > cutoff, history);
      break;
    case Kind::inelastic:
      force = load(elongation.x(), history);
      break;
  }
  history.elongation = elongation;
  return force;
}

/// Radial return; along a line that of one dimension with isotropic hardening.
Vector SpringLaw::flow(const Vector& elongation, SpringHistory& history) const {
  const Vector trial = stiffness * (elongation - history.inner);
  const double size = trial.norm(), excess = size - (yield + hardening * history.reached);
  if (!(excess > 0)) return trial;
  const double plastic = excess / (stiffness + hardening);
  history.inner += plastic / size * trial;
  history.reached += plastic;
  return trial - stiffness * plastic / size * trial;
}

/// F = KI u + q with dq/dt = (K0 - KI) du/dt - BETA q, exact for an even rate; after the cutoff a constant force.
Vector SpringLaw::relax(const Vector& elongation, double dt, bool cut, SpringHistory& history) const {
  const Vector growth = elongation - history.elongation;
  if (cut) {
    history.work += cutoff_force * growth.x();
    return cutoff_force * Vector::UnitX();
  }
  const double x = decay * dt;
  // (1 - e^-x) / x, and one minus it over x: means over the step of what decays and of what grows and decays.
  const double first = x > 0 ? -std::expm1(-x) / x : 1;
  const double second = x > 1e-4 ? (1 - first) / x : 0.5 - x / 6;
  const Vector mean = first * history.inner + second * transient * growth;
  history.work += growth.dot(stiffness / 2 * (elongation + history.elongation) + mean);
  history.inner = std::exp(-x) * history.inner + first * transient * growth;
  return stiffness * elongation + history.inner;
}

/// Along the curve, or below it along a line of the slope KU, which moves with the farthest point on the curve.
Vector SpringLaw::load(double elongation, SpringHistory& history) const {
  const double way = sense * elongation;
  double& rest = history.inner[0];
  history.force = 0;
  if (way > rest) {
    const double line = stiffness * (way - rest), top = std::max(0.0, loading.at(way));
    history.force = std::min(line, top);
    if (line > top) {
      rest = way - top / stiffness;
      history.reached = way;
    }
  }
  return sense * history.force * Vector::UnitX();
}

double SpringLaw::held(const SpringHistory& history) const {
  switch (kind) {
    case Kind::elastic:
      break;
    case Kind::elastoplastic: {
      const double stored = stiffness * (history.elongation - history.inner).squaredNorm() / 2;
      return stored + (yield + hardening / 2 * history.reached) * history.reached;
    }
    case Kind::maxwell:
      return history.work;
    case Kind::inelastic: {
      const double top = std::max(0.0, loading.at(history.reached));
      return loading.integral_above_zero(history.reached, 0, 1) +
             (history.force * history.force - top * top) / (2 * stiffness);
    }
  }
  return 0;
}

}  // namespace gapcheck::solver
