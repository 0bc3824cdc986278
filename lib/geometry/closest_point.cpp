#include "geometry/closest_point.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/certificate.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry {
namespace {

/// The vector's direction; zero if it is only rounding compared with `scale`.
Vector direction(const Vector& v, double squared_scale) {
  const double square = v.squaredNorm();
  return square > 1e-30 * squared_scale ? Vector(v / std::sqrt(square)) : Vector(Vector::Zero());
}

Vector triangle_normal(const Corners& e) {
  const Vector u = e[1] - e[0], v = e[2] - e[0];
  return direction(u.cross(v), u.squaredNorm() * v.squaredNorm());
}

/// Where an edge has collapsed to a point there is no normal: that of the mean plane is used.
Vector patch_normal(const Patch& patch, double s, double t) {
  const Vector rs = patch.along_s(t), rt = patch.along_t(s);
  Vector here = direction(rs.cross(rt), rs.squaredNorm() * rt.squaredNorm());
  if (!here.isZero(0)) return here;
  return direction(patch.a.cross(patch.b), patch.a.squaredNorm() * patch.b.squaredNorm());
}

/// The answer for numbers that are not finite.
ClosestPoint nowhere() {
  ClosestPoint out;
  out.squared_distance = std::numeric_limits<double>::infinity();
  out.in_band = false;
  return out;
}

}  // namespace

ClosestPoint closest_point(const Facet& facet, const Vector& query, double band) {
  View seen{seen_from(facet, query), 1};
  if (!usable(size_of(seen.corners))) {
    if (!all_finite(facet, query)) return nowhere();
    seen = scaled_view(facet, query);
  }
  const Corners& e = seen.corners;
  const double scale = seen.scale;
  const Patch patch(e);
  Location at = facet.triangle ? locate_on_triangle(e) : locate_on_patch(e, patch);
  if (!facet.triangle && !is_nearest(e, patch, at.s, at.t)) at = search_patch(e, patch);

  const Weights w = quad_weights(at.s, at.t);
  const Vector offset = blend(e, w);
  if (offset.hasNaN()) return nowhere();
  ClosestPoint out;
  out.squared_distance = scale == 1 ? offset.squaredNorm() : (offset / scale).squaredNorm();
  out.point = at.feature == Feature::corner ? facet.x[at.index] : blend(facet.x, w);
  out.s = at.s;
  out.t = at.t;
  out.free_s = at.free_s;
  out.free_t = at.free_t;
  out.feature = at.feature;
  out.feature_index = at.index;
  out.normal = facet.triangle ? triangle_normal(e) : patch_normal(patch, at.s, at.t);
  out.gap = -out.normal.dot(offset) / scale;
  out.in_band = at.beyond <= band + 1e-9 * (1 + band);
  return out;
}

LineClosest closest_point_on_line(const Vector& a, const Vector& b, const Vector& query) {
  LineClosest out;
  const Vector along = b - a, from_a = query - a;
  const double length = along.squaredNorm();
  const double ratio = length > 0 ? from_a.dot(along) / length : 0;
  out.free_s = 2 * ratio - 1;
  out.s = std::clamp(out.free_s, -1.0, 1.0);
  if (ratio <= 0) {
    out.point = a;
  } else if (ratio >= 1) {
    out.point = b;
  } else {
    out.point = a + ratio * along;
  }
  out.squared_distance =
      (ratio > 0 && ratio < 1 ? Vector(from_a - ratio * along) : Vector(query - out.point)).squaredNorm();
  return out;
}

}  // namespace gapcheck::geometry
