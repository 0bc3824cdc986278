#pragma once
#include "geometry/closest_point.hpp"

namespace gapcheck::geometry {

/// Proven bounds of the distance between a facet and a point, for the doubles given: lower <= distance <= upper.
struct DistanceEnclosure {
  double lower = 0;
  double upper = 0;
  int pieces = 0;  ///< of the facet that it took; 1: at the first try, 0: nothing is proven (lower 0, upper infinite)
  bool sharp = false;  ///< as narrow as rounding allows: upper - lower <= 1e-13 of the facet's reach from the point
  [[nodiscard]] double width() const { return upper - lower; }
};

/// Encloses the distance. Quads are the bilinear patch. The closest point in doubles, the planes and the largest drop
/// of docs/theory/decisions.md bound it; where that is not sharp the facet is cut into at most `most_pieces` pieces,
/// the one with the lowest bound first. What stays wide: folded quads, and closest points on the fold of a warped one,
/// where the distance is flat to fourth order; slivers and facets with little area beside their reach. Not finite or
/// sizes beyond 1e-30 ... 1e30: nothing is proven. `hint` may carry closest_point() of the same pair to save its work.
[[nodiscard]] DistanceEnclosure enclose_distance(const Facet& facet, const Vector& query, int most_pieces = 256,
                                                 const ClosestPoint* hint = nullptr);

}  // namespace gapcheck::geometry
