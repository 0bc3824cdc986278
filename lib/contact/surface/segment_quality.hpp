#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::contact {

/// What makes a segment unusable as a piece of a surface, worst first.
enum class SegmentFault : std::uint8_t {
  none,
  not_finite,     ///< a coordinate is not finite
  few_nodes,      ///< fewer than three different nodes
  zero_area,      ///< all corners on one line, or all at one point
  crossed,        ///< two opposite edges cross: a bow-tie
  folded,         ///< one corner turns inward by more than 180 degrees: an arrowhead
  repeated_node,  ///< three different nodes, but not written as a triangle (n3 = n4)
};

/// The shape of one segment in dimensionless numbers, except `size`.
struct SegmentQuality {
  float warp_cosine = 1;  ///< of the largest angle between the two triangles that either diagonal cuts it into
  float slenderness = 1;  ///< altitude over longest edge: area / edge² of a quad, 2 area / edge² of a triangle
  float size = 0;         ///< edge of the square with the same area; a triangle counts as half a square. Deck units
  SegmentFault fault = SegmentFault::none;  ///< if any, `warp_cosine` is meaningless
};

/// Judges a segment by its corners. Any coordinates are allowed.
[[nodiscard]] SegmentQuality segment_quality(const model::SegmentNodes& nodes, const std::vector<Vector>& x);

/// Angle of warp in degrees, 0 to 180.
[[nodiscard]] double warp_degrees(const SegmentQuality& quality);

/// Edge lengths of a segment: largest and smallest; a triangle has three.
struct EdgeRange {
  double shortest = 0, longest = 0;
};
[[nodiscard]] EdgeRange edge_range(const model::SegmentNodes& nodes, const std::vector<Vector>& x);

/// Sizes of the parallelepipeds that an eight-node element's edges span, over the product of their lengths: 1 in a
/// brick, negative where the element is turned inside out.
struct SolidQuality {
  double centre = 1;                   ///< of the three lines through the centre
  double worst_corner = 1;             ///< smallest of the corners; corners at collapsed edges are left out
  NodeIndex corner = none<NodeIndex>;  ///< where that is; none if every corner is collapsed
};

/// Judges an eight-node element or a collapsed form (repeated nodes) of it.
[[nodiscard]] SolidQuality solid_quality(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& x);

}  // namespace gapcheck::contact
