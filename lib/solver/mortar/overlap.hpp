#pragma once
#include <array>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck::solver {

/// A place where two facets lie over each other, as seen along the first one's normal.
struct OverlapPoint {
  std::array<double, 4> first{}, second{};  ///< weights of the corners of both facets
  double area = 0;                          ///< its share of the overlap
  double distance = 0;                      ///< from the first facet to the second along the normal
};

/// The common part of two facets in projection, with points to integrate over it.
struct Overlap {
  Vector normal = Vector::Zero();  ///< unit normal of the first facet's mean plane
  double area = 0;                 ///< of the projection
  std::vector<OverlapPoint> points;
};

/// Projects two facets (bilinear; a triangle repeats its last corner) along the normal of the first one's mean plane,
/// cuts one with the other, divides the polygon into triangles and puts the six points of Dunavant's rule of degree 4
/// into each. The points of both facets at one place lie on one line along the normal, to rounding. A facet that is
/// concave in projection counts as two triangles. Without area in common there are no points. Sources: M. A. Puso, T.
/// A. Laursen, A mortar segment-to-segment frictional contact method for large deformations, Comput. Methods Appl.
/// Mech. Engrg. 193 (2004); D. A. Dunavant, Int. J. Numer. Methods Eng. 21 (1985).
void find_overlap(const std::array<Vector, 4>& first, const std::array<Vector, 4>& second, Overlap& overlap);

}  // namespace gapcheck::solver
