#include "geometry/outside_band.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/patch.hpp"

namespace gapcheck::geometry {
namespace {

/// r = m + s a + t b + s t c over |s|, |t| <= end; triangles: their affine map, with the band's triangle inside a box.
struct Continued {
  Vector m, a, b, c;
  double end;
};

/// The continued facet, seen from the query. A triangle's barycentric coordinates are at least -1/4 in the band.
Continued continued(const Facet& facet, const Vector& query) {
  const Corners e{Vector(facet.x[0] - query), Vector(facet.x[1] - query), Vector(facet.x[2] - query),
                  Vector(facet.x[3] - query)};
  if (!facet.triangle) {
    const Patch patch(e);
    return {patch.m, patch.a, patch.b, patch.c, 1.5};
  }
  return {Vector((e[0] + e[1] + e[2]) / 3), Vector(e[1] - e[0]), Vector(e[2] - e[0]), Vector::Zero(), 1};
}

/// The largest of u · r over the band.
double farthest_along(const Continued& f, bool triangle, const Vector& u) {
  const double at = u.dot(f.m), by_a = u.dot(f.a), by_b = u.dot(f.b);
  if (!triangle) return at + f.end * (std::abs(by_a) + std::abs(by_b)) + f.end * f.end * std::abs(u.dot(f.c));
  // Its corners lie as far from the centroid as 7/4 of those of the triangle.
  constexpr double grown = 1.75;
  return at + grown * std::max({-by_a - by_b, 2 * by_a - by_b, 2 * by_b - by_a}) / 3;
}

}  // namespace

double motion_outside_band(const OutsideBand& pair) {
  // Quads: a tangent changes by 3/4 of the motion where |s|, |t| <= 3/2, a point by 9/8. Triangles: sides by all of it,
  // points by less. The query moves by half.
  const bool triangle = pair.facet.triangle;
  const double tangent_share = triangle ? 1 : 0.75;
  constexpr double point_share = 0.5 + 1.125;
  // Terms of second order in the motion are covered while it changes tangents and normals by at most a tenth.
  constexpr double tenth = 0.1, cover = 1.1 / 0.9, slack = 1e-6;

  const Continued f = continued(pair.facet, pair.query);
  const Vector across = f.a.cross(f.b);
  const double area = across.norm();
  const double warped = f.end * (f.a.cross(f.c).norm() + f.b.cross(f.c).norm());
  const double least_normal = area - warped;
  if (!(least_normal > tenth * area)) return 0;
  const Vector normal = across / area, away = pair.query - pair.closest;
  const Vector in_plane = away - away.dot(normal) * normal;
  const double length = in_plane.norm();
  if (!(length > 0)) return 0;
  const Vector u = in_plane / length;

  const double size = 2 * f.end * (f.a.norm() + f.b.norm()) + 2 * f.end * f.end * f.c.norm();
  const double width = -farthest_along(f, triangle, u) - slack * size;
  const double tangents = f.a.norm() + f.b.norm() + 2 * f.end * f.c.norm();
  const double turn_rate = tangent_share * tangents / least_normal;  // of the normal, per motion
  const double out_of_square =
      f.end * (std::abs(u.dot(f.a.cross(f.c))) + std::abs(u.dot(f.b.cross(f.c)))) / least_normal;
  const double lever = pair.reach + size;
  const double motion = (width - cover * lever * out_of_square) / (point_share + cover * lever * turn_rate);
  const double most = std::min(tenth * tangents / tangent_share, tenth / (1.1 * turn_rate));
  return std::isfinite(motion) ? std::clamp(motion, 0.0, most) : 0;
}

}  // namespace gapcheck::geometry
