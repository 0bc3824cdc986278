#pragma once
#include <array>

#include "base/vector.hpp"

namespace gapcheck::solver {

/// Axes of a triangle, the first along side 1→2, and the sides 1→2, 2→3, 3→1 in them.
struct TriangleFrame {
  Vector e1, e2, e3;
  double area;
  std::array<double, 3> side_x, side_y;
  std::array<double, 3> bx, by;            ///< ∂N/∂x of the corners
  std::array<double, 3> shear_x, shear_y;  ///< share of each side's shear (times its length) in the element's

  [[nodiscard]] double squared_side(std::size_t i) const { return side_x[i] * side_x[i] + side_y[i] * side_y[i]; }
  /// Vectors at the corners in the axes.
  [[nodiscard]] std::array<Vector, 3> local(const std::array<Vector, 4>& v) const {
    std::array<Vector, 3> result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = {v[i].dot(e1), v[i].dot(e2), v[i].dot(e3)};
    return result;
  }
  [[nodiscard]] Vector global(const Vector& a) const { return a.x() * e1 + a.y() * e2 + a.z() * e3; }
};

/// Of the first three corners.
[[nodiscard]] TriangleFrame make_triangle_frame(const std::array<Vector, 4>& x);

}  // namespace gapcheck::solver
