#include "geometry/front_side.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/quad.hpp"

namespace gapcheck::geometry::front_side_test {
namespace {

const Facet square{{Vector(-1, -1, 0), Vector(1, -1, 0), Vector(1, 1, 0), Vector(-1, 1, 0)}, false};

/// Over the lowest corner, along the mean normal.
double height(const Facet& facet, const Vector& query) {
  const Vector normal = quad_normal(facet.x).normalized();
  double least = std::numeric_limits<double>::infinity();
  for (const Vector& x : facet.x) least = std::min(least, normal.dot(query - x));
  return least;
}

/// Whether closest_point() sees the query in front, where it sees a side at all.
bool seen_in_front(const Facet& facet, const Vector& query) {
  const ClosestPoint closest = closest_point(facet, query);
  return closest.feature != Feature::face || closest.gap > 0;
}

// Whatever direction point and corners take, within the bound the point stays in front. Half of the trials steer: the
// facet turns about its centre towards the point, or its corners and the point go straight for each other.
TEST(FrontSide, NothingLeavesTheFront) {
  std::mt19937 engine(7);
  const auto number = [&](double size) { return std::uniform_real_distribution<double>(-size, size)(engine); };
  std::size_t bounded = 0, close = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    Facet facet = square;
    const double warp = trial % 2 == 0 ? 0 : 0.4;
    for (Vector& x : facet.x) x += Vector(number(0.6), number(0.6), number(warp));
    facet.triangle = trial % 3 == 0;
    if (facet.triangle) facet.x[3] = facet.x[2];
    const Vector query(number(4), number(4), number(2));
    const double motion = motion_in_front(facet, query, 1);
    EXPECT_LE(motion, std::max(0.0, height(facet, query))) << trial;
    if (!(motion > 0)) continue;
    ++bounded;
    const Vector normal = quad_normal(facet.x).normalized(), centre = (facet.x[0] + facet.x[1] + facet.x[2]) / 3;
    const Vector axis = normal.cross(query - centre).normalized();
    const auto leaves = [&](double share) {
      for (int way = 0; way < 8; ++way) {
        Facet moved = facet;
        double largest = 0;
        for (const Vector& x : facet.x) largest = std::max(largest, axis.cross(x - centre).norm());
        for (Vector& x : moved.x) {
          const Vector turn = axis.cross(x - centre) / largest;
          const Vector to_any = Vector(number(1), number(1), number(1)).normalized();
          x += share * motion / 2 * (way == 0 ? Vector(-turn) : way == 1 ? turn : way == 2 ? normal : to_any);
        }
        if (facet.triangle) moved.x[3] = moved.x[2];
        const Vector at =
            query - share * motion / 2 * (way < 4 ? normal : Vector(number(1), number(1), 1).normalized());
        if (!(height(moved, at) > 0) || !seen_in_front(moved, at)) return true;
      }
      return false;
    };
    EXPECT_FALSE(leaves(0.999)) << trial;
    close += leaves(8);
  }
  EXPECT_GT(bounded, 5000U);
  EXPECT_GT(close, bounded / 4) << "a bound that is too careful by far would be of no use";
}

TEST(FrontSide, FlatSquare) {
  const double motion = motion_in_front(square, Vector(0, 0, 0.1), 1);
  EXPECT_GT(motion, 0.03);
  EXPECT_LT(motion, 0.1);
  EXPECT_EQ(motion_in_front(square, Vector(0, 0, 0.1), -1), 0);
  EXPECT_EQ(motion_in_front(square, Vector(0, 0, -0.1), -1), motion);
  EXPECT_EQ(motion_in_front(square, Vector(5, 0, 0), 1), 0);
}

TEST(FrontSide, NoneWhereTheFacetHasNoSides) {
  Facet folded = square;
  folded.x[2] = Vector(-0.5, -0.5, 0);  // concave: the corner's normal looks the other way
  EXPECT_EQ(motion_in_front(folded, Vector(0, 0, 1), 1), 0);
  const Facet line{{Vector(-1, 0, 0), Vector(1, 0, 0), Vector(1, 0, 0), Vector(-1, 0, 0)}, false};
  EXPECT_EQ(motion_in_front(line, Vector(0, 0, 1), 1), 0);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e300}) {
    Facet facet = square;
    facet.x[2].x() = bad;
    EXPECT_EQ(motion_in_front(facet, Vector(0, 0, 1), 1), 0) << bad;
    EXPECT_EQ(motion_in_front(square, Vector(0, 0, bad), 1), 0) << bad;
  }
}

}  // namespace
}  // namespace gapcheck::geometry::front_side_test
