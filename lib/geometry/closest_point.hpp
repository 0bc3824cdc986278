#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "base/vector.hpp"
#include "records/penetration.hpp"

namespace gapcheck::geometry {

/// A 3- or 4-node facet. A quad is the bilinear patch of its corners
/// r(s,t) = Σ Nᵢ xᵢ, N = (1-s)(1-t)/4, (1+s)(1-t)/4, (1+s)(1+t)/4, (1-s)(1+t)/4; a triangle has x[2] == x[3] and is the
/// same map with the edge t = 1 collapsed.
struct Facet {
  std::array<Vector, 4> x;
  bool triangle = false;
};

/// Closest point of a facet to a point, in double precision.
struct ClosestPoint {
  Vector point = Vector::Zero();
  double squared_distance = 0;
  double s = 0, t = 0;            ///< of `point`; in [-1, 1]
  double free_s = 0, free_t = 0;  ///< of the projection on the patch continued beyond its edges; equal s, t on the face
  Feature feature = Feature::face;
  std::uint8_t feature_index = 0;   ///< edge i joins corners i and i+1; corner i
  Vector normal = Vector::UnitZ();  ///< unit normal of the patch at `point`; zero for a facet without area
  double gap = 0;                   ///< normal · (query - point)
  bool in_band = true;              ///< projection within `band` (see closest_point)
};

/// How far beyond the facet a projection still counts: |s|, |t| <= 1 + band on quads (0.5: the solver's rule); on
/// triangles every barycentric coordinate >= -band / 2. Points on the face are always in the band. The comparison is
/// made on the double result, inclusive, with a relative slack of 1e-9. If a warped quad has no such projection nearby,
/// the projection by its mean plane counts; a facet without area is always in the band. Coordinates that are not finite
/// give an infinite distance out of the band; finite ones give finite results unless the squared distance itself
/// overflows. Never allocates.
[[nodiscard]] ClosestPoint closest_point(const Facet& facet, const Vector& query, double band = 0.5);

/// Closest point of the straight line between two points.
struct LineClosest {
  Vector point = Vector::Zero();
  double squared_distance = 0;
  double s = 0;       ///< -1 at a, 1 at b, clamped
  double free_s = 0;  ///< not clamped
};
[[nodiscard]] LineClosest closest_point_on_line(const Vector& a, const Vector& b, const Vector& query);

}  // namespace gapcheck::geometry
