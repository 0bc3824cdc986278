#include "geometry/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/patch_polynomials.hpp"
#include "geometry/precise_edge.hpp"
#include "geometry/stationary_point.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry::precise {
namespace {

constexpr int greatest_depth = 40;

/// The point of one edge nearest to the query, in doubles.
struct NearestOnEdge {
  double square;
  bool first, last;  ///< surely this end

  NearestOnEdge(double at_first_end, double at_last_end, double slope_first, double slope_last, double margin)
      : square(slope_first < 0 && slope_last > 0
                   ? at_first_end - slope_first * (slope_first / (slope_last - slope_first))
                   : std::min(at_first_end, at_last_end)),
        first(slope_first > margin),
        last(slope_last < -margin) {}
};

constexpr std::array<std::array<std::size_t, 2>, 4> ends{{{0, 1}, {1, 2}, {3, 2}, {0, 3}}};

/// The four edges of a quad.
class Edges {
 public:
  Edges(const Facet& quad, const Coefficients& k, const Margins& margin)
      : quad_(quad),
        margin_(margin),
        edge_{NearestOnEdge(k.square[0][0], k.square[2][0], k.by_s[0][0], k.by_s[1][0], margin.by_s),
              NearestOnEdge(k.square[2][0], k.square[2][2], k.by_t[2][0], k.by_t[2][1], margin.by_t),
              NearestOnEdge(k.square[0][2], k.square[2][2], k.by_s[0][2], k.by_s[1][2], margin.by_s),
              NearestOnEdge(k.square[0][0], k.square[0][2], k.by_t[0][0], k.by_t[0][1], margin.by_t)} {}

  /// Closer if one edge is, apart if all are.
  [[nodiscard]] Verdict verdict(const Vector& query, double size, double bound) const {
    for (const NearestOnEdge& edge : edge_)
      if (edge.square < margin_.nearer) return Verdict::closer;
    std::array<bool, 4> corner_apart{};
    bool open = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const NearestOnEdge& edge = edge_[i];
      if (edge.square >= margin_.farther) continue;
      const std::size_t corner = ends[i][edge.last ? 1 : 0];
      const bool at_corner = edge.first || edge.last;
      if (at_corner && corner_apart[corner]) continue;
      const Vector &a = quad_.x[ends[i][0]], &b = quad_.x[ends[i][1]];
      const Verdict verdict =
          at_corner ? corner_verdict(quad_.x[corner], query, size, bound) : edge_verdict(a, b, query, size, bound);
      if (verdict == Verdict::closer) return verdict;
      if (at_corner) corner_apart[corner] = verdict == Verdict::apart;
      open = open || verdict != Verdict::apart;
    }
    return open ? Verdict::open : Verdict::apart;
  }

 private:
  const Facet& quad_;
  const Margins& margin_;
  std::array<NearestOnEdge, 4> edge_;
};

bool separated_by_nearest_edge(const Facet& facet, const Vector& query, double size, double bound) {
  const std::size_t corners = facet.triangle ? 3 : 4;
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners; ++i) {
    const double square = closest_point_on_line(facet.x[i], facet.x[(i + 1) % corners], query).squared_distance;
    if (!(square < least)) continue;
    least = square;
    nearest = i;
  }
  const auto& x = facet.x;
  const std::array<Vector, 4> all{x[0], x[1], x[2], x[corners - 1]};
  return separated_by_edge(x[nearest], x[(nearest + 1) % corners], all, query, size, bound);
}

/// The inside of a patch whose edges are apart: its nearest point lies on a piece with a stationary point, or is apart
/// too.
class Inside {
 public:
  Inside(const Facet& quad, const Vector& query, double size, double bound, const Margins& margins, const Sides& d)
      : quad_(quad),
        query_(query),
        size_(size),
        bound_(bound),
        margins_(margins),
        length_s_(share(d.low, d.high, d.left + d.right)),
        length_t_(share(d.left, d.right, d.low + d.high)),
        across_t_(d.left, d.right, d.low + d.high, margins.by_t, margins.by_s),
        across_s_(d.low, d.high, d.left + d.right, margins.by_s, margins.by_t) {}

  /// Looks for a stationary point, beside the one found before.
  void look(const Place& start) {
    std::swap(stationary_[0], stationary_[1]);
    stationary_[0].emplace(quad_, query_, size_, bound_, start);
  }
  [[nodiscard]] Verdict of_all(const Coefficients& all) const {
    if (stationary_[0] && stationary_[0]->closer()) return Verdict::closer;
    return of_piece(all, -1, 1, -1, 1);
  }
  /// Open after so many cuts. `looking`: for stationary points in open pieces.
  [[nodiscard]] Verdict by_pieces(const Coefficients& all, int most_cuts, bool looking) {
    std::array<Piece, greatest_depth + 2> stack;
    std::size_t waiting = 0;
    stack[waiting++].k = all;
    for (int cuts = 1; waiting > 0; ++cuts) {
      const Piece whole = stack[--waiting];
      if (cuts > most_cuts || whole.depth == greatest_depth) return Verdict::open;
      if (looking && (cuts == 2 || cuts == 12 || cuts == 28)) look_in(whole);
      if (stationary_[0] && stationary_[0]->closer()) return Verdict::closer;
      Piece &first = stack[waiting], &last = stack[waiting + 1];
      if ((whole.s1 - whole.s0) * length_s_ >= (whole.t1 - whole.t0) * length_t_)
        cut_s(whole, first, last);
      else
        cut_t(whole, first, last);
      const Verdict one = of_piece(first), other = of_piece(last);
      if (one == Verdict::closer || other == Verdict::closer) return Verdict::closer;
      if (one == Verdict::apart && other == Verdict::open) first = last;
      waiting += (one == Verdict::open ? 1U : 0U) + (other == Verdict::open ? 1U : 0U);
    }
    return Verdict::apart;
  }

 private:
  /// Length to decide which side of a piece is cut. Of slivers, whose short sides may be oblique, the long one first.
  static double share(const Vector& first, const Vector& last, const Vector& other) {
    const double own = first.lpNorm<1>() + last.lpNorm<1>();
    return own < 0.5 * other.lpNorm<1>() && (first + last).cross(other).norm() < 1e-3 * other.squaredNorm() ? own / 16
                                                                                                            : own;
  }
  void look_in(const Piece& p) {
    const Place middle{0.5 * (p.s0 + p.s1), 0.5 * (p.t0 + p.t1)};
    const auto place = stationary_near(Patch(seen_from(quad_, query_)), middle);
    look(place.value_or(middle));
  }
  [[nodiscard]] bool no_slope_across(const Coefficients& k, double s0, double s1, double t0, double t1) const {
    const auto at = [](const Across& g, double x) { return 0.5 * ((1 - x) * g.first + (1 + x) * g.last); };
    const auto by_t = [&](std::size_t i, std::size_t j) { return k.by_t[i][j]; };
    const auto by_s = [&](std::size_t i, std::size_t j) { return k.by_s[i][j]; };
    if (across_t_.never_zero(at(across_t_, s0), at(across_t_, s1), by_t, by_s)) return true;
    return across_s_.never_zero(
        at(across_s_, t0), at(across_s_, t1), [&](std::size_t i, std::size_t j) { return by_s(j, i); },
        [&](std::size_t i, std::size_t j) { return by_t(j, i); });
  }
  [[nodiscard]] Verdict of_piece(const Piece& p) const { return of_piece(p.k, p.s0, p.s1, p.t0, p.t1); }
  [[nodiscard]] Verdict of_piece(const Coefficients& k, double s0, double s1, double t0, double t1) const {
    const auto& f = k.square;
    if (std::min(std::min(f[0][0], f[0][2]), std::min(f[2][0], f[2][2])) < margins_.nearer) return Verdict::closer;
    if (never_zero(k.by_s, margins_.by_s) || never_zero(k.by_t, margins_.by_t) || least(f) >= margins_.farther)
      return Verdict::apart;
    if (no_slope_across(k, s0, s1, t0, t1)) return Verdict::apart;
    for (const auto& point : stationary_)
      if (point && (point->apart_for_t(t0, t1) || point->apart_for_s(s0, s1))) return Verdict::apart;
    return Verdict::open;
  }

  const Facet& quad_;
  const Vector& query_;
  double size_, bound_;
  const Margins& margins_;
  double length_s_, length_t_;
  Across across_t_, across_s_;
  std::array<std::optional<Stationary>, 2> stationary_;
};

/// Then pieces settle more than the plane by the nearest edge.
bool warped_and_wide(const Facet& quad, const Sides& d) {
  const Vector n = quad_normal(quad.x), along_s = d.low + d.high, along_t = d.left + d.right;
  const double area = n.squaredNorm(), warp = n.dot(d.low);
  return area > 1e-6 * along_s.squaredNorm() * along_t.squaredNorm() &&
         warp * warp > 1e-8 * area * (along_s.squaredNorm() + along_t.squaredNorm());
}

}  // namespace

Verdict quad_verdict(const Facet& quad, const Vector& query, double size, double bound,
                     const std::optional<Place>& place) {
  const Sides sides(quad);
  const Margins margins(size, bound, sides);
  const Coefficients all = coefficients(seen_from(quad, query), sides);
  const Edges edges(quad, all, margins);
  if (const Verdict verdict = edges.verdict(query, size, bound); verdict != Verdict::apart) return verdict;
  Inside inside(quad, query, size, bound, margins, sides);
  if (const Verdict verdict = inside.of_all(all); verdict != Verdict::open) return verdict;
  if (place) {
    inside.look(*place);
    if (const Verdict verdict = inside.of_all(all); verdict != Verdict::open) return verdict;
  } else {
    constexpr int few = 6;
    if (warped_and_wide(quad, sides))
      if (const Verdict verdict = inside.by_pieces(all, few, false); verdict != Verdict::open) return verdict;
    if (separated_by_nearest_edge(quad, query, size, bound)) return Verdict::apart;
  }
  // Near the query squares are too small for pieces in doubles.
  return inside.by_pieces(all, bound > 1e-6 * size ? 48 : 16, true);
}

Verdict triangle_edges_verdict(const Facet& triangle, const Vector& query, double size, double bound) {
  const auto& x = triangle.x;
  bool open = false, edge = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector &a = x[i], &b = x[(i + 1) % 3];
    const Verdict verdict = edge_verdict(a, b, query, size, bound);
    if (verdict == Verdict::closer) return verdict;
    open = open || verdict != Verdict::apart;
    edge = edge || a == b;
  }
  if (open) return Verdict::open;
  return edge || separated_by_nearest_edge(triangle, query, size, bound) ? Verdict::apart : Verdict::open;
}

}  // namespace gapcheck::geometry::precise
