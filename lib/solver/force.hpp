#pragma once
#include <limits>

#include "solver/state.hpp"

namespace gapcheck::solver {

/// Forces on nodes that do not come from the elements: loads, springs, contact. Called once per step, in the order in
/// which they were given; what they do counts as external work.
class Force {
 public:
  virtual ~Force() = default;
  /// Adds to `forces` what acts at state.time. Must give the same sums for any number of threads.
  virtual void add(const State& state, Forces& forces) = 0;
  /// The longest stable step as far as this force knows; asked for after add().
  [[nodiscard]] virtual double stable_step() const { return std::numeric_limits<double>::infinity(); }
};

}  // namespace gapcheck::solver
