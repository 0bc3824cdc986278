#pragma once
#include <gmpxx.h>

#include "geometry/closest_point.hpp"

namespace gapcheck::geometry::test {

/// Squared distance of a triangle or segment in rational numbers: exact.
[[nodiscard]] mpq_class squared_distance(const Vector& a, const Vector& b, const Vector& query);
[[nodiscard]] mpq_class squared_distance(const Vector& a, const Vector& b, const Vector& c, const Vector& query);

/// Squared distance of a bilinear patch with 600 bits: edges as segments, the inside by Newton's method from a grid of
/// starts. Too large by far more than rounding where the patch is folded onto the nearest point (singular minimum).
[[nodiscard]] mpf_class squared_distance_of_patch(const Facet& facet, const Vector& query);

/// squared_distance... of the facet, whatever it is.
[[nodiscard]] mpf_class squared_distance(const Facet& facet, const Vector& query);

/// Bounds of a patch's distance by cutting it up and nothing else: every piece lies within its corners' reach of its
/// middle. Stops when the bounds are `tolerance` times the patch's size apart or the pieces become too many.
struct Bracket {
  double low, high;
};
[[nodiscard]] Bracket distance_bracket(const Facet& facet, const Vector& query, double tolerance);

}  // namespace gapcheck::geometry::test
