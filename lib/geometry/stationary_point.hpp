#pragma once
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/pieces.hpp"
#include "geometry/precise_point.hpp"

/// Points inside a patch at which the squared distance from the query is stationary, for pieces.cpp.
namespace gapcheck::geometry::precise {
namespace {

constexpr double squared_roundoff = roundoff * roundoff;

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

inline Stationary::Stationary(const Facet& quad, const Vector& query, double size, double bound, const Place& start)
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

inline void Stationary::evaluate(const Number& squared_bound) {
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
inline bool Stationary::improve() {
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
inline double Stationary::drop(const Vector& a, const Vector& other, double slope_a, double slope_other, double from,
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

/// Newton's method for a stationary point of the squared distance, in doubles.
inline std::optional<Place> stationary_near(const Patch& p, Place at) {
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

}  // namespace
}  // namespace gapcheck::geometry::precise
