#include "model/entity/foam_rubber.hpp"

#include <algorithm>

namespace gapcheck::model {

double largest_slope(const std::vector<std::array<double, 2>>& points) {
  double largest = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i][0] > points[i - 1][0])
      largest = std::max(largest, (points[i][1] - points[i - 1][1]) / (points[i][0] - points[i - 1][0]));
  return largest;
}

double last_slope(const std::vector<std::array<double, 2>>& points) {
  if (points.size() < 2) return 0;
  const auto &a = points[points.size() - 2], &b = points.back();
  return b[0] > a[0] ? (b[1] - a[1]) / (b[0] - a[0]) : 0;
}

}  // namespace gapcheck::model
