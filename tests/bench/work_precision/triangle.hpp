#pragma once
#include <algorithm>

#include "pair.hpp"

namespace gapcheck::bench {

/// Squared distance of a straight edge from the origin.
template <class Point>
[[nodiscard]] typename Point::Scalar squared_distance_of_edge(const Point& a, const Point& b) {
  using Number = typename Point::Scalar;
  const Point d = b - a;
  const Number length = d.squaredNorm();
  const Number ratio = length > 0 ? std::clamp<Number>(-a.dot(d) / length, 0, 1) : 0;
  return (a + ratio * d).squaredNorm();
}

/// Squared distance of a triangle from the origin: the foot of the perpendicular where it lies inside, else the nearest
/// of the edges that it lies beyond.
template <class Point>
[[nodiscard]] typename Point::Scalar squared_distance_of_triangle(const Point& a, const Point& b, const Point& c) {
  using Number = typename Point::Scalar;
  const Point u = b - a, v = c - a, n = u.cross(v);
  const Number area = n.squaredNorm();
  if (!(area > 0)) {
    return std::min({squared_distance_of_edge(a, b), squared_distance_of_edge(b, c), squared_distance_of_edge(c, a)});
  }
  const Number of_a = n.dot(b.cross(c)) / area, of_b = n.dot(c.cross(a)) / area, of_c = 1 - of_a - of_b;
  if (of_a >= 0 && of_b >= 0 && of_c >= 0) return (of_a * a + of_b * b + of_c * c).squaredNorm();
  Number best = std::numeric_limits<Number>::infinity();
  if (!(of_a >= 0)) best = squared_distance_of_edge(b, c);
  if (!(of_b >= 0)) best = std::min(best, squared_distance_of_edge(c, a));
  if (!(of_c >= 0)) best = std::min(best, squared_distance_of_edge(a, b));
  return best;
}

}  // namespace gapcheck::bench
