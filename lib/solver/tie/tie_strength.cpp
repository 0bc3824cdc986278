#include "solver/tie/tie_strength.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

double term(double force, double strength, double power) {
  return strength > 0 && force > 0 ? std::pow(force / strength, power) : 0;
}

/// Elongations of a bilinear law between which its stiffness falls to nothing.
struct Softening {
  double start = 0, end = 0;
};

/// `opened`, `slipped`: shares of the elongation, with opened² + slipped² = 1. Source: LS-DYNA Keyword User's Manual,
/// Vol. II, *MAT_COHESIVE_MIXED_MODE (power law, and B-K with γ = 1), multiplied by the area; P. P. Camanho, C. G.
/// Davila, NASA/TM-2002-211737. In pure modes the triangle below the force has the energy of the mode.
Softening softening(const TieStrength& strength, double stiffness, double shear_strength, double opened,
                    double slipped) {
  const double across = strength.stiffness_ratio * stiffness;
  const double tension = stiffness * opened * opened, shear = across * slipped * slipped;
  Softening found;
  found.start = 1 / std::hypot(opened * stiffness / strength.normal, slipped * across / shear_strength);
  if (strength.exponent > 0) {
    const double power = strength.exponent;
    found.end =
        2 / found.start *
        std::pow(std::pow(tension / strength.normal_energy, power) + std::pow(shear / strength.shear_energy, power),
                 -1 / power);
  } else {
    const double ratio = std::pow(shear / (tension + shear), -strength.exponent);
    found.end = 2 / (found.start * (tension + shear)) *
                (strength.normal_energy + (strength.shear_energy - strength.normal_energy) * ratio);
  }
  return found;
}

}  // namespace

double TieStrength::criterion(const Vector& force, const Vector& normal_of_segment) const {
  const double along = force.dot(normal_of_segment), tension = -side * along;
  const double across = (force - along * normal_of_segment).norm();
  return term(tension, normal, normal_power) + term(across, shear, shear_power);
}

bool TieDamage::bridges(const TieStrength& strength) const {
  return broken && strength.law == TieLaw::brittle && strength.curve != nullptr && !strength.curve->points.empty() &&
         widest < strength.curve->points.back()[0];
}

TieResponse TieDamage::respond(const TieStrength& strength, double stiffness, const Vector& stretch,
                               const Vector& normal) {
  const double opening = strength.side * stretch.dot(normal);
  const Vector slip = stretch - strength.side * opening * normal;
  if (broken) return bridge(strength, opening, normal);
  if (strength.law == TieLaw::plastic) return yield(strength, stiffness, opening, slip, normal);
  if (strength.law == TieLaw::cohesive) return crack(strength, stiffness, opening, slip, normal);
  const Vector force = -stiffness * stretch;
  // Compression does no damage.
  const Vector pressed = std::min(0.0, opening) * strength.side * normal;
  TieResponse response;
  response.share = share_left(strength, force, normal, (stretch - pressed).norm());
  if (broken) return bridge(strength, opening, normal);
  // Compression stays in full until the tie is gone.
  const double push = std::max(0.0, strength.side * force.dot(normal));
  const Vector whole = strength.side * push * normal;
  response.force = response.share * (force - whole) + whole;
  return response;
}

double TieDamage::share_left(const TieStrength& strength, const Vector& force, const Vector& normal, double stretched) {
  elongation = std::max(elongation, stretched);
  if (onset == 0) {
    if (!(strength.criterion(force, normal) >= 1)) return 1;
    onset = elongation;
  }
  broken = !(elongation < strength.opening);
  if (broken) return 0;
  // The force at the largest elongation falls linearly from the onset to zero.
  return onset / elongation * (strength.opening - elongation) / (strength.opening - onset);
}

/// After the failure: only opening is resisted, and on the way back the force falls along the line to the origin, so
/// that nothing is gained.
TieResponse TieDamage::bridge(const TieStrength& strength, double opening, const Vector& normal) {
  TieResponse response;
  response.share = 0;
  if (!bridges(strength)) return response;
  widest = std::max(widest, opening);
  if (opening > 0 && bridges(strength))
    response.force = -strength.area * strength.curve->at(widest) * (opening / widest) * strength.side * normal;
  return response;
}

/// √(tension² + 3 across²) stays at or below the strength (in compression √3 across), which falls with the largest
/// opening.
TieResponse TieDamage::yield(const TieStrength& strength, double stiffness, double opening, const Vector& slip,
                             const Vector& normal) {
  const double pulled = std::max(0.0, opening);
  widest = std::max(widest, flowed + opening);
  double limit = strength.normal;
  if (strength.curve != nullptr) limit *= std::max(0.0, strength.curve->at(std::max(0.0, widest)));
  TieResponse response;
  if (!(limit > 0)) {
    broken = true;
    response.share = 0;
    return response;
  }
  const double size = stiffness * std::sqrt(pulled * pulled + 3 * slip.squaredNorm());
  response.share = size > limit ? limit / size : 1;
  const Vector yielding = slip + pulled * strength.side * normal;
  response.force = -stiffness * (response.share * yielding + std::min(0.0, opening) * strength.side * normal);
  response.flow = (1 - response.share) * yielding;
  flowed += (1 - response.share) * pulled;
  return response;
}

/// Damage grows with the elongation and never heals; compression is carried in full until the tie is gone.
TieResponse TieDamage::crack(const TieStrength& strength, double stiffness, double opening, const Vector& slip,
                             const Vector& normal) {
  const double pulled = std::max(0.0, opening), pressed = std::min(0.0, opening), slipped = slip.norm();
  if (const double grown = std::hypot(pulled, slipped); grown > 0) {
    const double shear_strength = strength.shear - strength.friction * stiffness * pressed;
    const Softening way = softening(strength, stiffness, shear_strength, pulled / grown, slipped / grown);
    if (grown >= way.end && grown >= way.start)
      lost = 1;
    else if (grown > way.start)
      lost = std::max(lost, way.end * (grown - way.start) / (grown * (way.end - way.start)));
  }
  TieResponse response;
  broken = !(lost < 1);
  if (broken) {
    response.share = 0;
    return response;
  }
  response.share = 1 - lost;
  response.force = -stiffness * ((1 - lost) * (pulled * strength.side * normal + strength.stiffness_ratio * slip) +
                                 pressed * strength.side * normal);
  return response;
}

}  // namespace gapcheck::solver
