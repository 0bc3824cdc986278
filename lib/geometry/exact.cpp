#include "geometry/exact.hpp"

#include <CGAL/Mpzf.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gapcheck::geometry::exact {
namespace {

using Number = CGAL::Mpzf;  ///< binary fractions of any length: sums and products of doubles without rounding

struct Point {  // NOLINT(bugprone-exception-escape): the number says that it does not throw, but allocates
  Number x, y, z;
};

Point exact(const Vector& v) { return {Number(v.x()), Number(v.y()), Number(v.z())}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator*(const Number& f, const Point& a) { return {f * a.x, f * a.y, f * a.z}; }
Number dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Number square(const Point& a) { return dot(a, a); }
Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
int sign(const Number& a) { return static_cast<int>(CGAL::sign(a)); }
Number amount(const Number& a) { return sign(a) < 0 ? -a : a; }

/// Segment a b nearer to the origin than the root of `bound`?
bool segment_closer_to_origin(const Point& a, const Point& b, const Number& bound) {
  const Point along = b - a;
  const Number from_a = -dot(a, along), length = square(along);
  if (sign(from_a) <= 0) return square(a) < bound;
  if (from_a >= length) return square(b) < bound;
  return square(cross(a, along)) < bound * length;
}

/// The same for the triangle a b c.
bool triangle_closer_to_origin(const Point& a, const Point& b, const Point& c, const Number& bound) {
  const Point n = cross(b - a, c - a);
  const Number nn = square(n);
  if (sign(nn) > 0 && sign(dot(n, cross(a, b))) >= 0 && sign(dot(n, cross(b, c))) >= 0 &&
      sign(dot(n, cross(c, a))) >= 0) {
    const Number height = dot(n, a);
    return height * height < bound * nn;
  }
  return segment_closer_to_origin(a, b, bound) || segment_closer_to_origin(b, c, bound) ||
         segment_closer_to_origin(c, a, bound);
}

/// Coefficients of the piece's squared distance in Bernstein form: its values lie between the smallest and the largest.
using Coefficients = std::array<std::array<Number, 3>, 3>;  ///< [power of s][power of t]

Coefficients bernstein(const std::array<Point, 4>& p) {
  return {{{square(p[0]), dot(p[0], p[3]), square(p[3])},
           {dot(p[0], p[1]), (dot(p[0], p[2]) + dot(p[1], p[3])) * Number(0.5), dot(p[3], p[2])},
           {square(p[1]), dot(p[1], p[2]), square(p[2])}}};
}

/// 1 if the distance nowhere falls with s, -1 if it nowhere rises, 0 if that is not clear.
int monotone_in_s(const Coefficients& k) {
  bool rises = true, falls = true;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 3; ++j) {
      rises = rises && k[i + 1][j] >= k[i][j];
      falls = falls && k[i + 1][j] <= k[i][j];
    }
  }
  return rises ? 1 : falls ? -1 : 0;
}

Coefficients transposed(const Coefficients& k) {
  Coefficients out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out[i][j] = k[j][i];
  }
  return out;
}

/// Lower bound of q0 + q1 x + q2 x² on [-1, 1], q2 >= 0.
Number least_on_range(const Number& q0, const Number& q1, const Number& q2) {
  const Number swing = amount(q1);
  return swing >= Number(2) * q2 ? q0 + q2 - swing : q0 - Number(0.5) * swing;
}

/// A parameter in [-1, 1] and the slope of half the squared distance along it.
struct Parameter {
  Number value, slope;
  /// The slope leads out of the range: the parameter stays where it is.
  [[nodiscard]] bool held() const {
    return (value == Number(1) && sign(slope) <= 0) || (value == Number(-1) && sign(slope) >= 0);
  }
  [[nodiscard]] Number usable_slope() const { return held() ? Number(0) : slope; }
  void move(double step) {
    value += Number(step);
    if (value > Number(1)) value = Number(1);
    if (value < Number(-1)) value = Number(-1);
  }
};

/// A point of a patch with everything that the proofs need.
struct PatchPoint {
  Point m, a, b, c;
  Parameter s, t;
  Point along_s, along_t, w;

  PatchPoint(const std::array<Point, 4>& p, double s_value, double t_value) {
    const Point low = p[0] + p[1], high = p[3] + p[2], right = p[1] - p[0], left = p[2] - p[3];
    const Number quarter(0.25);
    m = quarter * (low + high);
    a = quarter * (right + left);
    b = quarter * (high - low);
    c = quarter * (left - right);
    s.value = Number(s_value);
    t.value = Number(t_value);
    update();
  }
  void update() {
    along_s = a + t.value * c;
    along_t = b + s.value * c;
    w = m + t.value * b + s.value * along_s;
    s.slope = dot(w, along_s);
    t.slope = dot(w, along_t);
  }
  bool improve();
  [[nodiscard]] bool drop_stays_above(const Number& bound) const;
};

/// One step of Newton's method with exact slopes: about 50 more correct bits. False if there is no sensible step.
bool PatchPoint::improve() {
  const auto value = [](const Number& x) { return CGAL::to_double(x); };
  const double gs = value(s.slope), gt = value(t.slope), ss = value(square(along_s)), tt = value(square(along_t));
  const double st = value(dot(along_s, along_t) + dot(w, c)), det = ss * tt - st * st;
  double ds = 0, dt = 0;
  if (s.held() || t.held()) {
    if (!s.held()) ds = -gs / ss;
    if (!t.held()) dt = -gt / tt;
  } else if (det > 0) {
    ds = (st * gt - tt * gs) / det;
    dt = (st * gs - ss * gt) / det;
  }
  if (!std::isfinite(ds) || !std::isfinite(dt) || (ds == 0 && dt == 0)) return false;
  s.move(ds);
  t.move(dt);
  update();
  return true;
}

/// The proof of largest_drop() without rounding: does the distance never fall below the bound on the piece?
bool PatchPoint::drop_stays_above(const Number& bound) const {
  const Number two(2), aa = square(a), ac = dot(a, c), cc = square(c), tt = square(along_t), turn = dot(c, along_t);
  const Number mixed = dot(a, along_t) + dot(w, c);
  const Number least = least_on_range(tt * aa - mixed * mixed, two * (tt * ac - mixed * turn), tt * cc - turn * turn);
  if (sign(least) <= 0) return false;
  const Number gs = s.usable_slope(), gt = t.usable_slope();
  return (square(w) - bound) * least >= two * (tt * gs * gs + (aa + two * amount(ac) + cc) * gt * gt);
}

bool separated(const std::array<Point, 4>& p, const Point& direction, const Number& bound) {
  const Number length = square(direction), reach = bound * length;
  return sign(length) > 0 && std::all_of(p.begin(), p.end(), [&](const Point& corner) {
           const Number height = dot(direction, corner);
           return sign(height) >= 0 && height * height >= reach;
         });
}

/// False if doubles show that separated() will fail: most points tried on warped patches.
bool may_be_separated(const std::array<Point, 4>& p, const Point& direction, double bound) {
  const auto rounded = [](const Point& a) {
    return Vector(CGAL::to_double(a.x), CGAL::to_double(a.y), CGAL::to_double(a.z));
  };
  const Vector n = rounded(direction);
  const double length = n.norm();
  double least = bound * length, size = 0;
  for (const Point& corner : p) {
    const Vector e = rounded(corner);
    least = std::min(least, n.dot(e));
    size = std::max(size, e.lpNorm<Eigen::Infinity>());
  }
  return !(least < length * (bound - 1e-9 * size));
}

/// What the coefficients alone prove: all of them beyond the bound, or the nearest point on a known edge.
Verdict verdict_of_coefficients(const std::array<Point, 4>& p, const Number& bound) {
  const Coefficients k = bernstein(p);
  const bool all_apart = std::all_of(k.begin(), k.end(), [&](const auto& row) {
    return std::all_of(row.begin(), row.end(), [&](const Number& value) { return value >= bound; });
  });
  if (all_apart) return Verdict::apart;
  const auto edge = [&](std::size_t i) {
    return segment_closer_to_origin(p[i], p[(i + 1) % 4], bound) ? Verdict::closer : Verdict::apart;
  };
  if (const int trend = monotone_in_s(k); trend != 0) return edge(trend > 0 ? 3 : 1);
  if (const int trend = monotone_in_s(transposed(k)); trend != 0) return edge(trend > 0 ? 0 : 2);
  return Verdict::open;
}

std::array<Point, 4> piece_corners(const Facet& facet, const Vector& query, const Piece& piece) {
  const Point q = exact(query), e0 = exact(facet.x[0]) - q, e1 = exact(facet.x[1]) - q, e2 = exact(facet.x[2]) - q,
              e3 = exact(facet.x[3]) - q;
  if (piece.s0 == 0 && piece.s1 == 1 && piece.t0 == 0 && piece.t1 == 1) return {e0, e1, e2, e3};
  const Point right = e1 - e0, up = e3 - e0, twist = e2 - e1 - up;
  const auto at = [&](double s, double t) {
    return e0 + Number(s) * right + Number(t) * up + (Number(s) * Number(t)) * twist;
  };
  return {at(piece.s0, piece.t0), at(piece.s1, piece.t0), at(piece.s1, piece.t1), at(piece.s0, piece.t1)};
}

}  // namespace

bool segment_closer(const Vector& a, const Vector& b, const Vector& query, double bound) {
  const Point q = exact(query);
  return segment_closer_to_origin(exact(a) - q, exact(b) - q, Number(bound) * Number(bound));
}

bool triangle_closer(const Vector& a, const Vector& b, const Vector& c, const Vector& query, double bound) {
  const Point q = exact(query);
  return triangle_closer_to_origin(exact(a) - q, exact(b) - q, exact(c) - q, Number(bound) * Number(bound));
}

bool plane_closer(const Vector& a, const Vector& b, const Vector& c, const Vector& query, double bound) {
  const Point origin = exact(a), n = cross(exact(b) - origin, exact(c) - origin);
  const Number height = dot(n, origin - exact(query)), reach = Number(bound);
  return height * height < reach * reach * square(n);
}

bool edges_closer(const std::array<Vector, 2>& first, const std::array<Vector, 2>& second, double bound) {
  // The parallelogram of all differences between points of the one and the other.
  const Point a = exact(first[0]), b = exact(first[1]), c = exact(second[0]), d = exact(second[1]);
  const Number squared_bound = Number(bound) * Number(bound);
  return triangle_closer_to_origin(c - a, d - a, d - b, squared_bound) ||
         triangle_closer_to_origin(c - a, d - b, c - b, squared_bound);
}

bool fan_closer(const Facet& facet, const Vector& query, double bound) {
  const std::array<Point, 4> p = piece_corners(facet, query, Piece{});
  const Point centre = Number(0.25) * (p[0] + p[1] + p[2] + p[3]);
  const Number squared_bound = Number(bound) * Number(bound);
  for (std::size_t i = 0; i < 4; ++i) {
    if (triangle_closer_to_origin(p[i], p[(i + 1) % 4], centre, squared_bound)) return true;
  }
  return false;
}

bool flat_and_convex(const Facet& facet) {
  const Point x0 = exact(facet.x[0]), x1 = exact(facet.x[1]), x2 = exact(facet.x[2]), x3 = exact(facet.x[3]);
  const std::array<Point, 4> edge{x1 - x0, x2 - x1, x3 - x2, x0 - x3};
  const Point n = cross(x2 - x0, x3 - x1);
  if (sign(dot(n, edge[0])) != 0) return false;
  const bool no_area = sign(square(n)) == 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point turn = cross(edge[i], edge[(i + 1) % 4]);
    if (no_area ? sign(square(turn)) != 0 : sign(dot(turn, n)) < 0) return false;
  }
  return true;
}

Verdict piece_verdict(const Facet& facet, const Vector& query, double bound, const Piece& piece, double s, double t) {
  constexpr int improvements = 3;
  const std::array<Point, 4> p = piece_corners(facet, query, piece);
  const Number squared_bound = Number(bound) * Number(bound);
  PatchPoint point(p, s, t);
  for (int i = 0; i <= improvements; ++i) {
    if (square(point.w) < squared_bound) return Verdict::closer;
    if (may_be_separated(p, point.w, bound) && separated(p, point.w, squared_bound)) return Verdict::apart;
    if (point.drop_stays_above(squared_bound)) return Verdict::apart;
    if (i == 0) {
      if (const Verdict verdict = verdict_of_coefficients(p, squared_bound); verdict != Verdict::open) return verdict;
    }
    if (!point.improve()) break;
  }
  return Verdict::open;
}

int orientation(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const Point q = exact(d);
  return sign(dot(exact(a) - q, cross(exact(b) - q, exact(c) - q)));
}

}  // namespace gapcheck::geometry::exact
