#include "reference/tie_reference.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace gapcheck::reference {
namespace {

using Real = long double;
using Point = Eigen::Matrix<Real, 3, 1>;
using PatchPlace = Eigen::Matrix<Real, 2, 1>;

/// Limits are sums of doubles in the program, and coordinates enter here with 64 digits.
constexpr Real doubt_of_limit = 1e-15L, doubt_of_coordinates = 1e-17L;

Point point(const Vector& x) { return x.cast<Real>(); }

Real to_edge(const Point& a, const Point& b, const Point& q) {
  const Real length = (b - a).squaredNorm();
  const Real u = length > 0 ? std::clamp<Real>((q - a).dot(b - a) / length, 0, 1) : 0;
  return (a + u * (b - a) - q).norm();
}

/// How far the foot lies from the middle, as PARMAX counts (1 on the border), and the distance from the segment.
struct Foot {
  Real reach = std::numeric_limits<Real>::infinity(), distance = std::numeric_limits<Real>::infinity();
  bool found = true;
};

Foot foot_on_triangle(const std::array<Point, 4>& x, const Point& q) {
  const Point u = x[1] - x[0], v = x[2] - x[0], n = u.cross(v), w = q - x[0];
  const Real area = n.squaredNorm();
  const Real l1 = w.cross(v).dot(n) / area, l2 = u.cross(w).dot(n) / area;
  const Real lowest = std::min({1 - l1 - l2, l1, l2});
  Foot foot;
  // A quad's parameter runs over 2 from edge to edge, a barycentric coordinate over 1.
  foot.reach = 1 - 2 * lowest;
  for (int i = 0; i < 3; ++i) foot.distance = std::min(foot.distance, to_edge(x[i], x[(i + 1) % 3], q));
  if (lowest > 0) foot.distance = (w - l1 * u - l2 * v).norm();
  return foot;
}

std::optional<PatchPlace> newton(const std::array<Point, 4>& r, const Point& q, PatchPlace p) {
  for (int step = 0; step < 80; ++step) {
    const Point s = r[1] + p[1] * r[3], t = r[2] + p[0] * r[3];
    const Point at = r[0] + p[0] * r[1] + p[1] * r[2] + p[0] * p[1] * r[3] - q;
    const Real ss = s.squaredNorm(), tt = t.squaredNorm(), st = s.dot(t) + r[3].dot(at), gs = s.dot(at), gt = t.dot(at);
    const Real det = ss * tt - st * st;
    if (!(std::abs(det) > 1e-16L * ss * tt)) return std::nullopt;
    const PatchPlace move{(tt * gs - st * gt) / det, (ss * gt - st * gs) / det};
    p -= move;
    if (!(p.cwiseAbs().maxCoeff() < 1e4L)) return std::nullopt;
    if (move.cwiseAbs().maxCoeff() < 1e-17L) return p;
  }
  return std::nullopt;
}

Foot foot_on_quad(const std::array<Point, 4>& x, const Point& q) {
  const std::array<Point, 4> r{(x[0] + x[1] + x[2] + x[3]) / 4, (-x[0] + x[1] + x[2] - x[3]) / 4,
                               (-x[0] - x[1] + x[2] + x[3]) / 4, (x[0] - x[1] + x[2] - x[3]) / 4};
  Foot foot;
  for (int i = 0; i < 4; ++i) foot.distance = std::min(foot.distance, to_edge(x[i], x[(i + 1) % 4], q));
  foot.found = false;
  for (int i = -2; i <= 2; ++i)
    for (int k = -2; k <= 2; ++k) {
      const auto p = newton(r, q, {0.5L * i, 0.5L * k});
      if (!p) continue;
      foot.found = true;
      const Real reach = p->cwiseAbs().maxCoeff();
      if (reach < 1) {
        const Real distance = (r[0] + (*p)[0] * r[1] + (*p)[1] * r[2] + (*p)[0] * (*p)[1] * r[3] - q).norm();
        foot.distance = std::min(foot.distance, distance);
      }
      foot.reach = std::min(foot.reach, reach);
    }
  return foot;
}

Real tie_limit(const TieSegment& segment, const std::array<Point, 4>& x, const Vector& node, double thickness) {
  const Real d1 = 0.6L * (Real(thickness) + Real(segment.thickness));
  const Real d2 = 0.05L * std::min((x[2] - x[0]).norm(), (x[3] - x[1]).norm());
  double largest = node.cwiseAbs().maxCoeff();
  for (const Vector& corner : segment.corners) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  const Real ulp = Real(std::nextafter(largest, 1e308)) - Real(largest);
  const Real d = std::max(d1, d2);
  return d + 1e-9L * d + 4 * ulp;
}

}  // namespace

TieVerdict tie_verdict(const std::vector<TieSegment>& segments, const Vector& node, double thickness, double parmax) {
  TieVerdict verdict;
  const Point q = point(node);
  const Real reach_limit = Real(parmax) + 1e-9L * Real(parmax);
  for (const TieSegment& segment : segments) {
    std::array<Point, 4> x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = point(segment.corners[i]);
    const Real limit = tie_limit(segment, x, node, thickness);
    const Real size = std::max({(x[1] - x[0]).norm(), (x[2] - x[0]).norm(), (x[3] - x[0]).norm()});
    if ((x[0] - q).norm() > limit + size) continue;
    const Foot foot = segment.triangle ? foot_on_triangle(x, q) : foot_on_quad(x, q);
    const Real doubt = doubt_of_limit * limit + doubt_of_coordinates * q.cwiseAbs().maxCoeff();
    if (std::abs(foot.distance - limit) < doubt) verdict.certain = false;
    if (foot.distance > limit) continue;
    // How far a foot is from the border is a matter of doubles in the program, with a slack of 1e-9.
    if (!foot.found || std::abs(foot.reach - reach_limit) < 1e-12L) verdict.certain = false;
    if (foot.reach > reach_limit) continue;
    verdict.ties = true;
    if (verdict.nearest < 0 || foot.distance < verdict.nearest) verdict.nearest = foot.distance;
  }
  return verdict;
}

}  // namespace gapcheck::reference
