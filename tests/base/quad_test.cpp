#include "base/quad.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace gapcheck::quad_test {
namespace {

const std::array<Vector, 4> rectangle{Vector(0, 0, 1), Vector(2, 0, 1), Vector(2, 3, 1), Vector(0, 3, 1)};

TEST(Quad, NormalIsTwiceTheArea) {
  EXPECT_EQ(quad_normal(rectangle), Vector(0, 0, 12));
  const auto& [a, b, c, d] = rectangle;
  EXPECT_EQ(quad_normal(a, b, c, c), Vector(0, 0, 6));
}

TEST(Quad, NormalOfNodes) {
  const std::vector<Vector> x{rectangle[3], rectangle[0], rectangle[1], rectangle[2]};
  const std::array<NodeIndex, 4> nodes{NodeIndex{1}, NodeIndex{2}, NodeIndex{3}, NodeIndex{0}};
  EXPECT_EQ(quad_normal(nodes, x), quad_normal(rectangle));
}

TEST(Quad, WeightsOfCornersAndMiddle) {
  EXPECT_EQ(quad_weights(-1, -1), (std::array<double, 4>{1, 0, 0, 0}));
  EXPECT_EQ(quad_weights(1, -1), (std::array<double, 4>{0, 1, 0, 0}));
  EXPECT_EQ(quad_weights(1, 1), (std::array<double, 4>{0, 0, 1, 0}));
  EXPECT_EQ(quad_weights(-1, 1), (std::array<double, 4>{0, 0, 0, 1}));
  EXPECT_EQ(quad_weights(0, 0), (std::array<double, 4>{0.25, 0.25, 0.25, 0.25}));
}

// Halves and quarters are exact: the formula of the textbooks gives the same bits.
TEST(Quad, WeightsRoundLikeTheProductDividedByFour) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (int i = 0; i < 10000; ++i) {
    const double s = uniform(random), t = uniform(random);
    const std::array<double, 4> expected{(1 - s) * (1 - t) / 4, (1 + s) * (1 - t) / 4, (1 + s) * (1 + t) / 4,
                                         (1 - s) * (1 + t) / 4};
    ASSERT_EQ(quad_weights(s, t), expected) << s << ' ' << t;
  }
}

TEST(Quad, PointOfTheRectangle) {
  EXPECT_EQ(quad_point(rectangle, -1, 1), rectangle[3]);
  EXPECT_EQ(quad_point(rectangle, 0, 0), Vector(1, 1.5, 1));
}

}  // namespace
}  // namespace gapcheck::quad_test
