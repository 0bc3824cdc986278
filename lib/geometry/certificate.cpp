#include "geometry/certificate.hpp"

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"
#include "geometry/nearest_slack.hpp"

namespace gapcheck::geometry {
namespace {

/// The part of a slope along one parameter that can lower the value inside [-1, 1]; `margin` bounds the slope's error.
double usable_slope(double slope, double parameter, double margin) {
  if (parameter >= 1 && slope <= -margin) return 0;
  if (parameter <= -1 && slope >= margin) return 0;
  return std::abs(slope) + margin;
}

/// Lower bound of q0 + q1 x + q2 x² on [-1, 1], q2 >= 0; the minimum itself if that lies at an end.
double least_on_range(double q0, double q1, double q2) {
  const double swing = std::abs(q1);
  return swing >= 2 * q2 ? q0 + q2 - swing : q0 - 0.5 * swing;
}

}  // namespace

double largest_drop(const Patch& patch, double s, double t, const Vector& w, double size, double slope_error) {
  const double error = roundoff * size * size;
  const Vector along_s = patch.along_s(t), along_t = patch.along_t(s);
  const double aa = patch.a.squaredNorm(), ac = patch.a.dot(patch.c), cc = patch.c.squaredNorm();
  const double tt = along_t.squaredNorm(), turn = patch.c.dot(along_t);
  const double mixed = patch.a.dot(along_t) + w.dot(patch.c);
  const double least = least_on_range(tt * aa - mixed * mixed, 2 * (tt * ac - mixed * turn), tt * cc - turn * turn) -
                       32768 * error * size * size;
  if (!(least > 0)) return std::numeric_limits<double>::infinity();
  const double gs = usable_slope(w.dot(along_s), s, slope_error), gt = usable_slope(w.dot(along_t), t, slope_error);
  const double ss = aa + 2 * std::abs(ac) + cc + 512 * error;
  return 2.001 * ((tt + 512 * error) * gs * gs + ss * gt * gt) / least;
}

bool Certificate::separated_by(const Corners& e, const Vector& direction) const {
  const double squared_length = direction.squaredNorm();
  // Then no square below vanishes.
  if (!(squared_length >= 1e-150)) return false;
  const double least =
      std::min(std::min(direction.dot(e[0]), direction.dot(e[1])), std::min(direction.dot(e[2]), direction.dot(e[3])));
  const double reach = bound_ * (1 + 64 * roundoff) + slack_;
  return least >= 0 && least * least >= squared_length * (reach * reach);
}

bool Certificate::separated_by_mean_plane(const Corners& e) const {
  const Vector normal = quad_normal(e);
  return separated_by(e, normal.dot(e[0]) < 0 ? Vector(-normal) : normal);
}

Verdict Certificate::at(const Corners& e, double s, double t, bool triangle) const {
  const Vector w = blend(e, quad_weights(s, t));
  const double square = w.squaredNorm(), inside = bound_ - slack_;
  if (inside > 0 && square < inside * inside) return Verdict::closer;
  const double distance = std::sqrt(square);
  if (separated_by(e, w)) return Verdict::apart;
  if (distance < bound_ * (1 + 64 * roundoff) + 2 * slack_) return Verdict::tied;
  if (triangle) return Verdict::open;
  const double least = distance - slack_, bound = std::max(bound_, 1e-100);
  const double lowered = least * least - largest_drop(Patch(e), s, t, w, size_);
  return lowered >= bound * bound * (1 + 64 * roundoff) ? Verdict::apart : Verdict::open;
}

bool is_nearest(const Corners& e, const Patch& patch, double s, double t) {
  const double size = size_of(e);
  const Vector w = blend(e, quad_weights(s, t));
  const double square = w.squaredNorm(), slack = 64 * roundoff * size * std::sqrt(square);
  if (std::all_of(e.begin(), e.end(), [&](const Vector& corner) { return w.dot(corner) >= square - slack; }))
    return true;
  return largest_drop(patch, s, t, w, size) <= nearest_share_of_distance * square + nearest_share_of_size * size * size;
}

}  // namespace gapcheck::geometry
