#pragma once
#include <array>
#include <cstdint>

#include "geometry/decide.hpp"

namespace gapcheck::geometry {

/// Three corners; a triangle without area is the segment or point that they lie on.
using Triangle = std::array<Vector, 3>;

/// The following are decided exactly for the given doubles, and each is counted once: as `filter` if the floating-point
/// filter of decide_side() settled all its signs, else as `exact`. Mode::exact leaves the filter out (slow twin, same
/// answers). Anything with a non-finite coordinate meets or crosses nothing. How: docs/theory/decisions.md.

/// Do the closed triangles share a point?
[[nodiscard]] bool triangles_meet(const Triangle& a, const Triangle& b, Mode mode, DecisionCounters& counters);

/// Do the triangles pass through each other: each has corners strictly on both sides of the other's plane, and they
/// share more than a point. Touching, standing on each other and lying in one plane are not crossings.
[[nodiscard]] bool triangles_cross(const Triangle& a, const Triangle& b, Mode mode, DecisionCounters& counters);

/// Does the closed segment p q share a point with the closed triangle?
[[nodiscard]] bool segment_meets(const Vector& p, const Vector& q, const Triangle& triangle, Mode mode,
                                 DecisionCounters& counters);

/// Does the segment p q pass through the closed triangle: its ends lie strictly on opposite sides of the plane.
[[nodiscard]] bool segment_crosses(const Vector& p, const Vector& q, const Triangle& triangle, Mode mode,
                                   DecisionCounters& counters);

/// Position of a segment relative to a triangle.
enum class Passage : std::uint8_t {
  none,      ///< nothing in common
  through,   ///< from one side to the other, inside the edges
  touching,  ///< anything else: an end, an edge or a corner takes part, or the triangle has no area
};
[[nodiscard]] Passage passage(const Vector& p, const Vector& q, const Triangle& triangle, Mode mode,
                              DecisionCounters& counters);

/// Do two closed segments share a point?
[[nodiscard]] bool segments_meet(const Vector& p, const Vector& q, const Vector& r, const Vector& s, Mode mode,
                                 DecisionCounters& counters);

/// A piece of a straight line.
struct Line {
  Vector from = Vector::Zero(), to = Vector::Zero();
  [[nodiscard]] double length() const { return (to - from).norm(); }
  [[nodiscard]] Vector middle() const { return 0.5 * (from + to); }
};

/// The intersection of two triangles, in double precision: corners nearer to the other's plane than `tolerance` count
/// as lying on it. For triangles whose planes are at an angle; without length if they share nothing.
[[nodiscard]] Line common_line(const Triangle& a, const Triangle& b, double tolerance = 0);

}  // namespace gapcheck::geometry
