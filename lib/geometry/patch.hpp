#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/quad.hpp"
#include "base/vector.hpp"
#include "geometry/arithmetic.hpp"
#include "records/penetration.hpp"

namespace gapcheck::geometry {

/// The corners of a facet as seen from the query point, which is the origin. Triangles repeat the last corner.
using Corners = std::array<Vector, 4>;
using Weights = std::array<double, 4>;

/// Unit roundoff of double.
inline constexpr double roundoff = std::numeric_limits<double>::epsilon() / 2;

/// The largest absolute coordinate. NaN may or may not show.
[[nodiscard]] inline double size_of(const Corners& e) {
  double size = 0;
  for (const Vector& corner : e) size = std::max(size, corner.lpNorm<Eigen::Infinity>());
  return size;
}

[[nodiscard]] inline Vector blend(const Corners& e, const Weights& w) {
  return (w[0] * e[0] + w[1] * e[1]) + (w[2] * e[2] + w[3] * e[3]);
}

/// The bilinear patch as r(s,t) = m + a s + b t + c s t.
struct Patch {
  Vector m, a, b, c;
  Patch(Vector mean, Vector along_s, Vector along_t, Vector twist)
      : m(std::move(mean)), a(std::move(along_s)), b(std::move(along_t)), c(std::move(twist)) {}
  explicit Patch(const Corners& e) {
    const Vector low = e[0] + e[1], high = e[3] + e[2], right = e[1] - e[0], left = e[2] - e[3];
    m = 0.25 * (low + high);
    b = 0.25 * (high - low);
    a = 0.25 * (right + left);
    c = 0.25 * (left - right);
  }
  [[nodiscard]] Vector along_s(double t) const { return a + t * c; }
  [[nodiscard]] Vector along_t(double s) const { return b + s * c; }
};

/// The position on a facet of the point nearest to the origin.
struct Location {
  double s = 0, t = 0;            ///< in [-1, 1]
  double free_s = 0, free_t = 0;  ///< of the projection on the continued facet
  double beyond = 0;              ///< how far the projection lies outside, as ClosestPoint's band counts; <= 0 inside
  Feature feature = Feature::corner;
  std::uint8_t index = 0;
};

/// Nearest point of a triangle: exact up to rounding.
[[nodiscard]] Location locate_on_triangle(const Corners& e);
/// Nearest point of a patch: the stationary point if it lies inside, the best of the edges it lies beyond otherwise.
/// On strongly warped patches that may not be the nearest of all; then use search_patch. `quick` stops at the
/// projection by the mean plane, which is off by the square of the warp.
[[nodiscard]] Location locate_on_patch(const Corners& e, const Patch& patch, bool quick = false);
/// Nearest point of a patch by sampling and refinement: slow, for the cases that locate_on_patch does not settle.
[[nodiscard]] Location search_patch(const Corners& e, const Patch& patch);

}  // namespace gapcheck::geometry
