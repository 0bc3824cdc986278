#include "contact/rigid_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapcheck::contact::rigid_wall_test {
namespace {

using Shape = model::RigidWall::Shape;

double depth(const model::RigidWall& wall, const Vector& x) {
  const auto in = wall_penetration(wall, x);
  return in ? in->depth : 0;
}

TEST(RigidWall, SlantedPlane) {
  model::RigidWall wall;
  wall.tail = Vector(1, 1, 1);
  wall.normal = Vector(3, 0, 4) / 5;
  EXPECT_DOUBLE_EQ(depth(wall, Vector(1 - 3, 7, 1 - 4)), 5);
  EXPECT_TRUE(wall_penetration(wall, Vector(1 - 3, 7, 1 - 4))->surface.isApprox(Vector(1, 7, 1)));
  EXPECT_EQ(depth(wall, Vector(1 + 4e6, -2, 1 - 3e6)), 0);  // on the plane, but for rounding
  EXPECT_EQ(depth(wall, Vector(5, 5, 5)), 0);
  EXPECT_EQ(depth(wall, Vector(NAN, 0, 0)), 0);
}

TEST(RigidWall, InfiniteInOneDirectionOnly) {
  model::RigidWall wall;
  wall.length_l = 2;  // along x; no end along y
  EXPECT_EQ(depth(wall, Vector(1, -1e6, -1)), 1);
  EXPECT_EQ(depth(wall, Vector(3, 0, -1)), 0);
  EXPECT_EQ(depth(wall, Vector(-1, 0, -1)), 0);
}

TEST(RigidWall, PrismByItsNearestFace) {
  model::RigidWall wall;
  wall.shape = Shape::prism;
  wall.length_l = 10, wall.length_m = 10, wall.length_p = 10;
  EXPECT_EQ(depth(wall, Vector(5, 5, -1)), 1);
  EXPECT_EQ(depth(wall, Vector(5, 5, -9)), 1);
  EXPECT_EQ(depth(wall, Vector(2, 5, -5)), 2);
  EXPECT_EQ(wall_penetration(wall, Vector(2, 5, -5))->surface, Vector(0, 5, -5));
  EXPECT_EQ(depth(wall, Vector(5, 5, -11)), 0);
  wall.length_l = wall.length_m = wall.length_p = model::RigidWall::infinite;
  EXPECT_EQ(depth(wall, Vector(-500, 5, -500)), 500);
}

TEST(RigidWall, CylinderEndsAndInterior) {
  model::RigidWall wall;
  wall.shape = Shape::cylinder;
  wall.radius = 3;
  EXPECT_EQ(depth(wall, Vector(2, 0, -100)), 1);
  EXPECT_EQ(depth(wall, Vector(0, 0, 0)), 3);  // on the axis: any way out
  wall.length_l = 10;
  EXPECT_EQ(depth(wall, Vector(2, 0, -100)), 0);
  EXPECT_EQ(depth(wall, Vector(0, 0, 9.5)), 0.5);
  EXPECT_EQ(wall_penetration(wall, Vector(0, 0, 9.5))->surface, Vector(0, 0, 10));
  wall.interior = true;
  EXPECT_EQ(depth(wall, Vector(2, 0, 5)), 0);
  EXPECT_EQ(depth(wall, Vector(5, 0, 5)), 2);
  EXPECT_EQ(depth(wall, Vector(5, 0, 11)), 0);
}

TEST(RigidWall, Sphere) {
  model::RigidWall wall;
  wall.shape = Shape::sphere;
  wall.tail = Vector(0, 0, 1);
  wall.radius = 6;
  EXPECT_DOUBLE_EQ(depth(wall, Vector(3, 0, 5)), 1);
  EXPECT_EQ(depth(wall, Vector(0, 0, 7)), 0);  // touches
}

}  // namespace
}  // namespace gapcheck::contact::rigid_wall_test
