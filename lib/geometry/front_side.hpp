#pragma once
#include "geometry/closest_point.hpp"

namespace gapcheck::geometry {

/// How far point and corners may move against each other, each by half of it, before the point can be level with a
/// corner, seen along the facet's mean normal (`front` = 1) or against it (−1): a lower bound. So long the point is
/// strictly on that side of the facet, and of its mean plane through each of the facet's points. 0 where the point is
/// not there now, and for strongly warped or thin facets.
///
/// From a corner to the point is a vector d, and n · d is the height. A motion m changes d by at most m and the normal
/// n = N / |N|, N the cross product of the diagonals, by at most what turns N: m times the sum of the diagonals over
/// |N|.
[[nodiscard]] double motion_in_front(const Facet& facet, const Vector& query, double front);

}  // namespace gapcheck::geometry
