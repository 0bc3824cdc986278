#pragma once
#include <array>
#include <cstddef>

#include "geometry/closest_point.hpp"
#include "geometry/patch.hpp"

namespace gapcheck::geometry {

/// Pairs whose closest point lay inside the facet a moment ago, arrays by pair. A triangle is a quad whose last two
/// corners are one.
struct FollowedPairs {
  static constexpr std::size_t capacity = 64;
  using Row = std::array<double, capacity>;
  std::array<std::array<Row, 3>, 4> corner;  ///< less the query: by corner and axis
  Row s, t;                                  ///< where to start; then where the closest point is
  /// What follow() found, beside s and t: from the query to the point, its squared length and the largest coordinate.
  std::array<Row, 3> offset;
  Row squared_distance, size;
  Row turn;  ///< offset times the patch's normal, which is not of unit length; positive: the query lies behind
  /// 1: s, t is the closest point of the whole facet up to rounding, inside it by more than 1e-9; else 0.
  Row settled;

  void set(std::size_t i, const Facet& facet, const Vector& query) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector from_query = facet.x[facet.triangle && k == 3 ? 2 : k] - query;
      corner[k][0][i] = from_query.x();
      corner[k][1][i] = from_query.y();
      corner[k][2][i] = from_query.z();
    }
  }
  [[nodiscard]] Vector offset_of(std::size_t i) const { return {offset[0][i], offset[1][i], offset[2][i]}; }
  /// True if the facet is proven to be nearer than `bound`; else nothing is known.
  [[nodiscard]] bool closer_than(std::size_t i, double bound) const {
    const double within = bound - 64 * roundoff * size[i];
    return settled[i] > 0 && within > 0 && squared_distance[i] < within * within;
  }

  // Of follow() alone: the patches m + a s + b t + c s t, and the proofs that the point is the nearest.
  std::array<std::array<Row, 3>, 4> patch;
  Row hull, convexity, level;
};

/// Finds the closest points of the first `count` pairs by Newton's method from s, t, several pairs at once. The result
/// for a pair does not depend on the others, nor on the processor. The proofs are those of Certificate::at() and
/// is_nearest() (docs/theory/decisions.md); where they fail, use closest_point() and decide().
void follow(FollowedPairs& pairs, std::size_t count);
/// The same with vectors that every processor has.
void follow_narrow(FollowedPairs& pairs, std::size_t count);

}  // namespace gapcheck::geometry
