#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck::report {

/// Points in a tree of halves, to find those nearest to a position. Points need finite coordinates.
class NearestPoints {
 public:
  /// `id` comes back from nearest().
  using Point = std::pair<Vector, std::uint32_t>;
  explicit NearestPoints(std::vector<Point> points);
  /// The nearest points within `radius`, at most `most`, as (distance, id), ascending. Among equally near ones the
  /// choice is arbitrary but deterministic.
  void nearest(const Vector& x, double radius, std::size_t most,
               std::vector<std::pair<double, std::uint32_t>>& found) const;

 private:
  struct Query;
  void build(std::size_t first, std::size_t end);
  void visit(std::size_t first, std::size_t end, Query& query) const;

  std::vector<Point> points_;       // the median of every range is in its middle
  std::vector<std::uint8_t> axis_;  // along which the range around the point is halved
};

}  // namespace gapcheck::report
