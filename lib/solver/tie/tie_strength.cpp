#include "solver/tie/tie_strength.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

double term(double force, double strength, double power) {
  return strength > 0 && force > 0 ? std::pow(force / strength, power) : 0;
}

double criterion(const TieStrength& strength, const Vector& force, const Vector& normal) {
  const double along = force.dot(normal), tension = -strength.side * along;
  const double across = (force - along * normal).norm();
  return term(tension, strength.normal, strength.normal_power) + term(across, strength.shear, strength.shear_power);
}

}  // namespace

double TieDamage::share(const TieStrength& strength, const Vector& force, const Vector& normal, double stretched) {
  elongation = std::max(elongation, stretched);
  if (onset == 0) {
    if (!(criterion(strength, force, normal) >= 1)) return 1;
    onset = elongation;
  }
  broken = !(elongation < strength.opening);
  if (broken) return 0;
  // The force at the largest elongation falls linearly from the onset to zero.
  return onset / elongation * (strength.opening - elongation) / (strength.opening - onset);
}

}  // namespace gapcheck::solver
