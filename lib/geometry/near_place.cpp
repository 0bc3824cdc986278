#include "geometry/near_place.hpp"

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"
#include "geometry/patch.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry {
namespace {

/// From the query to the edge's point nearest to it now, or to the corner.
Vector way_to_border(const Corners& e, const NearPlace& place) {
  const Vector &from = e[place.index], &to = e[(place.index + 1U) % 4];
  if (place.feature == Feature::corner) return from;
  const Vector along = to - from;
  const double length = along.squaredNorm();
  const double ratio = length > 0 ? std::clamp(-from.dot(along) / length, 0.0, 1.0) : 0;
  return from + ratio * along;
}

/// Across the facet there: it does not turn when the query moves along the facet.
Vector normal_at(const Corners& e, const NearPlace& place) {
  const Patch patch(e);
  const Vector normal = patch.along_s(place.t).cross(patch.along_t(place.s));
  return normal.dot(patch.m) < 0 ? Vector(-normal) : normal;
}

}  // namespace

double distance_bound(const Facet& facet, const Vector& query, const NearPlace& place) {
  if (!place.known) return -1;
  const Corners e = seen_from(facet, query);
  const Vector across = place.feature == Feature::face ? normal_at(e, place) : way_to_border(e, place);
  const double length = across.norm();
  if (!(length > 0)) return -1;
  const double least = std::min({across.dot(e[0]), across.dot(e[1]), across.dot(e[2]), across.dot(e[3])}) / length;
  return least - distance_rounding * size_of(e);
}

}  // namespace gapcheck::geometry
