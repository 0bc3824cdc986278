#include "geometry/enclosure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/certificate.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Room for the corners' errors and for those of all that is made of them, as in Certificate.
double slack_of(double size) { return 64 * roundoff * size; }

struct Bounds {
  double lower = 0, upper = infinity;
};

/// How far the plane through the origin at right angles to a direction keeps the corners' hull away.
double kept_away(const Corners& e, const Vector& direction, double slack) {
  const double length = direction.norm();
  if (!(length >= 1e-150)) return 0;
  double least = infinity;
  for (const Vector& corner : e) least = std::min(least, direction.dot(corner));
  return std::max(0.0, least / length * (1 - 64 * roundoff) - slack);
}

/// What the point at (s, t) and the planes prove of one facet or piece.
Bounds bounds_at(const Corners& e, double s, double t, bool triangle, double size) {
  const double slack = slack_of(size);
  const Vector w = blend(e, weights(s, t));
  const double distance = w.norm();
  Bounds out{0, distance * (1 + 8 * roundoff) + slack};
  const Vector normal = triangle ? Vector((e[1] - e[0]).cross(e[2] - e[0])) : Vector((e[2] - e[0]).cross(e[3] - e[1]));
  out.lower = std::max(kept_away(e, w, slack), kept_away(e, normal.dot(e[0]) < 0 ? Vector(-normal) : normal, slack));
  if (triangle || out.lower >= distance - 2 * slack) return out;
  const double least = std::max(0.0, distance * (1 - 8 * roundoff) - slack);
  const double square = least * least - largest_drop(Patch(e), s, t, w, size);
  if (square > 0) out.lower = std::max(out.lower, std::sqrt(square) * (1 - 8 * roundoff));
  return out;
}

/// A rectangle of parameters in [0, 1].
struct Rectangle {
  double s0 = 0, s1 = 1, t0 = 0, t1 = 1;
  double lower = 0;
};

Corners corners_of(const Corners& e, const Rectangle& p) {
  const auto at = [&](double s, double t) { return blend(e, weights(2 * s - 1, 2 * t - 1)); };
  return {at(p.s0, p.t0), at(p.s1, p.t0), at(p.s1, p.t1), at(p.s0, p.t1)};
}

/// Cuts the piece with the lowest bound until the lowest bound is as high as the upper one, or there are too many.
int refine(const Corners& e, double size, int most_pieces, Bounds& bounds) {
  const auto farther = [](const Rectangle& a, const Rectangle& b) { return a.lower > b.lower; };
  std::vector<Rectangle> open{{0, 1, 0, 1, bounds.lower}};
  const double enough = 4 * slack_of(size);
  int pieces = 1;
  while (pieces + 2 <= most_pieces && bounds.upper - open.front().lower > enough) {
    std::pop_heap(open.begin(), open.end(), farther);
    const Rectangle whole = open.back();
    open.pop_back();
    const Corners sides = corners_of(e, whole);
    const bool across_s = (sides[1] - sides[0]).squaredNorm() + (sides[2] - sides[3]).squaredNorm() >=
                          (sides[3] - sides[0]).squaredNorm() + (sides[2] - sides[1]).squaredNorm();
    std::array<Rectangle, 2> halves{whole, whole};
    if (across_s) {
      halves[0].s1 = halves[1].s0 = 0.5 * (whole.s0 + whole.s1);
    } else {
      halves[0].t1 = halves[1].t0 = 0.5 * (whole.t0 + whole.t1);
    }
    for (Rectangle& half : halves) {
      const Corners piece = corners_of(e, half);
      const Location at = locate_on_patch(piece, Patch(piece));
      const bool sound = std::isfinite(at.s) && std::isfinite(at.t);
      const Bounds found = bounds_at(piece, sound ? at.s : 0, sound ? at.t : 0, false, size);
      half.lower = std::max(whole.lower, found.lower);
      bounds.upper = std::min(bounds.upper, found.upper);
      open.push_back(half);
      std::push_heap(open.begin(), open.end(), farther);
    }
    pieces += 2;
  }
  bounds.lower = std::min(open.front().lower, bounds.upper);
  return pieces;
}

}  // namespace

DistanceEnclosure enclose_distance(const Facet& facet, const Vector& query, int most_pieces, const ClosestPoint* hint) {
  const Corners e = seen_from(facet, query);
  const double size = size_of(e);
  if (!usable(size) || !all_finite(facet, query)) return {0, infinity, 0, false};
  double s = 0, t = 0;
  if (hint != nullptr && std::abs(hint->s) <= 1 && std::abs(hint->t) <= 1) {
    s = hint->s;
    t = hint->t;
  } else {
    const Location at = facet.triangle ? locate_on_triangle(e) : locate_on_patch(e, Patch(e));
    if (std::isfinite(at.s) && std::isfinite(at.t)) s = at.s, t = at.t;
  }
  Bounds bounds = bounds_at(e, s, t, facet.triangle, size);
  const double enough = 4 * slack_of(size);
  int pieces = 1;
  if (bounds.upper - bounds.lower > enough) pieces = refine(e, size, most_pieces, bounds);
  return {bounds.lower, bounds.upper, pieces, bounds.upper - bounds.lower <= 1e-13 * size};
}

}  // namespace gapcheck::geometry
