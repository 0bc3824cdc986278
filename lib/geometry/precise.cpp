#include "geometry/precise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/precise_point.hpp"

namespace gapcheck::geometry::precise {
namespace {

Point corner(const Differences& corners, std::size_t i) { return difference(corners.to[i], corners.from[i]); }

/// One step of Newton's method for the least of a function of two parameters. False if nothing moves.
bool improve(Parameter& x, Parameter& y, double slope_x, double slope_y, double xx, double xy, double yy) {
  double dx = 0, dy = 0;
  const double det = xx * yy - xy * xy;
  if (x.held(slope_x) || y.held(slope_y)) {
    if (!x.held(slope_x)) dx = -slope_x / xx;
    if (!y.held(slope_y)) dy = -slope_y / yy;
  } else if (det > 0) {
    dx = (xy * slope_y - yy * slope_x) / det;
    dy = (xy * slope_x - xx * slope_y) / det;
  }
  if (!(std::abs(dx) <= 2 && std::abs(dy) <= 2) || (dx == 0 && dy == 0)) return false;
  x.move(dx);
  y.move(dy);
  return true;
}

constexpr int steps = 3;

/// Upper bound of how much nearer to the origin than at w (in squares) the triangle w + dx u + dy v gets anywhere.
/// `x` and `y` must not fall below 0.
struct TriangleDrop {
  double uu, mixed, vv, slope_x, slope_y, error_x, error_y, least_area, least_square;

  TriangleDrop(const Vector& u, const Vector& v, const Vector& w, double size)
      : uu(u.squaredNorm()), vv(v.squaredNorm()), slope_x(w.dot(u)), slope_y(w.dot(v)) {
    const double length_u = std::sqrt(uu) + 16 * roundoff * size, length_v = std::sqrt(vv) + 16 * roundoff * size;
    const double error = 64 * roundoff * (w.norm() + 512 * roundoff * size);
    error_x = error * length_u;
    error_y = error * length_v;
    mixed = std::abs(u.dot(v)) + 32 * roundoff * length_u * length_v;
    least_area = u.cross(v).norm() - 32 * roundoff * length_u * length_v;
    least_square = 1e-24 * size * size;
  }
  /// Only the other parameter can change for the better: this one, at its end, has the steeper slope.
  [[nodiscard]] bool steep(double slope, double error, double other, double square) const {
    return square >= least_square && slope - error >= 1.001 * other * mixed / square;
  }
  [[nodiscard]] double operator()(bool x_at_end, bool y_at_end) const {
    const bool x_held = x_at_end && slope_x >= error_x, y_held = y_at_end && slope_y >= error_y;
    if (x_held && y_held) return 0;
    const double gx = x_held ? 0 : std::abs(slope_x) + error_x, gy = y_held ? 0 : std::abs(slope_y) + error_y;
    if (x_held && steep(slope_x, error_x, gy, vv)) return 1.001 * gy * gy / vv;
    if (y_held && steep(slope_y, error_y, gx, uu)) return 1.001 * gx * gx / uu;
    if (!(least_area > 0)) return std::numeric_limits<double>::infinity();
    return 2.001 * (vv * gx * gx + uu * gy * gy) / (least_area * least_area);
  }
};

}  // namespace

bool separated_by_axis(const Differences& corners, double bound) {
  for (int axis = 0; axis < 3; ++axis) {
    bool above = true, below = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const Number e = two_sum(corners.to[i][axis], -corners.from[i][axis]);
      above = above && (e.high > bound || (e.high == bound && e.low >= 0));
      below = below && (e.high < -bound || (e.high == -bound && e.low <= 0));
    }
    if (above || below) return true;
  }
  return false;
}

Verdict patch_verdict(const Differences& corners, double size, double bound, double s_trial, double t_trial) {
  const Point e0 = corner(corners, 0), e1 = corner(corners, 1), e2 = corner(corners, 2), e3 = corner(corners, 3);
  const Point low = e0 + e1, high = e3 + e2, right = e1 - e0, left = e2 - e3;
  const Point m = quarter(low + high), a = quarter(right + left), b = quarter(high - low), c = quarter(left - right);
  const Patch patch(rounded(m), rounded(a), rounded(b), rounded(c));
  const Number squared_bound = two_product(bound, bound);
  Parameter s{{s_trial, 0}, -1, 1}, t{{t_trial, 0}, -1, 1};
  for (int step = 0;; ++step) {
    const Point w = (m + t.value * b) + s.value * (a + t.value * c);
    const Beside beside(w, size, squared_bound);
    if (beside.closer()) return Verdict::closer;
    const Vector at = rounded(w), along_s = patch.along_s(t.value.high), along_t = patch.along_t(s.value.high);
    const double error = 64 * roundoff * size * (at.norm() + 512 * roundoff * size);
    if (beside.apart(0) && beside.apart(largest_drop(patch, s.nearly(), t.nearly(), at, size, error)))
      return Verdict::apart;
    if (step == steps || !improve(s, t, at.dot(along_s), at.dot(along_t), along_s.squaredNorm(),
                                  along_s.dot(along_t) + at.dot(patch.c), along_t.squaredNorm()))
      return Verdict::open;
  }
}

Verdict triangle_verdict(const Differences& corners, double size, double bound, double s, double t) {
  const Weights share = quad_weights(s, t);
  const std::array<double, 3> weight{share[0], share[1], share[2] + share[3]};
  // From the corner with the greatest weight the opposite edge is far: only those that meet there limit x and y.
  const std::size_t i = static_cast<std::size_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  const Point e = corner(corners, i), to_j = corner(corners, j) - e, to_k = corner(corners, k) - e;
  const Vector u = rounded(to_j), v = rounded(to_k);
  const Number squared_bound = two_product(bound, bound);
  Parameter x{{weight[j], 0}, 0, 1}, y{{weight[k], 0}, 0, 1};
  for (int step = 0;; ++step) {
    if (!(x.value.high + y.value.high < 0.99)) return Verdict::open;
    const Point w = e + (x.value * to_j + y.value * to_k);
    const Beside beside(w, size, squared_bound);
    if (beside.closer()) return Verdict::closer;
    const TriangleDrop drop(u, v, rounded(w), size);
    if (beside.apart(0) && beside.apart(drop(x.at_least(), y.at_least()))) return Verdict::apart;
    if (step == steps || !improve(x, y, drop.slope_x, drop.slope_y, drop.uu, u.dot(v), drop.vv)) return Verdict::open;
  }
}

}  // namespace gapcheck::geometry::precise
