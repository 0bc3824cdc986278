#include "solver/mortar/mortar_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapcheck::solver {
namespace {

/// Share of the room between ω² dt² of the elements and 4 that a contact takes. The two faces of a solid have masses
/// of their own; of a shell, which may be pressed from both sides, the vibrations along its normal are slower than
/// those in its plane, which the elements' share is about (our own choice).
constexpr double share_of_room = 0.9;
/// What a contact takes at least, as SOFT = 2 does with SLSFAC = 0.1.
constexpr double least_room = 0.05;
/// Rigid bodies have no vibrations of their own.
constexpr double room_of_bodies = share_of_room * 4;

}  // namespace

void MortarStiffness::set_timestep(double timestep) {
  timestep_ = timestep;
  new_step_ = true;
}

void MortarStiffness::follow(const State& state) {
  mobility_.follow(state);
  const double room = std::max(least_room, share_of_room * (4 - state.elements_share));
  // Small changes of the share, back and forth, are no reason for another stiffness.
  if (new_step_ || room < 0.95 * room_) room_ = room;
  new_step_ = false;
}

MortarLaw MortarStiffness::law_of(std::uint32_t tracked, std::uint32_t other) const {
  const MortarFace& stiff = surface_[tracked].slope > 0 ? surface_[tracked] : surface_[other];
  MortarLaw law{stiff.slope, MortarLaw::relative_knee * stiff.length};
  // Two masses joined by a stiffness per area: ω² is the stiffness times the sum of the mobilities.
  const double mobility = mobility_.of(tracked) + mobility_.of(other);
  if (!(mobility > 0) || !(timestep_ > 0) || !std::isfinite(timestep_)) return law;
  const double room = mobility_.rigid(tracked) && mobility_.rigid(other) ? room_of_bodies : room_;
  law.steepest = room / (timestep_ * timestep_) / mobility;
  if (!(law.slope > 0)) law.slope = law.steepest;
  return law;
}

double MortarStiffness::step_of_bodies(const State& state) {
  mobility_.follow(state);
  double slope = 0, mobility[2] = {0, 0};
  bool on_b = false;
  for (std::uint32_t i = 0; i < surface_.size(); ++i) {
    const MortarFace& face = surface_[i];
    if (std::isfinite(mobility_.of(i))) mobility[face.on_b] = std::max(mobility[face.on_b], mobility_.of(i));
    slope = std::max(slope, face.slope);
    on_b = on_b || face.on_b;
  }
  const double sum = on_b ? mobility[0] + mobility[1] : 2 * mobility[0];
  return slope > 0 && sum > 0 ? std::sqrt(room_of_bodies / (slope * sum)) : std::numeric_limits<double>::infinity();
}

}  // namespace gapcheck::solver
