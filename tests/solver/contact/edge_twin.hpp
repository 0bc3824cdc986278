#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck::solver {

/// Beams against beams, slow and obvious: every pair in every cycle, no search, nothing shared with the library.
class EdgeTwin {
 public:
  struct Line {
    std::size_t a = 0, b = 0;
    double radius = 0;
  };
  EdgeTwin(std::vector<Line> lines, double stiffness) : lines_(std::move(lines)), stiffness_(stiffness) {}

  /// Forces of one cycle by node.
  std::vector<Vector> cycle(const std::vector<Vector>& x) {
    std::vector<Vector> forces(x.size(), Vector::Zero());
    touching_ = passed_ = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (std::size_t k = i + 1; k < lines_.size(); ++k) meet(i, k, x, forces);
    return forces;
  }
  [[nodiscard]] std::size_t touching() const { return touching_; }
  [[nodiscard]] std::size_t passed() const { return passed_; }

 private:
  static double to_line(const Vector& p, const Vector& a, const Vector& b) {
    const Vector u = b - a;
    const double s = std::clamp((p - a).dot(u) / u.dot(u), 0.0, 1.0);
    return (a + s * u - p).norm();
  }

  void meet(std::size_t i, std::size_t k, const std::vector<Vector>& x, std::vector<Vector>& forces) {
    const Line &e = lines_[i], &f = lines_[k];
    const Vector &p = x[e.a], u = x[e.b] - x[e.a], &q = x[f.a], v = x[f.b] - x[f.a], w = p - q;
    // The two conditions that the shortest connection is normal to both lines.
    const double a = u.dot(u), b = u.dot(v), c = v.dot(v), d = u.dot(w), g = v.dot(w), det = a * c - b * b;
    const double s = (b * g - c * d) / det, t = (a * g - b * d) / det;
    Vector& side = side_.try_emplace({i, k}, Vector::Zero()).first->second;
    if (!(s > 0 && s < 1 && t > 0 && t < 1)) {
      side.setZero();
      return;
    }
    const Vector way = p + s * u - q - t * v;
    Vector normal = u.cross(v).normalized();
    if (normal.dot(side.norm() > 0 ? side : way) < 0) normal = -normal;
    side = normal;
    const double h = e.radius + f.radius, distance = way.dot(normal);
    if (distance >= 0) {
      const double end = std::min({to_line(x[e.a], x[f.a], x[f.b]), to_line(x[e.b], x[f.a], x[f.b]),
                                   to_line(x[f.a], x[e.a], x[e.b]), to_line(x[f.b], x[e.a], x[e.b])});
      if (distance >= h || (end < h && end - distance < 0.05 * h)) return;
    } else {
      ++passed_;
    }
    ++touching_;
    const Vector force = stiffness_ * (h - distance) * normal;
    forces[e.a] += (1 - s) * force;
    forces[e.b] += s * force;
    forces[f.a] -= (1 - t) * force;
    forces[f.b] -= t * force;
  }

  std::vector<Line> lines_;
  double stiffness_;
  std::map<std::pair<std::size_t, std::size_t>, Vector> side_;
  std::size_t touching_ = 0, passed_ = 0;
};

}  // namespace gapcheck::solver
