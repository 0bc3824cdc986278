#pragma once
#include <cstdint>

#include "geometry/closest_point.hpp"
#include "geometry/patch.hpp"

namespace gapcheck::geometry {

/// Where on a facet the point nearest to a query lay a moment ago.
struct NearPlace {
  bool known = false;
  Feature feature = Feature::face;
  std::uint8_t index = 0;  ///< of the edge or corner
  double s = 0, t = 0;     ///< on the face
};

/// Bound of the rounding of a distance, as a share of the largest coordinate of the facet less the query: differences,
/// products and the root are rounded once each.
inline constexpr double distance_rounding = 32 * roundoff;

[[nodiscard]] inline NearPlace place_of(const ClosestPoint& closest) {
  return {true, closest.feature, closest.feature_index, closest.s, closest.t};
}

/// A lower bound of the distance between facet and query, negative where nothing is known: the facet lies beyond the
/// plane through its corner nearest to the query along the direction to the place. On an edge that is the edge's point
/// nearest to the query now. Where a corner or edge of the corners' hull is nearest, or a flat facet's inside, the
/// bound is the distance up to rounding, which is taken off. Coordinates of usable() size.
[[nodiscard]] double distance_bound(const Facet& facet, const Vector& query, const NearPlace& place);

}  // namespace gapcheck::geometry
