#include "report/item/nearest_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace gapcheck::report::nearest_points_test {
namespace {

using Found = std::vector<std::pair<double, std::uint32_t>>;

TEST(NearestPoints, AsComparingAllOfThem) {
  std::mt19937 random(5);
  for (const std::size_t count : {0, 1, 2, 3, 10, 500}) {
    std::uniform_real_distribution<double> coordinate(-3, 3);
    std::vector<NearestPoints::Point> points;
    for (std::uint32_t i = 0; i < count; ++i)
      points.emplace_back(Vector(coordinate(random), coordinate(random), 0.1 * coordinate(random)), i);
    const NearestPoints tree(points);
    for (int n = 0; n < 200; ++n) {
      const Vector x(coordinate(random), coordinate(random), coordinate(random));
      const double radius = std::abs(coordinate(random));
      Found all, found;
      for (const auto& [point, id] : points)
        if (const double distance = (point - x).norm(); distance <= radius) all.emplace_back(distance, id);
      std::sort(all.begin(), all.end());
      if (all.size() > 8) all.resize(8);
      tree.nearest(x, radius, 8, found);
      EXPECT_EQ(found, all);
    }
  }
}

TEST(NearestPoints, ManyInOnePlace) {
  const NearestPoints tree(std::vector<NearestPoints::Point>(200'000, {Vector(1, 2, 3), 7}));
  Found found;
  for (int n = 0; n < 20'000; ++n) tree.nearest(Vector(1, 2, 3), 1, 8, found);
  EXPECT_EQ(found, Found(8, {0, 7}));
  tree.nearest(Vector(1, 2, 3), 0, 8, found);
  EXPECT_EQ(found.size(), 8U) << "the radius itself counts";
  tree.nearest(Vector(1, 2, 5), 1, 8, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace gapcheck::report::nearest_points_test
