#include "contact/tie/sliding_surface.hpp"

#include <gtest/gtest.h>

namespace gapcheck::contact::sliding_surface_test {
namespace {

/// Two quads beside one another in z = 0, x from 0 to 2, and one that shares no node with them, from 3 to 4.
struct Strip {
  std::vector<Vector> x;
  Segments segments;
  Strip() {
    for (const double at : {0.0, 1.0, 2.0, 3.0, 4.0})
      for (const double y : {0.0, 1.0}) x.emplace_back(at, y, 0);
    const auto node = [](std::uint32_t n) { return NodeIndex{n}; };
    for (const std::uint32_t first : {0U, 2U, 6U})
      segments.nodes.push_back({node(first), node(first + 2), node(first + 3), node(first + 1)});
  }
};

TEST(SlidingSurface, FollowsANodeFromSegmentToSegment) {
  const Strip strip;
  const SlidingSurface surface(strip.segments);
  SegmentIndex at{0};
  for (double way = 0.5; way < 1.9; way += 0.1) {
    const SlidingSurface::Foot foot = surface.nearest(at, Vector(way, 0.3, 0.2), strip.x);
    at = foot.segment;
    EXPECT_NEAR((foot.point - Vector(way, 0.3, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR(foot.normal.z(), 1, 1e-12);
    EXPECT_FALSE(foot.off);
    EXPECT_EQ(at.value, way < 1 ? 0U : 1U) << way;
  }
}

TEST(SlidingSurface, TellsWhenANodeHasLeft) {
  const Strip strip;
  const SlidingSurface surface(strip.segments);
  EXPECT_FALSE(surface.nearest(SegmentIndex{1}, Vector(2.05, 0.5, 0.2), strip.x).off);
  EXPECT_TRUE(surface.nearest(SegmentIndex{1}, Vector(2.2, 0.5, 0.2), strip.x).off);
  EXPECT_EQ(surface.nearest(SegmentIndex{1}, Vector(2.9, 0.5, 0.2), strip.x).segment.value, 1U) << "no jump";
}

}  // namespace
}  // namespace gapcheck::contact::sliding_surface_test
