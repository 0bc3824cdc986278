#pragma once
#include "geometry/closest_point.hpp"

namespace gapcheck::geometry {

/// A facet that may move and a point whose projection lies out of its band.
struct OutsideBand {
  const Facet& facet;
  const Vector& query;
  Vector closest;  ///< point of the facet that is nearest to the query
  double reach;    ///< the answer holds while the two are not farther apart than this
};

/// How far point and corners may move against each other, each by half of it, before closest_point() can find the
/// projection in the band of 0.5: a lower bound; 0 where none is known, as for strongly warped or thin facets.
///
/// A projection (s, t) in the band satisfies query − r(s,t) = g n, where n is the normal there or that of the mean
/// plane, and |g| is at most the reach and the size of the continued facet. Along a direction u in the mean plane the
/// left side is at least the width δ of the strip between query and continued facet, and the right side only grows with
/// the motion that turns n out of being perpendicular to u.
[[nodiscard]] double motion_outside_band(const OutsideBand& pair);

}  // namespace gapcheck::geometry
