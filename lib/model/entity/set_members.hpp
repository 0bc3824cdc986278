#pragma once
#include <cstdint>
#include <vector>

#include "model/entity/sets.hpp"

namespace gapcheck::model {

/// Members of a set while it is being built: positions in the arrays of the model, or segments.
struct Members {
  std::vector<std::uint32_t> positions;
  std::vector<SegmentNodes> segments;
  /// Memory in units of four bytes.
  [[nodiscard]] std::uint64_t cost() const { return positions.size() + 4 * segments.size(); }
  void append(const Members& other);
  /// Keeps only members that the other has too.
  void intersect(const Members& other);
  /// Keeps the first of equal entries, none of those in `removed`, and the order.
  void keep_unique(const Members& removed);
};

/// Budget of steps for all sets of a deck together: one per member visited. Sets of sets can demand far more than a
/// deck of their size contains; the largest models stay far below.
class Budget {
 public:
  explicit Budget(std::uint64_t steps = 300'000'000) : left_(steps) {}
  /// False from the first request that exceeds what is left.
  bool spend(std::uint64_t steps) {
    if (steps > left_) exhausted_ = true;
    if (exhausted_) return false;
    left_ -= steps;
    return true;
  }
  [[nodiscard]] bool exhausted() const { return exhausted_; }

 private:
  std::uint64_t left_;
  bool exhausted_ = false;
};

}  // namespace gapcheck::model
