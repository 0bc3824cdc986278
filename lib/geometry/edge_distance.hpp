#pragma once
#include <array>

#include "base/vector.hpp"
#include "geometry/decide.hpp"

namespace gapcheck::geometry {

/// A straight edge between two points, both included.
using Edge = std::array<Vector, 2>;

/// Closest points of two edges, in double precision.
struct EdgesClosest {
  Vector first = Vector::Zero(), second = Vector::Zero();  ///< on the first and on the second edge
  double squared_distance = 0;
  double squared_end_distance = 0;  ///< of the end that lies nearest to the other edge
  double s = 0, t = 0;              ///< of `first` and `second`: -1 at an edge's first end, 1 at the other
  bool interior = false;  ///< both points lie between the ends, and nearer than any end lies to the other edge
};

/// Closest points of two edges. Of parallel edges, whose closest points are not unique, an end is taken. Edges may be
/// points. Coordinates that are not finite give an infinite distance. Never allocates.
[[nodiscard]] EdgesClosest closest_points(const Edge& first, const Edge& second);

/// Are two edges nearer to each other than `bound`: squared distance < bound², decided exactly for the given doubles?
/// Negative bounds are never met, and edges that are not finite are never near. Mode::exact leaves the filter out (slow
/// twin, same answers). Derivation: docs/theory/decisions.md.
[[nodiscard]] Decision decide_edges(const Edge& first, const Edge& second, double bound, Mode mode,
                                    const EdgesClosest* hint = nullptr);

}  // namespace gapcheck::geometry
