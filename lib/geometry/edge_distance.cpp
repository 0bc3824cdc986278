#include "geometry/edge_distance.hpp"

#include <cmath>
#include <limits>

#include "geometry/certificate.hpp"
#include "geometry/exact.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry {
namespace {

/// Parallel edges are as near at an end as between the ends, up to rounding.
constexpr double equally_near = 1e-9;

bool has_finite_ends(const Edge& edge) { return edge[0].allFinite() && edge[1].allFinite(); }

/// Where the common perpendicular of the two lines meets them, if that is between the ends.
bool between_ends(const Edge& first, const Edge& second, EdgesClosest& c) {
  const Vector u = first[1] - first[0], v = second[1] - second[0], w = second[0] - first[0];
  const Vector n = u.cross(v);
  const double nn = n.squaredNorm();
  if (!(nn > 0)) return false;
  const double a = v.dot(n.cross(w)) / nn, b = u.dot(n.cross(w)) / nn;
  if (!(a > 0 && a < 1 && b > 0 && b < 1)) return false;
  c.s = 2 * a - 1;
  c.t = 2 * b - 1;
  c.first = first[0] + a * u;
  c.second = second[0] + b * v;
  c.squared_distance = (c.first - c.second).squaredNorm();
  return true;
}

/// The end that lies nearest to the other edge.
EdgesClosest nearest_end(const Edge& first, const Edge& second) {
  EdgesClosest best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  for (std::size_t end = 0; end < 2; ++end) {
    const double at = end == 0 ? -1 : 1;
    if (const auto p = closest_point_on_line(second[0], second[1], first[end]);
        p.squared_distance < best.squared_distance)
      best = {first[end], p.point, p.squared_distance, p.squared_distance, at, p.s, false};
    if (const auto p = closest_point_on_line(first[0], first[1], second[end]);
        p.squared_distance < best.squared_distance)
      best = {p.point, second[end], p.squared_distance, p.squared_distance, p.s, at, false};
  }
  return best;
}

}  // namespace

EdgesClosest closest_points(const Edge& first, const Edge& second) {
  EdgesClosest best = nearest_end(first, second);
  EdgesClosest inside;
  if (between_ends(first, second, inside) && inside.squared_distance < best.squared_distance * (1 - equally_near)) {
    inside.squared_end_distance = best.squared_distance;
    inside.interior = true;
    return inside;
  }
  return best;
}

Decision decide_edges(const Edge& first, const Edge& second, double bound, Mode mode, const EdgesClosest* hint) {
  if (!(bound > 0)) return {false, Stage::filter};
  // The differences of two points, one from each edge, are the points of a parallelogram: the edges are as near to each
  // other as it is to the origin.
  if (mode == Mode::filtered) {
    const Corners e{second[0] - first[0], second[0] - first[1], second[1] - first[1], second[1] - first[0]};
    if (separated_by_axis(e, bound)) return {false, Stage::filter};
    const double size = size_of(e);
    if (usable(size)) {
      const Certificate certificate(size, bound);
      const EdgesClosest closest = hint != nullptr ? *hint : closest_points(first, second);
      const Verdict verdict = certificate.at(e, closest.s, closest.t, true);
      if (verdict == Verdict::closer || verdict == Verdict::apart) return {verdict == Verdict::closer, Stage::filter};
    }
  }
  if (!has_finite_ends(first) || !has_finite_ends(second)) return {false, Stage::exact};
  return {std::isinf(bound) || exact::edges_closer(first, second, bound), Stage::exact};
}

}  // namespace gapcheck::geometry
