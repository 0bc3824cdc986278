#pragma once
#include <limits>

#include "solver/state/failure.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// Forces on nodes that do not come from the elements: loads, springs, contact, rigid walls. Called once per step, in
/// the order in which they were added. Their work counts as external work except for what absorbed() reports.
class Force {
 public:
  virtual ~Force() = default;
  /// Adds to `forces` what acts at state.time. May move nodes (state.x) outside rigid bodies; this causes no stress in
  /// the elements. Must give the same sums for any number of threads.
  virtual void add(State& state, Forces& forces) = 0;
  /// True for forces that react to the sum of all others: called for its reactions once that sum is complete.
  [[nodiscard]] virtual bool reacts() const { return false; }
  /// Adds reactions to both `net` and `external`, which then change the velocities by reaction / mass * `mean` (mean:
  /// of the last step and the next one, `next`). Must not act on nodes of rigid bodies and constrained degrees of
  /// freedom.
  virtual void react(const State& /*state*/, double /*mean*/, double /*next*/, Forces& /*net*/, Forces& /*external*/) {}
  /// Sets velocities of nodes that follow others, once all other velocities of the next step are known.
  virtual void follow(State& /*state*/) {}
  /// A failure ends the run; asked after add().
  [[nodiscard]] virtual SolverStatus status() const { return {}; }
  /// Adds the work that this force took from the structure since the start, by its row of the energy balance; up to
  /// state.time, by the trapezoidal rule over each step: -dt/2 (force before + force now) . velocity.
  virtual void absorbed(Absorbed& /*work*/) const {}
  /// The same by the state: the energy that this force stores now, beyond that at the start, and what it has
  /// dissipated. A force that only dissipates, or of which the state says nothing, has taken its work.
  virtual void held(Absorbed& energy) const { absorbed(energy); }
  /// The longest stable step for this force; called after add().
  [[nodiscard]] virtual double stable_step() const { return std::numeric_limits<double>::infinity(); }
};

}  // namespace gapcheck::solver
