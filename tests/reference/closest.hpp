#pragma once
#include <array>

#include "base/vector.hpp"
#include "records/penetration.hpp"

namespace gapcheck::reference {

/// Corners of a quad (bilinear patch) or, with corner 3 equal to corner 2, of a triangle.
using Corners = std::array<Vector, 4>;

struct Closest {
  Vector point = Vector::Zero();
  double distance = 0;
  Feature feature = Feature::face;
  /// Of the feature: edge i runs from corner i to i + 1, corner i is corner i.
  std::size_t place = 0;
  Vector normal = Vector::Zero();  ///< unit normal of the facet at the point
  /// How far outside the band the projection lies, in parametric units: negative inside, 0 on its border.
  double beyond_band = 0;
  bool certain = true;  ///< false: the projection on the continued patch did not settle
};

/// Closest point of a facet found the slow way: every edge as a line, the inside by Newton's method from a grid of
/// starting points. Independent of lib/geometry on purpose.
[[nodiscard]] Closest closest(const Corners& x, bool triangle, const Vector& query);

/// The same for a line from corner 0 to corner 1; the band reaches as far in its parameter.
[[nodiscard]] Closest closest_on_line(const Corners& x, const Vector& query);

}  // namespace gapcheck::reference
