#include "reference.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <vector>

namespace gapcheck::geometry::test {
namespace {

template <class Number>
struct Triple {
  Number x, y, z;
  friend Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Triple operator*(const Number& f, const Triple& a) { return {f * a.x, f * a.y, f * a.z}; }
  friend Number operator*(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};

using Rational = Triple<mpq_class>;
Rational rational(const Vector& v) { return {mpq_class(v.x()), mpq_class(v.y()), mpq_class(v.z())}; }

constexpr mp_bitcnt_t bits = 600;
using Long = Triple<mpf_class>;
mpf_class number(double v) { return mpf_class(v, bits); }
Long long_point(const Vector& v) { return {number(v.x()), number(v.y()), number(v.z())}; }

template <class Number>
Number segment(const Triple<Number>& a, const Triple<Number>& b) {
  const Triple<Number> d = b - a;
  const Number length = d * d;
  if (length == 0) return a * a;
  Number ratio = -(a * d) / length;
  if (ratio < 0) ratio = 0;
  if (ratio > 1) ratio = 1;
  const Triple<Number> p = a + ratio * d;
  return p * p;
}

struct LongPatch {
  Long m, a, b, c;
  explicit LongPatch(const std::array<Long, 4>& e)
      : m(number(0.25) * (e[0] + e[1] + e[2] + e[3])),
        a(number(0.25) * (e[1] + e[2] - e[0] - e[3])),
        b(number(0.25) * (e[2] + e[3] - e[0] - e[1])),
        c(number(0.25) * (e[0] + e[2] - e[1] - e[3])) {}
};

mpf_class squared_distance_at(const LongPatch& p, double s, double t) {
  const Long r = p.m + number(s) * p.a + number(t) * p.b + mpf_class(number(s) * t) * p.c;
  return r * r;
}

/// The stationary point near (s, t), to all digits; its squared distance if it lies on the patch.
std::optional<mpf_class> polish(const LongPatch& p, double s0, double t0) {
  mpf_class s = number(s0), t = number(t0);
  for (int step = 0; step < 12; ++step) {
    const Long rs = p.a + t * p.c, rt = p.b + s * p.c, r = p.m + s * p.a + t * p.b + mpf_class(s * t) * p.c;
    const mpf_class gs = r * rs, gt = r * rt, ss = rs * rs, tt = rt * rt, st = rs * rt + r * p.c;
    const mpf_class det = ss * tt - st * st;
    if (det == 0) return std::nullopt;
    const mpf_class ds = (st * gt - tt * gs) / det, dt = (st * gs - ss * gt) / det;
    s += ds;
    t += dt;
    if (abs(ds) + abs(dt) < 1e-75) {
      if (abs(s) > 1 || abs(t) > 1) return std::nullopt;
      const Long end = p.m + s * p.a + t * p.b + mpf_class(s * t) * p.c;
      return mpf_class(end * end);
    }
  }
  return std::nullopt;
}

}  // namespace

mpq_class squared_distance(const Vector& a, const Vector& b, const Vector& query) {
  const Rational q = rational(query);
  return segment(rational(a) - q, rational(b) - q);
}

mpq_class squared_distance(const Vector& a, const Vector& b, const Vector& c, const Vector& query) {
  const Rational q = rational(query), p = rational(a) - q, u = rational(b) - rational(a), v = rational(c) - rational(a);
  mpq_class best =
      std::min({squared_distance(a, b, query), squared_distance(b, c, query), squared_distance(c, a, query)});
  const mpq_class uu = u * u, uv = u * v, vv = v * v, pu = p * u, pv = p * v, det = uu * vv - uv * uv;
  if (det == 0) return best;
  const mpq_class l = (uv * pv - vv * pu) / det, m = (uv * pu - uu * pv) / det;
  if (l < 0 || m < 0 || l + m > 1) return best;
  const Rational foot = p + l * u + m * v;
  return foot * foot;
}

mpf_class squared_distance_of_patch(const Facet& facet, const Vector& query) {
  std::array<Long, 4> e;
  for (std::size_t i = 0; i < 4; ++i) e[i] = long_point(facet.x[i]) - long_point(query);
  mpf_class best = segment(e[0], e[1]);
  for (std::size_t i = 1; i < 4; ++i) best = std::min<mpf_class>(best, segment(e[i], e[(i + 1) % 4]));

  const LongPatch patch(e);
  using LongVector = Eigen::Matrix<long double, 3, 1>;
  const auto low = [](const Long& v) -> LongVector {
    const auto value = [](const mpf_class& x) {
      const double head = x.get_d();
      return head + static_cast<long double>(mpf_class(x - head).get_d());
    };
    return {value(v.x), value(v.y), value(v.z)};
  };
  const LongVector m = low(patch.m), a = low(patch.a), b = low(patch.b), c = low(patch.c);
  std::vector<std::pair<double, double>> found;
  for (double s0 = -1; s0 <= 1; s0 += 0.5) {
    for (double t0 = -1; t0 <= 1; t0 += 0.5) {
      long double s = s0, t = t0;
      for (int sweep = 0; sweep < 12; ++sweep) {
        const LongVector rs = a + t * c;
        if (rs.squaredNorm() > 0) s = std::clamp(-(m + t * b).dot(rs) / rs.squaredNorm(), -1.0L, 1.0L);
        const LongVector rt = b + s * c;
        if (rt.squaredNorm() > 0) t = std::clamp(-(m + s * a).dot(rt) / rt.squaredNorm(), -1.0L, 1.0L);
      }
      best = std::min(best, squared_distance_at(patch, static_cast<double>(s), static_cast<double>(t)));
      for (int step = 0; step < 30; ++step) {
        const LongVector rs = a + t * c, rt = b + s * c, r = m + s * a + t * rt;
        const long double ss = rs.squaredNorm(), tt = rt.squaredNorm(), st = rs.dot(rt) + r.dot(c);
        const long double gs = r.dot(rs), gt = r.dot(rt), det = ss * tt - st * st;
        const long double ds = (st * gt - tt * gs) / det, dt = (st * gs - ss * gt) / det;
        s += ds;
        t += dt;
        if (!(std::abs(s) < 3 && std::abs(t) < 3) || std::abs(ds) + std::abs(dt) < 1e-9L) break;
      }
      if (!(std::abs(s) < 1.01L && std::abs(t) < 1.01L)) continue;
      const std::pair at(static_cast<double>(s), static_cast<double>(t));
      const auto same = [&](const auto& x) {
        return std::abs(x.first - at.first) + std::abs(x.second - at.second) < 1e-6;
      };
      if (std::none_of(found.begin(), found.end(), same)) found.push_back(at);
    }
  }
  for (const auto& [s, t] : found) {
    if (const auto value = polish(patch, s, t); value && *value < best) best = *value;
  }
  return best;
}

mpf_class squared_distance(const Facet& facet, const Vector& query) {
  if (!facet.triangle) return squared_distance_of_patch(facet, query);
  return mpf_class(squared_distance(facet.x[0], facet.x[1], facet.x[2], query), bits);
}

Bracket distance_bracket(const Facet& facet, const Vector& query, double tolerance) {
  struct Piece {
    double low, s0, s1, t0, t1;
    bool operator<(const Piece& other) const { return low > other.low; }
  };
  const auto at = [&](double s, double t) -> Vector {
    return (1 - s) * (1 - t) * facet.x[0] + s * (1 - t) * facet.x[1] + s * t * facet.x[2] + (1 - s) * t * facet.x[3] -
           query;
  };
  double high = std::numeric_limits<double>::infinity();
  const auto piece = [&](double s0, double s1, double t0, double t1) {
    const Vector middle = at((s0 + s1) / 2, (t0 + t1) / 2);
    double reach = 0;
    for (const Vector& corner : {at(s0, t0), at(s1, t0), at(s1, t1), at(s0, t1)}) {
      reach = std::max(reach, (corner - middle).norm());
      high = std::min(high, corner.norm());
    }
    return Piece{std::max(0.0, middle.norm() - reach), s0, s1, t0, t1};
  };
  double size = 0;
  for (const Vector& x : facet.x) size = std::max(size, (x - facet.x[0]).norm());
  std::priority_queue<Piece> open;
  open.push(piece(0, 1, 0, 1));
  for (int step = 0; step < 200000 && high - open.top().low > tolerance * size; ++step) {
    const Piece p = open.top();
    open.pop();
    const double s = (p.s0 + p.s1) / 2, t = (p.t0 + p.t1) / 2;
    open.push(piece(p.s0, s, p.t0, t));
    open.push(piece(s, p.s1, p.t0, t));
    open.push(piece(p.s0, s, t, p.t1));
    open.push(piece(s, p.s1, t, p.t1));
  }
  return {open.top().low, high};
}

}  // namespace gapcheck::geometry::test
