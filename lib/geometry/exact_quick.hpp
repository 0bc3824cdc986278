#pragma once
#include "geometry/exact.hpp"

/// The questions of exact.hpp with the same answers, but first in doubles: for a facet at the bound up to rounding,
/// usually only one comparison needs exact numbers, not the search for the nearest feature. Coordinates must be finite;
/// bounds positive and finite.
namespace gapcheck::geometry::exact {

[[nodiscard]] bool quick_triangle_closer(const Vector& a, const Vector& b, const Vector& c, const Vector& query,
                                         double bound);
[[nodiscard]] bool quick_flat_and_convex(const Facet& facet);

}  // namespace gapcheck::geometry::exact
