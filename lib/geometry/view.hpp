#pragma once
#include "geometry/closest_point.hpp"
#include "geometry/patch.hpp"

namespace gapcheck::geometry {

/// A facet as seen from the query, scaled to a usable size.
struct View {
  Corners corners;
  double scale = 1;  ///< power of two by which the coordinates were multiplied
};

/// The corners less the query, each coordinate rounded once. Not finite where the numbers are not or the difference
/// overflows.
[[nodiscard]] inline Corners seen_from(const Facet& facet, const Vector& query) {
  return {facet.x[0] - query, facet.x[1] - query, facet.x[2] - query, facet.x[facet.triangle ? 2 : 3] - query};
}
/// Sizes at which products of up to six coordinates neither overflow nor vanish.
[[nodiscard]] inline bool usable(double size) { return size >= 1e-30 && size <= 1e30; }
/// The same, scaled to a size near 1 if it is not usable. For finite numbers only.
[[nodiscard]] View scaled_view(const Facet& facet, const Vector& query);
[[nodiscard]] bool all_finite(const Facet& facet, const Vector& query);

}  // namespace gapcheck::geometry
