#pragma once
#include "geometry/certificate.hpp"
#include "geometry/closest_point.hpp"

/// Proofs in numbers of about 106 bits, for facets that lie at the bound up to the rounding of doubles. They settle
/// everything except ties to about 30 digits. Derivation: docs/theory/decisions.md.
namespace gapcheck::geometry::precise {

/// Corners to[i] - from[i], without rounding: of a facet seen from a query, or the differences of two edges' ends.
struct Differences {
  Corners to, from;
};

/// Is some coordinate of all corners beyond the bound, or at it? Without rounding: of facets and edges along an axis
/// this decides ties.
[[nodiscard]] bool separated_by_axis(const Differences& corners, double bound);

/// What the patch of these corners proves near its point (s, t) in [-1, 1]: closer, apart, or open. The size of the
/// corners (size_of) must be usable() (view.hpp), the bound positive and finite.
[[nodiscard]] Verdict patch_verdict(const Differences& corners, double size, double bound, double s, double t);

/// The same for the triangle of the first three corners.
[[nodiscard]] Verdict triangle_verdict(const Differences& corners, double size, double bound, double s, double t);

}  // namespace gapcheck::geometry::precise
