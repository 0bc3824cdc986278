#pragma once
#include <limits>

#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// Forces on nodes that do not come from the elements: loads, springs, contact, rigid walls. Called once per step, in the
/// order in which they were given. What they do counts as external work but for what absorbed() names.
class Force {
 public:
  virtual ~Force() = default;
  /// Adds to `forces` what acts at state.time. May move nodes (state.x) of no rigid body; the elements take no stress
  /// from that. Must give the same sums for any number of threads.
  virtual void add(State& state, Forces& forces) = 0;
  /// True for what answers to the sum of all other forces: asked for its reactions once that sum is there.
  [[nodiscard]] virtual bool reacts() const { return false; }
  /// Adds reactions to both `net` and `external`, which then change the velocities by reaction / mass * `mean` (mean: of
  /// the last step and the coming one, `next`). Nodes of rigid bodies and constrained freedoms are not for it.
  virtual void react(const State& /*state*/, double /*mean*/, double /*next*/, Forces& /*net*/, Forces& /*external*/) {}
  /// Adds the work that this force took from the structure since the start, by the row of the energy balance it belongs
  /// to; up to state.time, by the trapezoidal rule over each step: -dt/2 (force before + force now) . velocity.
  virtual void absorbed(Absorbed& /*work*/) const {}
  /// The longest stable step as far as this force knows; asked for after add().
  [[nodiscard]] virtual double stable_step() const { return std::numeric_limits<double>::infinity(); }
};

}  // namespace gapcheck::solver
