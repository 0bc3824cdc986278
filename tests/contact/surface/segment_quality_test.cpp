#include "contact/surface/segment_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gapcheck::contact::segment_quality_test {
namespace {

SegmentQuality quality(const std::vector<Vector>& x, bool triangle = false) {
  return segment_quality({NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{triangle ? 2U : 3U}}, x);
}

TEST(SegmentQuality, Rectangle) {
  const SegmentQuality q = quality({{0, 0, 0}, {8, 0, 0}, {8, 2, 0}, {0, 2, 0}});
  EXPECT_EQ(q.fault, SegmentFault::none);
  EXPECT_FLOAT_EQ(q.size, 4);
  EXPECT_FLOAT_EQ(q.slenderness, 0.25);
  EXPECT_EQ(warp_degrees(q), 0);
}

TEST(SegmentQuality, TriangleIsHalfOfASquare) {
  const SegmentQuality q = quality({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, true);
  EXPECT_FLOAT_EQ(q.size, 3);
  EXPECT_FLOAT_EQ(q.slenderness, 0.5);  // altitude 3/√2 over 3√2
}

TEST(SegmentQuality, WarpIsTheLargerOfBothCuts) {
  // cos = 1 / 1.16 along the first diagonal, 1 / √1.32 along the other.
  const SegmentQuality q = quality({{0, 0, 0}, {10, 0, 0}, {10, 10, 4}, {0, 10, 0}});
  EXPECT_NEAR(warp_degrees(q), std::acos(1 / 1.16) * 180 / M_PI, 1e-4);
}

TEST(SegmentQuality, ShapesThatAreNone) {
  const Vector a(0, 0, 0), b(10, 0, 0), c(10, 10, 0), d(0, 10, 0), low(4, 1, 0), middle(5, 0, 0);
  EXPECT_EQ(quality({a, c, b, d}).fault, SegmentFault::crossed);                 // equal lobes
  EXPECT_EQ(quality({a, c, Vector(10, 3, 0), d}).fault, SegmentFault::crossed);  // one lobe larger
  EXPECT_EQ(quality({a, b, d, Vector(2, 2, 0)}).fault, SegmentFault::folded);
  EXPECT_EQ(quality({a, middle, b, b}).fault, SegmentFault::zero_area);
  EXPECT_EQ(quality({a, a, a, a}).fault, SegmentFault::zero_area);
  EXPECT_EQ(quality({a, b, c, Vector(0, NAN, 0)}).fault, SegmentFault::not_finite);
  EXPECT_EQ(quality({a, b, c, Vector(0, INFINITY, 0)}).fault, SegmentFault::not_finite);
  const NodeIndex n0{0}, n1{1}, n2{2};
  EXPECT_EQ(segment_quality({n0, n1, n0, n0}, {a, b, c}).fault, SegmentFault::few_nodes);
  EXPECT_EQ(segment_quality({n0, n1, n2, n0}, {a, b, c}).fault, SegmentFault::repeated_node);
  EXPECT_EQ(segment_quality({n0, n0, n1, n2}, {a, b, c}).fault, SegmentFault::repeated_node);
}

TEST(SegmentQuality, DoesNotDependOnSizeAndStart) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const std::vector<Vector> x{Vector(0, 0, 0), Vector(scale, 0, 0), Vector(1.5 * scale, scale, 0),
                                Vector(0, 0.8 * scale, 0.1 * scale)};
    const SegmentQuality q = quality(x), turned = quality({x[2], x[3], x[0], x[1]}),
                         back = quality({x[3], x[2], x[1], x[0]});
    EXPECT_EQ(q.fault, SegmentFault::none);
    EXPECT_NEAR(q.warp_cosine, turned.warp_cosine, 1e-6);
    EXPECT_NEAR(q.warp_cosine, back.warp_cosine, 1e-6);
    EXPECT_NEAR(q.slenderness, quality({{0, 0, 0}, {1, 0, 0}, {1.5, 1, 0}, {0, 0.8, 0.1}}).slenderness, 1e-6);
  }
}

TEST(EdgeRange, OfATriangleAndAQuad) {
  const std::vector<Vector> x{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 5, 0}};
  const EdgeRange triangle = edge_range({NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{2}}, x);
  EXPECT_DOUBLE_EQ(triangle.shortest, 3);
  EXPECT_DOUBLE_EQ(triangle.longest, 5);
  const EdgeRange quad = edge_range({NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{3}}, x);
  EXPECT_DOUBLE_EQ(quad.shortest, 3);
  EXPECT_DOUBLE_EQ(quad.longest, 5);
}

std::array<NodeIndex, 8> eight(std::array<std::uint32_t, 8> n) {
  std::array<NodeIndex, 8> nodes{};
  for (std::size_t i = 0; i < 8; ++i) nodes[i] = NodeIndex{n[i]};
  return nodes;
}

TEST(SolidQuality, BrickAndItsMirrorImage) {
  const std::vector<Vector> x{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}, {0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}};
  const SolidQuality brick = solid_quality(eight({0, 1, 2, 3, 4, 5, 6, 7}), x);
  EXPECT_DOUBLE_EQ(brick.centre, 1);
  EXPECT_DOUBLE_EQ(brick.worst_corner, 1);
  const SolidQuality mirrored = solid_quality(eight({4, 5, 6, 7, 0, 1, 2, 3}), x);
  EXPECT_DOUBLE_EQ(mirrored.centre, -1);
  EXPECT_DOUBLE_EQ(mirrored.worst_corner, -1);
}

TEST(SolidQuality, CollapsedForms) {
  const std::vector<Vector> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                              {1, 0, 1}, {0, 1, 1}, {1, 1, 0}, {0.5, 0.5, 1}};
  const auto good = [&](std::array<std::uint32_t, 8> n) {
    const SolidQuality q = solid_quality(eight(n), x);
    return q.centre > 1e-3 && q.worst_corner > 1e-3;
  };
  EXPECT_TRUE(good({0, 1, 2, 3, 3, 3, 3, 3}));  // tetrahedron
  EXPECT_FALSE(good({0, 2, 1, 3, 3, 3, 3, 3}));
  EXPECT_TRUE(good({0, 1, 2, 2, 3, 4, 5, 5}));  // wedge with collapsed quads
  EXPECT_FALSE(good({3, 4, 5, 5, 0, 1, 2, 2}));
  EXPECT_TRUE(good({0, 1, 4, 3, 2, 2, 5, 5}) || good({3, 4, 1, 0, 5, 5, 2, 2}));  // wedge along the other axis, one way
  EXPECT_TRUE(good({0, 1, 6, 2, 7, 7, 7, 7}));                                    // pyramid
  EXPECT_FALSE(good({2, 6, 1, 0, 7, 7, 7, 7}));
}

}  // namespace
}  // namespace gapcheck::contact::segment_quality_test
