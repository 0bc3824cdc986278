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
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector ahead = facet.x[(i + 1) % 4] - facet.x[i], back = facet.x[(i + 3) % 4] - facet.x[i];
    const Vector at_corner = ahead.cross(back);
    const double rate = ahead.norm() + back.norm() + turn_rate * at_corner.norm();
    motion = std::min(motion, (normal.dot(at_corner) - roundoff_share * at_corner.norm()) / (second_order * rate));
  }
  return motion;
}

}  // namespace

double motion_in_front(const Facet& facet, const Vector& query, double front) {
  const double diagonals = (facet.x[2] - facet.x[0]).norm() + (facet.x[3] - facet.x[1]).norm();
  const Vector across = quad_normal(facet.x);
  const double size = across.norm();
  if (!(size > 0) || !query.allFinite()) return 0;
  const Vector normal = across / size;
  const double turn_rate = diagonals / size;
  double height = std::numeric_limits<double>::infinity(), lever = 0;
  for (const Vector& corner : facet.x) {
    const Vector from_corner = query - corner;
    const double length = from_corner.norm();
    height = std::min(height, front * normal.dot(from_corner) - roundoff_share * length);
    lever = std::max(lever, length);
  }
  const double motion = std::min({height / (1 + second_order * turn_rate * lever), small_share / turn_rate,
                                  motion_unwarped(facet, normal, turn_rate)});
  return std::isfinite(motion) ? std::max(motion, 0.0) : 0;
}

}  // namespace gapcheck::geometry
