#include "contact/pair/side_filter.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/patch.hpp"
#include "geometry/view.hpp"

namespace gapcheck::contact {
namespace {

/// Rounding in all of the following is a thousand times less, relative to the sizes of facet and distance.
constexpr double margin = 1e-9;
/// |s|, |t| of the projection of nodes in the band, and the barycentric coordinates of those on triangles.
constexpr double beside_band = 1.5, triangle_band = 0.25;
/// Facets that are more tapered, or whose sides make a smaller angle, are left to the closest point.
constexpr double most_taper = 0.4, least_squared_sine = 0.1;

}  // namespace

SideFilter::SideFilter(const PairScene& scene, SegmentIndex s, const geometry::Facet& facet)
    : triangle_(facet.triangle), behind_(scene.behind(s)), corner_(facet.x[0]) {
  if (triangle_)
    take_triangle(facet);
  else
    take_quad(facet);
  if (!scene.flipped.empty() && scene.flipped[s.value]) normal_ = -normal_;
}

void SideFilter::take_triangle(const geometry::Facet& facet) {
  const Vector u = facet.x[1] - corner_, v = facet.x[2] - corner_, n = u.cross(v);
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), nn = n.squaredNorm();
  usable_ = nn >= least_squared_sine * uu * vv && geometry::usable(uu) && geometry::usable(vv);
  if (!usable_) return;
  middle_ = Vector::Zero();
  normal_ = n / std::sqrt(nn);
  dual_a_ = v.cross(n) / nn;
  dual_b_ = n.cross(u) / nn;
  size_ = std::sqrt(std::max(uu, vv));
}

void SideFilter::take_quad(const geometry::Facet& facet) {
  const geometry::Corners e{Vector::Zero(), facet.x[1] - corner_, facet.x[2] - corner_, facet.x[3] - corner_};
  const geometry::Patch patch(e);
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
  const double turn = beside_band * warp_ * (1 + 3 * std::max(alpha, beta)) / (1 - beside_band * (alpha + beta)) / nn;
  const double across = std::abs(a.dot(b));
  slope_s_ = turn * (bb + across);
  slope_t_ = turn * (aa + across);
  constexpr double square = beside_band * beside_band;
  limit_s_ = beside_band + square * (alpha + slope_s_ * warp_) + 1e3 * margin;
  limit_t_ = beside_band + square * (beta + slope_t_ * warp_) + 1e3 * margin;
}

bool SideFilter::beside(const Vector& from_corner) const {
  if (triangle_) {
    const double l1 = from_corner.dot(dual_a_), l2 = from_corner.dot(dual_b_), l0 = 1 - l1 - l2;
    return std::min({l0, l1, l2}) < -(triangle_band + 1e3 * margin);
  }
  const Vector from_middle = from_corner - middle_;
  const double height = std::abs(from_middle.dot(normal_));
  return std::abs(from_middle.dot(dual_a_)) > limit_s_ + slope_s_ * height ||
         std::abs(from_middle.dot(dual_b_)) > limit_t_ + slope_t_ * height;
}

bool SideFilter::apart(const Vector& query, double bound) const {
  if (!usable_) return false;
  const Vector from_corner = query - corner_;
  const double height = normal_.dot(from_corner - middle_);
  const double error = margin * (size_ + from_corner.cwiseAbs().maxCoeff() + std::abs(bound));
  // Of the whole facet, and of the node from its mean plane.
  const double least = std::abs(height) - warp_ - error;
  const bool not_closer = !(bound > 0) || least > bound;
  if (!not_closer) return false;
  if (height > 0 && least > 0) return true;
  return least > behind_ || beside(from_corner);
}

}  // namespace gapcheck::contact
