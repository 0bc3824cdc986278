#pragma once
#include "geometry/exact.hpp"

/// The questions of exact.hpp with the same answers, asked in doubles first: of a facet that lies at the bound up to
/// rounding only one comparison needs exact numbers as a rule, not the search for the feature that is nearest.
/// Coordinates must be finite; bounds positive and finite.
namespace gapcheck::geometry::exact {

[[nodiscard]] bool quick_triangle_closer(const Vector& a, const Vector& b, const Vector& c, const Vector& query,
                                         double bound);
[[nodiscard]] bool quick_flat_and_convex(const Facet& facet);

}  // namespace gapcheck::geometry::exact
