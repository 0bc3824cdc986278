#pragma once
#include "triangle.hpp"

namespace gapcheck::bench {

/// The bilinear patch r(s,t) = m + a s + b t + c s t of four corners seen from the query.
template <class Point>
struct BilinearPatch {
  using Number = typename Point::Scalar;
  Point m, a, b, c;
  explicit BilinearPatch(const std::array<Point, 4>& e)
      : m(Number(0.25) * ((e[0] + e[1]) + (e[2] + e[3]))),
        a(Number(0.25) * ((e[1] - e[0]) + (e[2] - e[3]))),
        b(Number(0.25) * ((e[3] - e[0]) + (e[2] - e[1]))),
        c(Number(0.25) * ((e[0] - e[1]) + (e[2] - e[3]))) {}
};

/// The plain end of a search on the patch: the point itself where it lies inside, else the nearest edge.
template <class Point>
[[nodiscard]] typename Point::Scalar squared_distance_at(const std::array<Point, 4>& e,
                                                         const BilinearPatch<Point>& patch, typename Point::Scalar s,
                                                         typename Point::Scalar t) {
  if (std::abs(s) <= 1 && std::abs(t) <= 1) return (patch.m + s * patch.a + t * (patch.b + s * patch.c)).squaredNorm();
  typename Point::Scalar best = squared_distance_of_edge(e[3], e[0]);
  for (std::size_t i = 0; i < 3; ++i) best = std::min(best, squared_distance_of_edge(e[i], e[i + 1]));
  return best;
}

}  // namespace gapcheck::bench
