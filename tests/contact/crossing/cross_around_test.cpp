#include "contact/crossing/cross_around.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace gapcheck::contact::cross_around_test {
namespace {

using geometry::Triangle;

const geometry::Line line{Vector(0, 0, 0), Vector(0, 0, 1)};

/// A triangle on the line that leaves it at an angle, in degrees.
Triangle at(double degrees, double length = 1) {
  const double angle = degrees * std::numbers::pi / 180;
  return {Vector(0, 0, 0), Vector(0, 0, 1), Vector(length * std::cos(angle), length * std::sin(angle), 0.5)};
}

bool cross(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  const bool one = cross_around(line, a, b, 1e-3);
  EXPECT_EQ(one, cross_around(line, b, a, 1e-3)) << "the order does not matter";
  return one;
}

TEST(CrossAround, WaysOnBothSides) {
  EXPECT_TRUE(cross({at(0), at(180)}, {at(90), at(270)})) << "an X";
  EXPECT_TRUE(cross({at(0), at(90)}, {at(45), at(200)})) << "through an edge";
  EXPECT_FALSE(cross({at(0), at(180)}, {at(20), at(90)})) << "on it";
  EXPECT_FALSE(cross({at(0), at(180)}, {at(90)})) << "a T";
  EXPECT_FALSE(cross({at(0)}, {at(90), at(270)})) << "a T";
  EXPECT_FALSE(cross({at(10), at(350)}, {at(90), at(270)})) << "both on one side, across the first direction";
  EXPECT_FALSE(cross({}, {at(90), at(270)}));
}

TEST(CrossAround, ACommonWayIsATouch) {
  EXPECT_FALSE(cross({at(270), at(0)}, {at(0), at(90)})) << "flush sides of two blocks";
  EXPECT_FALSE(cross({at(270), at(0)}, {at(0.02), at(90)})) << "within the tolerance";
  EXPECT_TRUE(cross({at(270), at(0), at(180)}, {at(30), at(200)})) << "three meet in the line";
  EXPECT_TRUE(cross({at(270), at(1)}, {at(0), at(90)})) << "a degree is more than the tolerance: they overlap";
}

TEST(CrossAround, ATriangleAcrossTheLine) {
  const Triangle across{Vector(-1, 0, 0.5), Vector(1, 0, 0), Vector(1, 0, 1)};
  EXPECT_TRUE(cross({across}, {at(90), at(270)}));
  EXPECT_FALSE(cross({across}, {at(90), at(80)}));
  EXPECT_FALSE(cross({across}, {at(0), at(90)}));
}

}  // namespace
}  // namespace gapcheck::contact::cross_around_test
