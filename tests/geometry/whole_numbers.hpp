#pragma once
#include <gmpxx.h>

#include <cstdint>
#include <optional>

#include "geometry/closest_point.hpp"

namespace gapcheck::geometry::test {

/// A squared distance without rounding: numerator / denominator · 4^exponent.
struct SquaredDistance {
  mpz_class numerator, denominator = 1;
  std::int64_t exponent = 0;
};

/// Of triangles, and of quads whose corners lie in one plane and turn one way; nothing for other quads, whose patch is
/// not made of triangles. In whole numbers and by Gram's determinants: another way than that of geometry/exact.cpp.
/// Coordinates must be finite.
[[nodiscard]] std::optional<SquaredDistance> whole_squared_distance(const Facet& facet, const Vector& query);

/// Squared distance < bound², bound > 0 and finite.
[[nodiscard]] bool less(const SquaredDistance& distance, double bound);

/// The decision for any facet by halving the patch in whole numbers: a piece is apart if a plane keeps its corners
/// away, nearer if a corner or its middle is. Nothing if that takes more than `pieces`: ties are never decided so.
[[nodiscard]] std::optional<bool> closer_by_halving(const Facet& facet, const Vector& query, double bound, int pieces);

}  // namespace gapcheck::geometry::test
