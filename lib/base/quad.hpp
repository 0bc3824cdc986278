#pragma once
#include <algorithm>
#include <array>
#include <span>

#include "base/ids.hpp"
#include "base/vector.hpp"

namespace gapcheck {

/// Normal of a quad, twice as long as its area: the cross product of its diagonals. A triangle repeats its last corner.
[[nodiscard]] inline Vector quad_normal(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  return (c - a).cross(d - b);
}
[[nodiscard]] inline Vector quad_normal(const std::array<Vector, 4>& x) { return quad_normal(x[0], x[1], x[2], x[3]); }
/// The same of four nodes, whose places are in `x`.
[[nodiscard]] inline Vector quad_normal(std::span<const NodeIndex, 4> n, std::span<const Vector> x) {
  return quad_normal(x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]);
}

/// The longer diagonal of a quad of four nodes, whose places are in `x`; of a triangle the longest side.
[[nodiscard]] inline double longest_diagonal(std::span<const NodeIndex, 4> n, std::span<const Vector> x) {
  const auto length = [&](std::size_t a, std::size_t b) { return (x[n[a].value] - x[n[b].value]).norm(); };
  return std::max({length(0, 2), length(1, 3), n[2] == n[3] ? length(0, 1) : 0});
}

/// Bilinear weights of a quad's corners at (s, t), both from -1 to 1: never negative on the quad, relative error of
/// each at most 3 roundoffs.
[[nodiscard]] inline std::array<double, 4> quad_weights(double s, double t) {
  const double left = 0.5 * (1 - s), right = 0.5 * (1 + s), low = 0.5 * (1 - t), high = 0.5 * (1 + t);
  return {left * low, right * low, right * high, left * high};
}

/// The point of a quad at (s, t). Adds the corners in turn; geometry::blend adds them in pairs, which rounds otherwise.
[[nodiscard]] inline Vector quad_point(const std::array<Vector, 4>& x, double s, double t) {
  const std::array<double, 4> w = quad_weights(s, t);
  return w[0] * x[0] + w[1] * x[1] + w[2] * x[2] + w[3] * x[3];
}

}  // namespace gapcheck
