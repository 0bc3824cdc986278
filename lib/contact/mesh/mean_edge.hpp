#pragma once
#include <cstdint>
#include <vector>

#include "base/vector.hpp"
#include "model/entity/sets.hpp"

namespace gapcheck::contact {

/// Mean length of the edges of segments; an edge counts with each of them.
class MeanEdge {
 public:
  void add(const model::SegmentNodes& corners, const std::vector<Vector>& x) {
    for (std::size_t i = 0; i < 4; ++i) {
      const NodeIndex a = corners[i], b = corners[(i + 1) % 4];
      if (a == b) continue;
      sum_ += (x[a.value] - x[b.value]).norm();
      ++count_;
    }
  }
  /// 0 without any.
  [[nodiscard]] double value() const { return count_ > 0 ? sum_ / static_cast<double>(count_) : 0; }

 private:
  double sum_ = 0;
  std::uint64_t count_ = 0;
};

}  // namespace gapcheck::contact
