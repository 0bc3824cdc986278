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

/// square / scale less than the square of the bound? No bound is as small as the distance 0.
Verdict verdict_of(const Checked& square, const Checked& scale, double bound) {
  if (square.exact && square.value == 0) return Verdict::closer;
  const Checked reach{bound, true}, excess = square - reach * reach * scale;
  if (!excess.exact) return Verdict::open;
  return excess.value < 0 ? Verdict::closer : Verdict::apart;
}

/// The edge from `a` to `b` = a + along in doubles that turn out to be exact.
Verdict verdict_without_rounding(const Point& a, const Point& b, const Point& along, double bound) {
  const CheckedPoint p(a), q(b), d(along);
  const Checked at_a = dot(p, d), at_b = dot(q, d), one{1, true};
  if (!at_a.exact || !at_b.exact) return Verdict::open;
  if (at_a.value >= 0) return verdict_of(dot(p, p), one, bound);
  if (at_b.value <= 0) return verdict_of(dot(q, q), one, bound);
  const CheckedPoint n = cross(p, d);
  return verdict_of(dot(n, n), dot(d, d), bound);
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
  if (a == query || b == query) return Verdict::closer;
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
  if (beside.apart(0)) return Verdict::apart;
  const CheckedPoint p(w);
  return verdict_of(dot(p, p), {1, true}, bound);
}

bool separated_by_edge(const Vector& a, const Vector& b, const std::array<Vector, 4>& corners, const Vector& query,
                       double size, double bound) {
  constexpr int steps = 2;
  const Point from = difference(a, query), along = difference(b, a);
  const Vector d = rounded(along);
  const double length = d.squaredNorm();
  Parameter x = nearest_parameter(rounded(from), d);
  const auto place = [&] {
    return x.at_least() ? from : x.at_greatest() ? difference(b, query) : from + x.value * along;
  };
  Point w = place();
  double slope = dot(w, along).high;
  for (int step = 0; step < steps && !x.held(slope); ++step) {
    const double move = -slope / length;
    if (!(std::abs(move) <= 1)) return false;
    x.move(move);
    w = place();
    slope = dot(w, along).high;
  }
  const bool at_end = x.at_least() || x.at_greatest();
  if (at_end && !x.held(slope)) return false;
  constexpr double squared_roundoff = roundoff * roundoff;
  const double reach = rounded(w).lpNorm<1>();
  const Vector& end = x.at_greatest() ? b : a;
  double fall = 0;
  for (const Vector& corner : corners) {
    if (corner == end || (!at_end && corner == b)) continue;
    const Point side = difference(corner, end);
    const double rise = dot(w, side).high, along_edge = at_end ? 0 : slope * (d.dot(rounded(side)) / length);
    const double error = 16 * roundoff * (std::abs(rise) + std::abs(along_edge)) +
                         64 * squared_roundoff * reach * rounded(side).lpNorm<1>();
    fall = std::max(fall, error - (rise - along_edge));
  }
  // Between the ends the whole line must be apart.
  const double line = at_end ? 0 : 1.001 * slope * slope / length;
  const double rounding = 0x1p20 * squared_roundoff * squared_roundoff * size * size;
  return Beside(w, size, two_product(bound, bound)).apart(4.004 * fall + line + rounding);
}

}  // namespace gapcheck::geometry::precise
