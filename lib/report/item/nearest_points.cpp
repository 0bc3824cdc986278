#include "report/item/nearest_points.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::report {

struct NearestPoints::Query {
  const Vector& x;
  double radius;
  std::size_t most;
  std::vector<std::pair<double, std::uint32_t>>& found;  // a heap, the farthest in front
  /// Nothing farther than this is useful; once there are enough, not even at this distance.
  [[nodiscard]] bool reaches(double distance) const {
    return found.size() < most ? distance <= radius : distance < found.front().first;
  }
};

NearestPoints::NearestPoints(std::vector<Point> points) : points_(std::move(points)), axis_(points_.size()) {
  build(0, points_.size());
}

void NearestPoints::build(std::size_t first, std::size_t end) {
  if (end - first < 2) return;
  Vector low = points_[first].first, high = low;
  for (std::size_t i = first; i < end; ++i) {
    low = low.cwiseMin(points_[i].first);
    high = high.cwiseMax(points_[i].first);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t middle = first + (end - first) / 2;
  const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(middle), at(end), [axis](const Point& a, const Point& b) {
    return a.first[axis] != b.first[axis] ? a.first[axis] < b.first[axis] : a.second < b.second;
  });
  axis_[middle] = static_cast<std::uint8_t>(axis);
  build(first, middle);
  build(middle + 1, end);
}

void NearestPoints::visit(std::size_t first, std::size_t end, Query& query) const {
  if (first == end) return;
  const std::size_t middle = first + (end - first) / 2;
  const auto& [point, id] = points_[middle];
  if (const double distance = (point - query.x).norm(); query.reaches(distance)) {
    if (query.found.size() == query.most) {
      std::pop_heap(query.found.begin(), query.found.end());
      query.found.pop_back();
    }
    query.found.emplace_back(distance, id);
    std::push_heap(query.found.begin(), query.found.end());
  }
  const double beyond = query.x[axis_[middle]] - point[axis_[middle]];
  const bool above = beyond > 0;
  visit(above ? middle + 1 : first, above ? end : middle, query);
  if (query.reaches(std::abs(beyond))) visit(above ? first : middle + 1, above ? middle : end, query);
}

void NearestPoints::nearest(const Vector& x, double radius, std::size_t most,
                            std::vector<std::pair<double, std::uint32_t>>& found) const {
  found.clear();
  if (most == 0) return;
  Query query{x, radius, most, found};
  visit(0, points_.size(), query);
  std::sort(found.begin(), found.end());
}

}  // namespace gapcheck::report
