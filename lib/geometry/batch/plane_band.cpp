#include "geometry/batch/plane_band.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/patch.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry {
namespace {

/// Facets that are more tapered, or whose sides make a smaller angle, are not usable.
constexpr double most_taper = 0.4, least_squared_sine = 0.1;
/// Of parameters: closest_point() has a slack of 1e-9.
constexpr double parameter_margin = 1e-6;

}  // namespace

PlaneBand::PlaneBand(const Facet& facet, double band) : triangle_(facet.triangle), corner_(facet.x[0]) {
  if (triangle_)
    take_triangle(facet, -band / 2);
  else
    take_quad(facet, 1 + band);
}

void PlaneBand::take_triangle(const Facet& facet, double end) {
  const Vector u = facet.x[1] - corner_, v = facet.x[2] - corner_, n = u.cross(v);
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), nn = n.squaredNorm();
  usable_ = nn >= least_squared_sine * uu * vv && geometry::usable(uu) && geometry::usable(vv);
  if (!usable_) return;
  middle_ = Vector::Zero();
  normal_ = n / std::sqrt(nn);
  dual_a_ = v.cross(n) / nn;
  dual_b_ = n.cross(u) / nn;
  size_ = std::sqrt(std::max(uu, vv));
  limit_s_ = end - parameter_margin;
}

void PlaneBand::take_quad(const Facet& facet, double end) {
  const Corners e{Vector::Zero(), facet.x[1] - corner_, facet.x[2] - corner_, facet.x[3] - corner_};
  const Patch patch(e);
  const Vector &a = patch.a, &b = patch.b, &c = patch.c, n = a.cross(b);
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), nn = n.squaredNorm();
  usable_ = nn >= least_squared_sine * aa * bb && geometry::usable(aa) && geometry::usable(bb);
  if (!usable_) return;
  dual_a_ = b.cross(n) / nn;
  dual_b_ = n.cross(a) / nn;
  const double alpha = std::abs(c.dot(dual_a_)), beta = std::abs(c.dot(dual_b_));
  usable_ = alpha + beta <= most_taper;
  middle_ = patch.m;
  normal_ = n / std::sqrt(nn);
  warp_ = std::abs(c.dot(normal_));
  size_ = std::sqrt(std::max(aa, bb));
  // By how much the projection on a warped patch differs from that in its mean plane, per height.
  const double turn = end * warp_ * (1 + 2 * end * std::max(alpha, beta)) / (1 - end * (alpha + beta)) / nn;
  const double across = std::abs(a.dot(b)), square = end * end;
  slope_s_ = turn * (bb + across);
  slope_t_ = turn * (aa + across);
  limit_s_ = end + square * (alpha + slope_s_ * warp_) + parameter_margin;
  limit_t_ = end + square * (beta + slope_t_ * warp_) + parameter_margin;
}

bool PlaneBand::outside(const Vector& query) const {
  const Vector from_corner = query - corner_;
  if (triangle_) {
    const double l1 = from_corner.dot(dual_a_), l2 = from_corner.dot(dual_b_), l0 = 1 - l1 - l2;
    return std::min({l0, l1, l2}) < limit_s_;
  }
  const Vector from_middle = from_corner - middle_;
  const double height = std::abs(from_middle.dot(normal_));
  return std::abs(from_middle.dot(dual_a_)) > limit_s_ + slope_s_ * height ||
         std::abs(from_middle.dot(dual_b_)) > limit_t_ + slope_t_ * height;
}

}  // namespace gapcheck::geometry
