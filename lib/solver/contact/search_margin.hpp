#pragma once
#include <cstddef>
#include <vector>

#include "contact/surface/surface.hpp"

namespace gapcheck::solver {

/// Motion is measured and summed up in doubles; this covers their rounding.
inline constexpr double rounding_of_motion = 1 + 1e-12;

/// How much farther than the contact distance the search looks, so that its candidates last some steps: half a mean
/// side of the segments.
class SearchMargin {
 public:
  void add(const contact::Segments& segments, const std::vector<Vector>& x) {
    for (const auto& n : segments.nodes)
      for (std::size_t i = 0; i < 4; ++i) {
        if (n[i] == n[(i + 1) % 4]) continue;
        length_ += (x[n[i].value] - x[n[(i + 1) % 4].value]).norm();
        ++count_;
      }
  }
  /// 0 without any side.
  [[nodiscard]] double value() const { return count_ == 0 ? 0 : in_sides * length_ / static_cast<double>(count_); }

 private:
  static constexpr double in_sides = 0.5;
  double length_ = 0;
  std::size_t count_ = 0;
};

}  // namespace gapcheck::solver
