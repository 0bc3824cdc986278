#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include "solver/interface/contact_link.hpp"
#include "solver/interface/contact_source.hpp"
#include "solver/mortar/mortar_law.hpp"
#include "solver/mortar/mortar_surface.hpp"
#include "solver/mortar/overlap.hpp"

namespace gapcheck::solver {

/// The contact of two faces whose pressure is not zero: its resultant.
struct MortarTouch {
  LinkForce force;
  std::array<ContactPoint, 2> point;            ///< centre of the pressure on the tracked and the other face
  std::array<std::array<Vector, 4>, 2> offset;  ///< from the nodes of these points to the corners of their faces
  double area = 0;                              ///< under pressure
  double stored = 0;                            ///< energy of the pressure
  MortarLaw law;                                ///< of that pressure
  /// Velocity of a point; corners of free edges turn with their nodes.
  [[nodiscard]] Vector velocity(std::size_t side, const State& state) const;
  /// Adds half a step of work of the present force.
  void add_work(const State& state, LinkWork& sum) const {
    sum.add(force, velocity(0, state), velocity(1, state), state.dt);
  }
};

/// Two faces that may come into contact.
struct MortarPair {
  std::uint32_t tracked = 0, other = 0;  ///< faces of the surface
  double wake = 0;                       ///< nothing to check until this much of the margin is used up
  std::int8_t side = 0;   ///< of two faces without front: 1 if the other one lies along the normal, -1; 0: not known
  double forgiven = 0;    ///< depth without force in the last cycle with a force
  double deepest = 0;     ///< in this cycle, without what IGNORE forgives
  bool released = false;  ///< in this cycle some place was too deep
  std::unique_ptr<MortarTouch> touch;
  LinkWork work;    ///< of this cycle
  double lost = 0;  ///< energy that ended with the force in this cycle
  [[nodiscard]] std::uint64_t key() const { return std::uint64_t{tracked} << 32 | other; }
};

/// How two faces lie in this cycle.
struct MortarSight {
  bool faces = false;  ///< they look at each other
  double sign = 1;     ///< of the normal towards the other face
  Overlap overlap;
};

/// Measures a pair: its overlap, MortarPair::side and MortarPair::deepest. `release`: depth beyond which a place has no
/// force.
void sight_pair(const MortarSurface& surface, const std::vector<Vector>& x, MortarPair& pair, double release,
                MortarSight& sight);

/// The integral of the pressure over the overlap. `forgiven`: depth without force.
struct MortarPush {
  double push = 0, area = 0, stored = 0, deepest = 0;
  std::array<double, 4> tracked{}, other{};  ///< weights of the corners, sum 1 where there is a push
};
[[nodiscard]] MortarPush integrate_pressure(const MortarSight& sight, const MortarLaw& law, double distance,
                                            double forgiven, double release);

}  // namespace gapcheck::solver
