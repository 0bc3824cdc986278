#include "geometry/view.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::geometry {
namespace {

View view_at(const Facet& facet, const Vector& query, double scale) {
  Facet scaled = facet;
  for (Vector& x : scaled.x) x *= scale;
  return {seen_from(scaled, scale * query), scale};
}

}  // namespace

View scaled_view(const Facet& facet, const Vector& query) {
  View out{seen_from(facet, query), 1};
  double size = size_of(out.corners);
  if (!(size <= 1e300)) {
    out = view_at(facet, query, 0x1p-100);
    size = size_of(out.corners);
  }
  if (usable(size) || !(size > 0)) return out;
  // The factor itself must not overflow; subnormal sizes still come near enough to 1.
  const int shift = std::clamp(-std::ilogb(size), -1000, 1000);
  return view_at(facet, query, std::ldexp(out.scale, shift));
}

bool all_finite(const Facet& facet, const Vector& query) {
  return query.allFinite() &&
         std::all_of(facet.x.begin(), facet.x.end(), [](const Vector& x) { return x.allFinite(); });
}

}  // namespace gapcheck::geometry
