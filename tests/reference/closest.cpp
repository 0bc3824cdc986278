#include "reference/closest.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace gapcheck::reference {
namespace {

using Parameters = Eigen::Vector2d;

struct Patch {
  Vector a, b, c, d;  ///< r(s, t) = a + b s + c t + d s t
  explicit Patch(const Corners& x)
      : a((x[0] + x[1] + x[2] + x[3]) / 4),
        b((-x[0] + x[1] + x[2] - x[3]) / 4),
        c((-x[0] - x[1] + x[2] + x[3]) / 4),
        d((x[0] - x[1] + x[2] - x[3]) / 4) {}
  [[nodiscard]] Vector at(const Parameters& p) const { return a + b * p[0] + c * p[1] + d * (p[0] * p[1]); }
  [[nodiscard]] Vector ds(const Parameters& p) const { return b + d * p[1]; }
  [[nodiscard]] Vector dt(const Parameters& p) const { return c + d * p[0]; }
};

/// Newton's method for the foot of the query on the continued patch.
std::optional<Parameters> foot(const Patch& patch, const Vector& query, Parameters p) {
  for (int step = 0; step < 60; ++step) {
    const Vector gap = patch.at(p) - query, s = patch.ds(p), t = patch.dt(p);
    const Parameters gradient{s.dot(gap), t.dot(gap)};
    Eigen::Matrix2d hessian;
    const double mixed = s.dot(t) + patch.d.dot(gap);
    hessian << s.squaredNorm(), mixed, mixed, t.squaredNorm();
    const double determinant = hessian.determinant();
    if (!(std::abs(determinant) > 1e-14 * hessian.squaredNorm())) return std::nullopt;
    const Parameters move = hessian.inverse() * gradient;
    p -= move;
    if (!(p.cwiseAbs().maxCoeff() < 1e6)) return std::nullopt;
    if (move.cwiseAbs().maxCoeff() < 1e-14) return p;
  }
  return std::nullopt;
}

struct Candidate {
  Vector point = Vector::Zero();
  double distance = 1e300;
  Feature feature = Feature::face;
  std::size_t place = 0;
  void offer(const Vector& other, const Vector& query, Feature other_feature, std::size_t other_place) {
    const double d = (other - query).norm();
    if (d < distance) *this = {other, d, other_feature, other_place};
  }
};

/// The edge from corner i to the next of `count` corners.
void offer_edge(Candidate& best, const Corners& x, std::size_t i, std::size_t count, const Vector& query) {
  const std::size_t next = (i + 1) % count;
  const Vector &a = x[i], &b = x[next];
  const double length = (b - a).squaredNorm();
  if (length == 0) return best.offer(a, query, Feature::corner, i);
  const double u = (query - a).dot(b - a) / length;
  if (u <= 0) return best.offer(a, query, Feature::corner, i);
  if (u >= 1) return best.offer(b, query, Feature::corner, next);
  best.offer(a + u * (b - a), query, Feature::edge, i);
}

Vector unit_or_zero(const Vector& v) {
  const double length = v.norm();
  return length > 0 ? Vector(v / length) : Vector(Vector::Zero());
}

Closest closest_on_triangle(const Corners& x, const Vector& query) {
  const Vector u = x[1] - x[0], v = x[2] - x[0], cross = u.cross(v);
  const double area = cross.squaredNorm();
  const Vector w = query - x[0];
  const double l1 = w.cross(v).dot(cross) / area, l2 = u.cross(w).dot(cross) / area;
  const double lowest = std::min({1 - l1 - l2, l1, l2});
  Candidate best;
  for (std::size_t i = 0; i < 3; ++i) offer_edge(best, x, i, 3, query);
  if (lowest > 0) best = {x[0] + l1 * u + l2 * v, 1e300, Feature::face, 0};
  best.distance = (best.point - query).norm();
  // The band of half a parametric unit on a range of two is a quarter of the triangle's height.
  return {best.point, best.distance, best.feature, best.place, unit_or_zero(cross), -0.25 - lowest, area > 0};
}

/// True if the normals at the corners are within 60 degrees of one another; otherwise the continued patch says little.
bool regular(const Patch& patch) {
  std::array<Vector, 4> normals;
  for (std::size_t i = 0; i < 4; ++i) {
    const Parameters p{i == 1 || i == 2 ? 1.0 : -1.0, i >= 2 ? 1.0 : -1.0};
    normals[i] = unit_or_zero(patch.ds(p).cross(patch.dt(p)));
  }
  for (const Vector& a : normals)
    for (const Vector& b : normals)
      if (a.dot(b) < 0.5) return false;
  return true;
}

/// The patch and the query laid flat on the mean plane.
Patch flattened(const Corners& x, Vector& query) {
  const Patch patch(x);
  const Vector normal = unit_or_zero(patch.b.cross(patch.c));
  Corners flat;
  const auto lay = [&](const Vector& p) { return Vector(p - normal.dot(p - patch.a) * normal); };
  for (std::size_t i = 0; i < 4; ++i) flat[i] = lay(x[i]);
  query = lay(query);
  return Patch(flat);
}

double beyond(const Parameters& p) { return p.cwiseAbs().maxCoeff() - 1.5; }

/// Whether feet on the continued patch lie in the band, and outside.
struct Feet {
  bool in_band = false, out_of_band = false;
};

Feet feet_of(const Patch& patch, const Vector& query) {
  Feet feet;
  for (double s = -1; s <= 1; s += 0.5)
    for (double t = -1; t <= 1; t += 0.5)
      if (const auto p = foot(patch, query, {s, t})) (beyond(*p) <= 0 ? feet.in_band : feet.out_of_band) = true;
  return feet;
}

Closest closest_on_quad(const Corners& x, const Vector& query) {
  const Patch patch(x);
  Candidate best;
  std::optional<Parameters> inside, nearest_free;
  for (std::size_t i = 0; i < 4; ++i) offer_edge(best, x, i, 4, query);
  double nearest = 1e300;
  bool in_band = false, out_of_band = false;
  for (double s = -1; s <= 1; s += 0.5) {
    for (double t = -1; t <= 1; t += 0.5) {
      const auto p = foot(patch, query, {s, t});
      if (!p) continue;
      if (p->cwiseAbs().maxCoeff() < 1 && (patch.at(*p) - query).norm() < best.distance) {
        best.offer(patch.at(*p), query, Feature::face, 0);
        inside = p;
      }
      (beyond(*p) <= 0 ? in_band : out_of_band) = true;
      // Of several feet outside, the one nearest to the patch is meant.
      const double out = (p->cwiseAbs() - Parameters::Ones()).cwiseMax(0).norm();
      if (out < nearest) nearest = out, nearest_free = p;
    }
  }
  Closest result{best.point, best.distance, best.feature, best.place, Vector::Zero(), -0.5, true};
  const Parameters middle = inside.value_or(Parameters::Zero());
  result.normal = unit_or_zero(patch.ds(middle).cross(patch.dt(middle)));
  if (!inside) {
    // A distorted quad continued beyond its edges may have feet on both sides of the band: then the rule is open.
    result.certain = in_band != out_of_band;
    // 3.2: where the projection is far away, that on the mean plane counts; so they must agree.
    Vector flat_query = query;
    const Patch flat = flattened(x, flat_query);
    const Feet feet = feet_of(flat, flat_query);
    result.certain = result.certain && !(in_band ? feet.out_of_band : feet.in_band);
    result.beyond_band = nearest_free ? beyond(*nearest_free) : 1;
    // A foot on the patch that is not the nearest point: the patch is folded.
    result.certain = result.certain && regular(patch) && !(nearest_free && nearest == 0);
  }
  return result;
}

}  // namespace

Closest closest_on_line(const Corners& x, const Vector& query) {
  const Vector along = x[1] - x[0];
  const double u = (query - x[0]).dot(along) / along.squaredNorm();
  const Vector point = x[0] + std::clamp(u, 0.0, 1.0) * along;
  const Feature feature = u > 0 && u < 1 ? Feature::edge : Feature::corner;
  return {point, (point - query).norm(), feature, u < 0.5 ? 0U : 1U, Vector::Zero(), std::abs(2 * u - 1) - 1.5, true};
}

Closest closest(const Corners& x, bool triangle, const Vector& query) {
  return triangle ? closest_on_triangle(x, query) : closest_on_quad(x, query);
}

}  // namespace gapcheck::reference
