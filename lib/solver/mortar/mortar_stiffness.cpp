#include "solver/mortar/mortar_stiffness.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// Share of the room between ω² dt² of the elements and 4 that one contact takes: a node may be in two (our own
/// choice).
constexpr double share_of_room = 0.5;
/// What a contact takes at least, as SOFT = 2 does with SLSFAC = 0.1.
constexpr double least_room = 0.05;

}  // namespace

void MortarStiffness::set_timestep(double timestep) {
  timestep_ = timestep;
  new_step_ = true;
}

void MortarStiffness::follow_step(const State& state) {
  const double room = std::max(least_room, share_of_room * (4 - state.elements_share));
  // Small changes of the share, back and forth, are no reason for another stiffness.
  if (new_step_ || room < 0.95 * room_) room_ = room;
  new_step_ = false;
}

MortarLaw MortarStiffness::law_of(const MortarFace& tracked, const MortarFace& other) const {
  const MortarFace& stiff = tracked.slope > 0 ? tracked : other;
  MortarLaw law{stiff.slope, MortarLaw::relative_knee * stiff.length};
  const double sum = tracked.mass + other.mass;
  if (!(sum > 0) || !(timestep_ > 0) || !std::isfinite(timestep_)) return law;
  // Two masses joined by κ per area: ω² = κ / m, 1 / m = 1 / m₁ + 1 / m₂.
  const double bound = room_ / (timestep_ * timestep_) * tracked.mass * other.mass / sum;
  law.slope = law.slope > 0 ? std::min(law.slope, bound) : bound;
  return law;
}

}  // namespace gapcheck::solver
