#include "geometry/precise_edge.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/precise_point.hpp"

namespace gapcheck::geometry::precise {
namespace {

/// A number with the knowledge whether it is without rounding.
struct Checked {
  double value = 0;
  bool exact = true;
};

Checked checked(const Number& result, bool operands) { return {result.high, operands && result.low == 0}; }
Checked operator+(const Checked& a, const Checked& b) { return checked(two_sum(a.value, b.value), a.exact && b.exact); }
Checked operator-(const Checked& a, const Checked& b) { return a + Checked{-b.value, b.exact}; }
/// Products that are too small to have all their digits count as rounded.
Checked operator*(const Checked& a, const Checked& b) {
  const Number product = two_product(a.value, b.value);
  const bool sound = std::abs(product.high) > 1e-250 || a.value == 0 || b.value == 0;
  return checked(product, sound && a.exact && b.exact);
}

struct CheckedPoint {
  Checked x, y, z;
  explicit CheckedPoint(const Point& p)
      : x{p.xy.high[0], p.xy.low[0] == 0}, y{p.xy.high[1], p.xy.low[1] == 0}, z{p.z.high[0], p.z.low[0] == 0} {}
  CheckedPoint(const Checked& x_, const Checked& y_, const Checked& z_) : x(x_), y(y_), z(z_) {}
};

Checked dot(const CheckedPoint& a, const CheckedPoint& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
CheckedPoint cross(const CheckedPoint& a, const CheckedPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Verdict verdict_of(const Checked& excess) {
  if (!excess.exact) return Verdict::open;
  return excess.value < 0 ? Verdict::closer : Verdict::apart;
}

/// The edge from `a` to `b` = a + along in doubles that turn out to be exact.
Verdict verdict_without_rounding(const Point& a, const Point& b, const Point& along, double bound) {
  const CheckedPoint p(a), q(b), d(along);
  const Checked reach{bound, true}, squared_bound = reach * reach;
  const Checked at_a = dot(p, d), at_b = dot(q, d);
  if (!at_a.exact || !at_b.exact) return Verdict::open;
  if (at_a.value >= 0) return verdict_of(dot(p, p) - squared_bound);
  if (at_b.value <= 0) return verdict_of(dot(q, q) - squared_bound);
  const CheckedPoint n = cross(p, d);
  return verdict_of(dot(n, n) - squared_bound * dot(d, d));
}

Verdict corner_without_rounding(const Point& a, double bound) {
  const CheckedPoint p(a);
  const Checked reach{bound, true};
  return verdict_of(dot(p, p) - reach * reach);
}

/// The parameter of the point of a + x d nearest to the origin, in doubles.
Parameter nearest_parameter(const Vector& a, const Vector& d) {
  const double length = d.squaredNorm(), ratio = length > 0 ? -a.dot(d) / length : 0;
  return {{std::isfinite(ratio) ? std::clamp(ratio, 0.0, 1.0) : 0, 0}, 0, 1};
}

/// Upper bound of how much nearer to the origin (in squares) than at w = a + x d the edge gets anywhere.
double drop_along(const Parameter& x, double slope, const Vector& w, const Vector& d, double size) {
  const double reach = w.lpNorm<1>() + 512 * roundoff * size, length = d.lpNorm<1>();
  const double error = 16 * roundoff * reach * length + 1e-290;
  if ((x.at_least() && slope >= error) || (x.at_greatest() && slope <= -error)) return 0;
  const double any = 2.001 * reach * length, square = d.squaredNorm(), steepest = std::abs(slope) + error;
  return square >= 1e-60 * size * size ? std::min(any, 1.001 * steepest * steepest / square) : any;
}

}  // namespace

Verdict edge_verdict(const Vector& a, const Vector& b, const Vector& query, double size, double bound) {
  constexpr int steps = 2;
  const Point from = difference(a, query), to = difference(b, query), along = difference(b, a);
  const Vector d = rounded(along);
  const Number squared_bound = two_product(bound, bound);
  const double length = d.squaredNorm();
  Parameter x = nearest_parameter(rounded(from), d);
  for (int step = 0;; ++step) {
    const Point w = x.at_least() ? from : x.at_greatest() ? to : from + x.value * along;
    const Beside beside(w, size, squared_bound);
    if (beside.closer()) return Verdict::closer;
    const Vector at = rounded(w);
    const double slope = at.dot(d);
    if (beside.apart(drop_along(x, slope, at, d, size))) return Verdict::apart;
    const double move = -slope / length;
    if (step == steps || !(std::abs(move) <= 1) || move == 0 || x.held(slope)) break;
    x.move(move);
  }
  return verdict_without_rounding(from, to, along, bound);
}

Verdict corner_verdict(const Vector& a, const Vector& query, double size, double bound) {
  const Point w = difference(a, query);
  const Beside beside(w, size, two_product(bound, bound));
  if (beside.closer()) return Verdict::closer;
  return beside.apart(0) ? Verdict::apart : corner_without_rounding(w, bound);
}

bool separated_by_edge(const Vector& a, const Vector& b, const std::array<Vector, 4>& corners, const Vector& query,
                       double size, double bound) {
  constexpr int steps = 2;
  // From the end that is nearer: the other would bring errors of its own size.
  const bool from_b = (b - query).squaredNorm() < (a - query).squaredNorm();
  const Point from = difference(from_b ? b : a, query), along = from_b ? difference(a, b) : difference(b, a);
  const Vector d = rounded(along);
  const double length = d.squaredNorm();
  Parameter x = nearest_parameter(rounded(from), d);
  Point w = from + x.value * along;
  for (int step = 0; step < steps; ++step) {
    const double slope = dot(w, along).high, move = -slope / length;
    if (!(std::abs(move) <= 1) || x.held(slope)) break;
    x.move(move);
    w = from + x.value * along;
  }
  constexpr double squared_roundoff = roundoff * roundoff;
  const Number ww = square(w);
  if (!(ww.high >= 1e-40 * size * size)) return false;
  const double error = 32 * squared_roundoff * size * rounded(w).lpNorm<1>();
  for (const Vector& corner : corners) {
    const Number height = dot(difference(corner, query), w) + Number{-error, 0};
    if (!(height.high > 0)) return false;
    const Number square = height * height, reach = two_product(bound, bound) * ww;
    if (!((square - reach).high > 256 * squared_roundoff * (square.high + reach.high))) return false;
  }
  return true;
}

}  // namespace gapcheck::geometry::precise
