#include "solver/contact/segment_axes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gapcheck::solver::segment_axes_test {
namespace {

const model::SegmentNodes quad{NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{3}},
    triangle{NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{2}};

class Random {
 public:
  Vector vector() { return {number_(engine_), number_(engine_), number_(engine_)}; }
  std::vector<Vector> four(const std::vector<Vector>& about) {
    std::vector<Vector> list;
    for (const Vector& x : about) list.push_back(x + 0.3 * vector());
    return list;
  }

 private:
  std::mt19937 engine_{4};
  std::uniform_real_distribution<double> number_{-1, 1};
};

const std::vector<Vector> rectangle{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, zeros(4, Vector::Zero());

// The normal of the diagonals, and their bisector in the plane: the y axis in a rectangle. In a triangle of two sides.
TEST(SegmentAxes, NormalAndBisector) {
  const SegmentAxes axes(quad, rectangle);
  ASSERT_TRUE(axes.sound);
  EXPECT_NEAR((axes.axes.col(0) - Vector::UnitY()).norm(), 0, 1e-15);
  EXPECT_NEAR((axes.axes.col(1) + Vector::UnitX()).norm(), 0, 1e-15);
  EXPECT_NEAR((axes.axes.col(2) - Vector::UnitZ()).norm(), 0, 1e-15);
  const SegmentAxes of_triangle(triangle, {{0, 0, 0}, {0, 3, 0}, {0, 0, 2}, {0, 0, 2}});
  ASSERT_TRUE(of_triangle.sound);
  EXPECT_NEAR((of_triangle.axes.col(0) - Vector(0, 1, 1).normalized()).norm(), 0, 1e-15);
  EXPECT_NEAR((of_triangle.axes.col(2) - Vector::UnitX()).norm(), 0, 1e-15);
}

// Any motion of the corners: the axes' rates by differences are spin × axis. A rigid rotation is that spin itself.
TEST(SegmentAxes, SpinIsTheRateOfTheAxes) {
  Random random;
  for (int trial = 0; trial < 20; ++trial)
    for (const model::SegmentNodes& nodes : {quad, triangle}) {
      const std::vector<Vector> x = random.four(rectangle), v = random.four(zeros);
      constexpr double step = 1e-5;
      const SegmentAxes axes(nodes, x), after(nodes, x, v, step), before(nodes, x, v, -step);
      const Vector spin = axes.spin(nodes, v);
      EXPECT_GT(spin.norm(), 1e-3);
      for (int axis = 0; axis < 3; ++axis) {
        const Vector rate = (after.axes.col(axis) - before.axes.col(axis)) / (2 * step);
        EXPECT_NEAR((rate - spin.cross(Vector(axes.axes.col(axis)))).norm(), 0, 1e-7) << trial;
      }
      const Vector turning = random.vector(), centre = random.vector();
      std::vector<Vector> rigid;
      for (const Vector& at : x) rigid.push_back(turning.cross(at - centre) + Vector(1, 2, 3));
      EXPECT_NEAR((axes.spin(nodes, rigid) - turning).norm(), 0, 1e-12) << trial;
    }
}

TEST(SegmentAxes, WithoutAreaThereAreNone) {
  EXPECT_FALSE(SegmentAxes(quad, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).sound);
  EXPECT_FALSE(SegmentAxes(triangle, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {2, 2, 2}}).sound);
  EXPECT_FALSE(SegmentAxes(quad, zeros).sound);
}

}  // namespace
}  // namespace gapcheck::solver::segment_axes_test
