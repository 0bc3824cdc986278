#include "geometry/front_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/quad.hpp"

namespace gapcheck::geometry {
namespace {

/// Terms of second order in the motion are second_order while it changes lengths and normals by at most a small_share.
constexpr double small_share = 0.1, second_order = 1.4, roundoff_share = 1e-12;

/// How far the corners may move before the normal of one of them may lean away from the mean one; triangles are flat.
double motion_unwarped(const Facet& facet, const Vector& normal, double turn_rate) {
  double motion = std::numeric_limits<double>::infinity();
  if (facet.triangle) return motion;
  std::array<Vector, 4> edge;
  std::array<double, 4> length{};
  for (std::size_t i = 0; i < 4; ++i) {
    edge[i] = facet.x[(i + 1) % 4] - facet.x[i];
    length[i] = edge[i].norm();
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t before = (i + 3) % 4;
    const double lean = normal.dot(edge[before].cross(edge[i])), most = length[before] * length[i];
    const double rate = length[before] + length[i] + turn_rate * most;
    motion = std::min(motion, (lean - roundoff_share * most) / (second_order * rate));
  }
  return motion;
}

}  // namespace

double motion_in_front(const Facet& facet, const Vector& query, double front) {
  const Vector across = quad_normal(facet.x);
  for (const Vector& corner : facet.x)
    if (!(front * across.dot(query - corner) > 0)) return 0;
  const double diagonals = (facet.x[2] - facet.x[0]).norm() + (facet.x[3] - facet.x[1]).norm();
  const double size = across.norm();
  if (!(size > 0) || !query.allFinite()) return 0;
  const Vector normal = across / size;
  const double turn_rate = diagonals / size;
  double height = std::numeric_limits<double>::infinity(), squared_lever = 0;
  for (const Vector& corner : facet.x) {
    const Vector from_corner = query - corner;
    height = std::min(height, front * normal.dot(from_corner));
    squared_lever = std::max(squared_lever, from_corner.squaredNorm());
  }
  const double lever = std::sqrt(squared_lever);
  height -= roundoff_share * lever;
  const double motion = std::min({height / (1 + second_order * turn_rate * lever), small_share / turn_rate,
                                  motion_unwarped(facet, normal, turn_rate)});
  return std::isfinite(motion) ? std::max(motion, 0.0) : 0;
}

}  // namespace gapcheck::geometry
