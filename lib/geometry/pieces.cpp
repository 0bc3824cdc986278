#include "geometry/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/precise_edge.hpp"
#include "geometry/precise_point.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry::precise {
namespace {

constexpr double squared_roundoff = roundoff * roundoff;
constexpr int greatest_depth = 40;

/// Coefficients in Bernstein form, over the patch or a piece of it: of the squared distance, and of half its
/// derivatives, all as [power of s][power of t].
struct Coefficients {
  std::array<std::array<double, 3>, 3> square;
  std::array<std::array<double, 3>, 2> by_s;
  std::array<std::array<double, 2>, 3> by_t;
};

/// The sides of a quad as differences of its own corners: their errors are relative to themselves.
struct Sides {
  Vector low, high, left, right;
  explicit Sides(const Facet& quad)
      : low(quad.x[1] - quad.x[0]),
        high(quad.x[2] - quad.x[3]),
        left(quad.x[3] - quad.x[0]),
        right(quad.x[2] - quad.x[1]) {}
};

Coefficients coefficients(const Corners& e, const Sides& d) {
  const auto mean = [](double a, double b) { return 0.5 * (a + b); };
  Coefficients k;
  k.square = {{{e[0].squaredNorm(), e[0].dot(e[3]), e[3].squaredNorm()},
               {e[0].dot(e[1]), mean(e[0].dot(e[2]), e[1].dot(e[3])), e[3].dot(e[2])},
               {e[1].squaredNorm(), e[1].dot(e[2]), e[2].squaredNorm()}}};
  k.by_s = {{{e[0].dot(d.low), mean(e[0].dot(d.high), e[3].dot(d.low)), e[3].dot(d.high)},
             {e[1].dot(d.low), mean(e[1].dot(d.high), e[2].dot(d.low)), e[2].dot(d.high)}}};
  k.by_t = {{{e[0].dot(d.left), e[3].dot(d.left)},
             {mean(e[0].dot(d.right), e[1].dot(d.left)), mean(e[3].dot(d.right), e[2].dot(d.left))},
             {e[1].dot(d.right), e[2].dot(d.right)}}};
  return k;
}

/// What the coefficients must exceed. Their errors, halvings included, are below 512 roundoffs of their size.
struct Margins {
  double nearer, farther, by_s, by_t;

  Margins(double size, double bound, const Sides& d) {
    const double error = 512 * roundoff * size;
    nearer = bound * bound * (1 - 8 * roundoff) - error * size;
    farther = bound * bound * (1 + 8 * roundoff) + error * size;
    by_s = error * std::max(d.low.lpNorm<1>(), d.high.lpNorm<1>()) + 1e-290;
    by_t = error * std::max(d.left.lpNorm<1>(), d.right.lpNorm<1>()) + 1e-290;
  }
};

template <class Table>
double least(const Table& k) {
  double out = std::numeric_limits<double>::infinity();
  for (const auto& row : k)
    for (const double value : row) out = std::min(out, value);
  return out;
}
template <class Table>
double greatest(const Table& k) {
  double out = -std::numeric_limits<double>::infinity();
  for (const auto& row : k)
    for (const double value : row) out = std::max(out, value);
  return out;
}
/// The derivative is nowhere zero.
template <class Table>
bool never_zero(const Table& k, double margin) {
  return least(k) > margin || greatest(k) < -margin;
}

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

/// A point inside the patch at which the squared distance is stationary, to about 30 digits.
class Stationary {
 public:
  Stationary(const Facet& quad, const Vector& query, double size, double bound, const Place& start);
  [[nodiscard]] bool closer() const { return beside_.closer(); }
  /// Nothing on the patch between two values of t is nearer than the bound.
  [[nodiscard]] bool apart_for_t(double t0, double t1) const {
    return beside_.apart(drop(a_, b_at_s_, slope_s_, slope_t_, t0, t1));
  }
  [[nodiscard]] bool apart_for_s(double s0, double s1) const {
    return beside_.apart(drop(b_, a_at_t_, slope_t_, slope_s_, s0, s1));
  }

 private:
  void evaluate(const Number& squared_bound);
  bool improve();
  [[nodiscard]] double drop(const Vector& a, const Vector& other, double slope_a, double slope_other, double from,
                            double to) const;

  Point exact_m_, exact_a_, exact_b_, exact_c_;
  Number exact_slope_s_, exact_slope_t_, exact_ss_, exact_st_, exact_tt_;
  Vector a_, b_, c_, a_at_t_, b_at_s_, w_;
  Parameter s_, t_;
  double size_, slope_s_ = 0, slope_t_ = 0, twist_ = 0, last_move_ = 1;
  Beside beside_;
};

Stationary::Stationary(const Facet& quad, const Vector& query, double size, double bound, const Place& start)
    : s_{{start.s, 0}, -1, 1}, t_{{start.t, 0}, -1, 1}, size_(size) {
  const Point e0 = difference(quad.x[0], query), e1 = difference(quad.x[1], query), e2 = difference(quad.x[2], query),
              e3 = difference(quad.x[3], query);
  const Point low = e0 + e1, high = e3 + e2, right = e1 - e0, left = e2 - e3;
  exact_m_ = quarter(low + high);
  exact_a_ = quarter(right + left);
  exact_b_ = quarter(high - low);
  exact_c_ = quarter(left - right);
  a_ = rounded(exact_a_);
  b_ = rounded(exact_b_);
  c_ = rounded(exact_c_);
  const Number squared_bound = two_product(bound, bound);
  constexpr int steps = 12;
  evaluate(squared_bound);
  for (int step = 0; step < steps && !closer() && improve(); ++step) evaluate(squared_bound);
}

void Stationary::evaluate(const Number& squared_bound) {
  const Point along_s = exact_a_ + t_.value * exact_c_, along_t = exact_b_ + s_.value * exact_c_;
  const Point w = (exact_m_ + t_.value * exact_b_) + s_.value * along_s;
  w_ = rounded(w);
  a_at_t_ = rounded(along_s);
  b_at_s_ = rounded(along_t);
  exact_slope_s_ = dot(w, along_s);
  exact_slope_t_ = dot(w, along_t);
  slope_s_ = exact_slope_s_.high;
  slope_t_ = exact_slope_t_.high;
  twist_ = dot(w, exact_c_).high;
  exact_ss_ = square(along_s);
  exact_st_ = dot(along_s, along_t);
  exact_tt_ = square(along_t);
  beside_ = Beside(w, size_, squared_bound);
}

/// One step of Newton's method; without the twist (Gauss and Newton) where the square is not convex. On slivers
/// products cancel to a millionth of a millionth: hence the cross product, and the steps from numbers of 106 bits.
bool Stationary::improve() {
  const double area = a_at_t_.cross(b_at_s_).squaredNorm(), convex = area - twist_ * (2 * exact_st_.high + twist_);
  const bool thin = area < 1e-6 * exact_ss_.high * exact_tt_.high && !(std::abs(convex - area) <= 0.5 * area);
  const double twist = convex > 0 && !thin ? twist_ : 0, det = convex > 0 && !thin ? convex : area;
  const Number st = exact_st_ + Number{twist, 0};
  const double ds = (st * exact_slope_t_ - exact_tt_ * exact_slope_s_).high / det;
  const double dt = (st * exact_slope_s_ - exact_ss_ * exact_slope_t_).high / det;
  const double moved = std::abs(ds) + std::abs(dt);
  if (!(moved <= 4) || last_move_ < 1e-12) return false;
  last_move_ = moved;
  s_.move(ds);
  t_.move(dt);
  return true;
}

/// Upper bound of how much smaller than here the squared distance gets anywhere between two values of the parameter
/// along `other`, whose derivative here is `other`; the derivative along the other parameter is a + value c.
double Stationary::drop(const Vector& a, const Vector& other, double slope_a, double slope_other, double from,
                        double to) const {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  const double length_c = c_.norm(), length_a = a.norm() + length_c, length_b = other.norm() + length_c;
  const Vector here = a + middle * c_, n = here.cross(other), turn = c_.cross(other);
  const double q0 = n.squaredNorm() - twist_ * (2 * here.dot(other) + twist_);
  const double swing = 2 * half * std::abs(n.dot(turn) - twist_ * c_.dot(other));
  const double curve = half * half * turn.squaredNorm();
  const double product = length_a * length_b, rounding = squared_roundoff * size_;
  const double error_n = 32 * roundoff * product + 128 * rounding * (length_a + length_b);
  const double error_twist = 4 * roundoff * std::abs(twist_) + 1024 * rounding * (w_.norm() + length_c);
  const double error = 5 * error_n * (n.norm() + half * turn.norm()) + 2.1 * product * error_twist +
                       8 * std::abs(twist_) * (error_n + error_twist) + 2 * error_twist * error_twist;
  const double least_q = (swing >= 2 * curve ? q0 + curve - swing : q0 - 0.5 * swing) - error;
  if (!(least_q > 1e-250)) return std::numeric_limits<double>::infinity();
  const double ga = std::abs(slope_a) + 1024 * rounding * (w_.norm() + length_a),
               gb = std::abs(slope_other) + 1024 * rounding * (w_.norm() + length_b);
  return (2.002 * (length_b * length_b * ga * ga + length_a * length_a * gb * gb) + 1e-290) / least_q;
}

/// A direction across the patch, r_t - g(s) r_s or r_s - g(t) r_t with a linear g: chosen at right angles to the mean
/// of the other sides, since along a sliver both slopes are zero nearly at the same places.
struct Across {
  double first, last, margin;  ///< g at the ends of its range
  Across(const Vector& side_first, const Vector& side_last, const Vector& other, double own_margin,
         double other_margin) {
    const double square = other.squaredNorm();
    first = side_first.dot(other) / square;
    last = side_last.dot(other) / square;
    margin = 2 * (own_margin + std::max(std::abs(first), std::abs(last)) * other_margin);
  }
  /// The slope across is nowhere zero on a piece, where g goes from `from` to `to`. `own` and `other`: coefficients of
  /// the slopes along both parameters, [power of the parameter of g][power of the other].
  template <class Own, class Other>
  [[nodiscard]] bool never_zero(double from, double to, const Own& own, const Other& other) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto raised = [&](std::size_t i) {
        return j == 0 ? own(i, 0) : j == 2 ? own(i, 1) : 0.5 * (own(i, 0) + own(i, 1));
      };
      const double slopes[] = {raised(0) - from * other(0, j),
                               raised(1) - 0.5 * (from * other(1, j) + to * other(0, j)), raised(2) - to * other(1, j)};
      for (const double slope : slopes) {
        low = std::min(low, slope);
        high = std::max(high, slope);
      }
    }
    return low > margin || high < -margin;
  }
};

/// A part of the patch, its parameters in [-1, 1].
struct Piece {
  Coefficients k;
  double s0 = -1, s1 = 1, t0 = -1, t1 = 1;
  int depth = 0;
};

/// The halves of a piece, cut at a value of s.
void cut_s(const Piece& piece, Piece& first, Piece& last) {
  first = last = piece;
  ++first.depth, ++last.depth;
  first.s1 = last.s0 = 0.5 * (piece.s0 + piece.s1);
  const auto cut = [](const auto& k, auto& low, auto& high, std::size_t j) {
    const double before = 0.5 * (k[0][j] + k[1][j]), after = 0.5 * (k[1][j] + k[2][j]);
    low[1][j] = before;
    high[1][j] = after;
    low[2][j] = high[0][j] = 0.5 * (before + after);
  };
  for (std::size_t j = 0; j < 3; ++j) cut(piece.k.square, first.k.square, last.k.square, j);
  for (std::size_t j = 0; j < 2; ++j) cut(piece.k.by_t, first.k.by_t, last.k.by_t, j);
  for (std::size_t j = 0; j < 3; ++j)
    first.k.by_s[1][j] = last.k.by_s[0][j] = 0.5 * (piece.k.by_s[0][j] + piece.k.by_s[1][j]);
}

/// The same at a value of t.
void cut_t(const Piece& piece, Piece& first, Piece& last) {
  first = last = piece;
  ++first.depth, ++last.depth;
  first.t1 = last.t0 = 0.5 * (piece.t0 + piece.t1);
  const auto cut = [](const auto& k, auto& low, auto& high) {
    const double before = 0.5 * (k[0] + k[1]), after = 0.5 * (k[1] + k[2]);
    low[1] = before;
    high[1] = after;
    low[2] = high[0] = 0.5 * (before + after);
  };
  for (std::size_t i = 0; i < 3; ++i) cut(piece.k.square[i], first.k.square[i], last.k.square[i]);
  for (std::size_t i = 0; i < 2; ++i) cut(piece.k.by_s[i], first.k.by_s[i], last.k.by_s[i]);
  for (std::size_t i = 0; i < 3; ++i)
    first.k.by_t[i][1] = last.k.by_t[i][0] = 0.5 * (piece.k.by_t[i][0] + piece.k.by_t[i][1]);
}

/// Newton's method for a stationary point of the squared distance, in doubles.
std::optional<Place> stationary_near(const Patch& p, Place at) {
  for (int step = 0; step < 10; ++step) {
    const Vector along_s = p.along_s(at.t), along_t = p.along_t(at.s), w = p.m + at.t * p.b + at.s * along_s;
    const double gs = w.dot(along_s), gt = w.dot(along_t), ss = along_s.squaredNorm(), tt = along_t.squaredNorm();
    const double mixed = along_s.dot(along_t), twist = w.dot(p.c), st = mixed + twist;
    const double det = ss * tt - st * st;
    if (!(det > 1e-6 * ss * tt)) return std::nullopt;
    const double ds = (st * gt - tt * gs) / det, dt = (st * gs - ss * gt) / det, moved = std::abs(ds) + std::abs(dt);
    if (!(moved < 2)) return std::nullopt;
    at = {at.s + ds, at.t + dt};
    if (!(std::abs(at.s) < 1.5 && std::abs(at.t) < 1.5)) return std::nullopt;
    if (moved < 1e-9) return std::abs(at.s) < 1 && std::abs(at.t) < 1 ? std::optional(at) : std::nullopt;
  }
  return std::nullopt;
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
    const double thin = 1e-6 * (sides.low + sides.high).squaredNorm() * (sides.left + sides.right).squaredNorm();
    if (quad_normal(quad.x).squaredNorm() > thin)
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
