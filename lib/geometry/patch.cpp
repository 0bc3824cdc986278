#include "geometry/patch.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::geometry {
namespace {

/// The nearest of the edges visited so far.
class NearestEdge {
 public:
  explicit NearestEdge(const Corners& e) : e_(e) {}

  /// Edge `index` from corner `i` to corner `j`.
  void visit(std::uint8_t index, std::uint8_t i, std::uint8_t j) {
    const Vector along = e_[j] - e_[i];
    const double length = along.squaredNorm();
    const double ratio = length > 0 ? -e_[i].dot(along) / length : 0;
    if (ratio > 0 && ratio < 1) {
      offer((e_[i] + ratio * along).squaredNorm(), Feature::edge, index, ratio);
    } else {
      const std::uint8_t corner = ratio > 0 ? j : i;
      offer(e_[corner].squaredNorm(), Feature::corner, corner, 0);
    }
  }

  void store(Location& out) const {
    static constexpr std::array<double, 4> corner_s{-1, 1, 1, -1}, corner_t{-1, -1, 1, 1};
    const std::size_t i = index_, j = (i + 1) % 4;
    out.feature = feature_;
    out.index = index_;
    out.s = corner_s[i] + ratio_ * (corner_s[j] - corner_s[i]);
    out.t = corner_t[i] + ratio_ * (corner_t[j] - corner_t[i]);
  }

 private:
  void offer(double squared_distance, Feature feature, std::uint8_t index, double ratio) {
    if (!(squared_distance < best_)) return;
    best_ = squared_distance;
    feature_ = feature;
    index_ = index;
    ratio_ = ratio;
  }

  const Corners& e_;
  double best_ = std::numeric_limits<double>::infinity(), ratio_ = 0;
  Feature feature_ = Feature::corner;
  std::uint8_t index_ = 0;
};

struct Projection {
  double s, t;
  bool valid;
};

/// Newton's method for the stationary point of the distance, from a start near it. Not valid if it does not converge.
Projection refine(const Patch& p, double s, double t) {
  for (int step = 0; step < 12; ++step) {
    const Vector rs = p.along_s(t), rt = p.along_t(s), r = p.m + t * p.b + s * rs;
    const double gs = r.dot(rs), gt = r.dot(rt), ss = rs.squaredNorm(), tt = rt.squaredNorm();
    const double st = rs.dot(rt) + r.dot(p.c), det = ss * tt - st * st;
    if (!(det > 1e-12 * ss * tt)) break;
    const double ds = (st * gt - tt * gs) / det, dt = (st * gs - ss * gt) / det;
    s += ds;
    t += dt;
    const double moved = std::abs(ds) + std::abs(dt);
    if (moved <= 1e-8 * (1 + std::abs(s) + std::abs(t))) return {s, t, true};
    if (!(moved < 4)) break;
  }
  return {s, t, false};
}

/// The origin's projection on the continued patch. Starts with the closed form on the mean plane (spanned by a and b),
/// which is exact for flat patches. Not valid if the patch has no area.
Projection project(const Patch& p, bool quick) {
  const Vector n = p.a.cross(p.b);
  const double nn = n.squaredNorm(), aa = p.a.squaredNorm(), bb = p.b.squaredNorm();
  if (!(nn > 1e-30 * aa * bb)) return {0, 0, false};
  const Vector dual_a = p.b.cross(n), dual_b = n.cross(p.a);
  const double unit = 1 / nn, s0 = -p.m.dot(dual_a) * unit, t0 = -p.m.dot(dual_b) * unit;
  double s = s0, t = t0;
  // In the plane: s + alpha s t = s0, t + beta s t = t0; of the two solutions the one on the patch's own sheet.
  const double x = p.c.dot(dual_a) * unit * t0, y = p.c.dot(dual_b) * unit * s0;
  const double square = (1 + x - y) * (1 + x - y) + 4 * y;
  const bool parallelogram = std::abs(x) + std::abs(y) <= roundoff;
  if (!parallelogram && square >= 0) {
    const double root = std::sqrt(square), by_s = 1 + x - y + root, by_t = 1 - x + y + root;
    if (std::abs(by_s) > 1e-3 && std::abs(by_t) > 1e-3) {
      s = 2 * s0 / by_s;
      t = 2 * t0 / by_t;
    }
  }
  if (quick) return {s, t, true};
  const double warp = std::abs(p.c.dot(n)), height = std::abs(p.m.dot(n));
  if (warp * (warp + height) <= 1e-15 * nn * std::min(aa, bb)) return {s, t, true};
  if (const Projection better = refine(p, s, t); better.valid) return better;
  return {s, t, true};
}

/// The same with usable parameters: for a facet that is nearly a line they may be anything.
Projection free_projection(const Patch& p, bool quick) {
  constexpr double limit = 1e9;
  const Projection at = project(p, quick);
  if (!std::isfinite(at.s) || !std::isfinite(at.t)) return {0, 0, false};
  return {std::clamp(at.s, -limit, limit), std::clamp(at.t, -limit, limit), at.valid};
}

/// The parameter s of the point nearest to the origin on the line of constant t.
double best_s(const Patch& p, double t) {
  const Vector along = p.along_s(t);
  const double length = along.squaredNorm();
  return length > 0 ? std::clamp(-(p.m + t * p.b).dot(along) / length, -1.0, 1.0) : 0;
}

double squared_distance(const Patch& p, double s, double t) { return (p.m + t * p.b + s * p.along_s(t)).squaredNorm(); }

}  // namespace

Location locate_on_triangle(const Corners& e) {
  Location out;
  const Vector u = e[1] - e[0], v = e[2] - e[0], n = u.cross(v);
  const double nn = n.squaredNorm();
  NearestEdge edges(e);
  const auto visit = [&](bool first, bool second, bool last) {
    if (first) edges.visit(0, 0, 1);
    if (second) edges.visit(1, 1, 2);
    if (last) edges.visit(3, 2, 0);
    edges.store(out);
    if (out.feature == Feature::corner && out.index == 2) out.s = 0;
  };
  if (!(nn > 1e-30 * u.squaredNorm() * v.squaredNorm())) {
    visit(true, true, true);
    out.free_s = out.s;
    out.free_t = out.t;
    return out;
  }
  const double l1 = -n.dot(e[0].cross(v)) / nn, l2 = -n.dot(u.cross(e[0])) / nn, l0 = 1 - l1 - l2;
  const double base = l0 + l1;
  if (!std::isfinite(base)) {
    visit(true, true, true);
    return out;
  }
  out.free_s = std::abs(base) > 1e-12 ? (l1 - l0) / base : 0;
  out.free_t = 2 * l2 - 1;
  out.beyond = -2 * std::min({l0, l1, l2});
  if (out.beyond < 0) {
    out.s = out.free_s = std::clamp(out.free_s, -1.0, 1.0);
    out.t = out.free_t = std::clamp(out.free_t, -1.0, 1.0);
    out.feature = Feature::face;
    return out;
  }
  // The nearest point lies on an edge that the projection lies beyond. If rounding decides which, try them all.
  const bool thin = nn < 1e-12 * u.squaredNorm() * v.squaredNorm();
  visit(thin || l2 <= 0, thin || l0 <= 0, thin || l1 <= 0);
  return out;
}

Location locate_on_patch(const Corners& e, const Patch& patch, bool quick) {
  Location out;
  const Projection projection = free_projection(patch, quick);
  const double s = projection.s, t = projection.t;
  const bool free = projection.valid;
  out.free_s = s;
  out.free_t = t;
  out.beyond = std::max(std::abs(s), std::abs(t)) - 1;
  if (free && out.beyond < 0) {
    out.s = s;
    out.t = t;
    out.feature = Feature::face;
    return out;
  }
  NearestEdge edges(e);
  if (!free || t <= -1) edges.visit(0, 0, 1);
  if (!free || s >= 1) edges.visit(1, 1, 2);
  if (!free || t >= 1) edges.visit(2, 2, 3);
  if (!free || s <= -1) edges.visit(3, 3, 0);
  edges.store(out);
  if (!free) {
    out.free_s = out.s;
    out.free_t = out.t;
    out.beyond = 0;
  }
  return out;
}

Location search_patch(const Corners& e, const Patch& p) {
  Location out = locate_on_patch(e, p);
  NearestEdge edges(e);
  for (std::uint8_t i = 0; i < 4; ++i) edges.visit(i, i, static_cast<std::uint8_t>((i + 1) % 4));
  edges.store(out);
  double best = squared_distance(p, out.s, out.t);

  const auto value = [&](double t) { return squared_distance(p, best_s(p, t), t); };
  const auto offer = [&](double s, double t) {
    if (!(std::abs(s) < 1 && std::abs(t) < 1) || !(squared_distance(p, s, t) < best)) return;
    best = squared_distance(p, s, t);
    out.s = out.free_s = s;
    out.t = out.free_t = t;
    out.beyond = 0;
    out.feature = Feature::face;
    out.index = 0;
  };
  constexpr int samples = 32;
  std::array<double, samples + 1> height{};
  for (int i = 0; i <= samples; ++i) height[i] = value(-1 + 2.0 * i / samples);
  for (int i = 0; i <= samples; ++i) {
    const int before = std::max(i - 1, 0), after = std::min(i + 1, samples);
    if (height[i] > height[before] || height[i] > height[after]) continue;
    double low = -1 + 2.0 * before / samples, high = -1 + 2.0 * after / samples;
    for (int step = 0; step < 60; ++step) {
      const double third = (high - low) / 3;
      const bool left = value(low + third) < value(high - third);
      (left ? high : low) = left ? high - third : low + third;
    }
    const double t = 0.5 * (low + high), s = best_s(p, t);
    offer(s, t);
    if (const Projection better = refine(p, s, t); better.valid) offer(better.s, better.t);
  }
  return out;
}

}  // namespace gapcheck::geometry
