#include "geometry/exact_quick.hpp"

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"
#include "geometry/closest_point.hpp"
#include "geometry/decide.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry::exact {
namespace {

/// Error of a product of four lengths below `size`, made of differences: docs/theory/decisions.md.
double error_of_turn(double size) { return 1024 * roundoff * size * size * size * size; }

enum class Sign : std::uint8_t { negative, unsure, positive };

/// The smallest of some numbers, each off by at most `error`: positive if all certainly are, negative if one certainly
/// is.
Sign sign_of_least(double least, double error) {
  return least > error ? Sign::positive : least < -error ? Sign::negative : Sign::unsure;
}

bool quick_segment_closer(const Vector& a, const Vector& b, const Vector& query, double bound) {
  const Corners e{a - query, b - query, b - query, a - query};
  if (separated_by_axis(e, bound)) return false;
  const double size = size_of(e);
  if (usable(size)) {
    const double s = closest_point_on_line(e[0], e[1], Vector::Zero()).s;
    const Verdict verdict = Certificate(size, bound).at(e, s, -1, true);
    if (verdict == Verdict::closer || verdict == Verdict::apart) return verdict == Verdict::closer;
  }
  return segment_closer(a, b, query, bound);
}

}  // namespace

bool quick_triangle_closer(const Vector& a, const Vector& b, const Vector& c, const Vector& query, double bound) {
  const Corners e{a - query, b - query, c - query, c - query};
  const double size = size_of(e);
  if (!usable(size)) return triangle_closer(a, b, c, query, bound);
  const Vector n = (e[1] - e[0]).cross(e[2] - e[0]);
  const double least = std::min({n.dot(e[0].cross(e[1])), n.dot(e[1].cross(e[2])), n.dot(e[2].cross(e[0]))});
  const Sign inside = sign_of_least(least, error_of_turn(size));
  if (inside == Sign::positive) return plane_closer(a, b, c, query, bound);
  if (inside == Sign::unsure) return triangle_closer(a, b, c, query, bound);
  return quick_segment_closer(a, b, query, bound) || quick_segment_closer(b, c, query, bound) ||
         quick_segment_closer(c, a, query, bound);
}

bool quick_flat_and_convex(const Facet& facet) {
  const auto& x = facet.x;
  if (decide_side(x[0], x[1], x[2], x[3], Mode::filtered).sign != 0) return false;
  const Corners e = seen_from(facet, x[0]);
  const double size = size_of(e);
  if (!usable(size)) return flat_and_convex(facet);
  const Vector n = quad_normal(e);
  const std::array<Vector, 4> edge{e[1] - e[0], e[2] - e[1], e[3] - e[2], e[0] - e[3]};
  const auto turn = [&](std::size_t i) { return n.dot(edge[i].cross(edge[(i + 1) % 4])); };
  const Sign convex = sign_of_least(std::min({turn(0), turn(1), turn(2), turn(3)}), error_of_turn(2 * size));
  return convex == Sign::unsure ? flat_and_convex(facet) : convex == Sign::positive;
}

}  // namespace gapcheck::geometry::exact
