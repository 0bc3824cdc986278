#include "solver/state/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapcheck::solver::motion_test {
namespace {

/// From 1 to 3 up by 4, then level until 5.
const std::vector<TimeCurve::Point> points{{1, 2}, {3, 6}, {5, 6}};

TEST(TimeCurve, ValuesAndSlopes) {
  const TimeCurve curve(points);
  for (const auto& [time, value, slope] :
       {std::array{0., 2., 0.}, {1., 2., 2.}, {2., 4., 2.}, {3., 6., 0.}, {4., 6., 0.}, {9., 6., 0.}}) {
    EXPECT_DOUBLE_EQ(curve.at(time), value) << time;
    EXPECT_DOUBLE_EQ(curve.slope(time), slope) << time;
  }
  EXPECT_EQ(curve.start(), 1);
  EXPECT_EQ(TimeCurve().at(1), 0);
  EXPECT_EQ(TimeCurve().integral(1), 0);
}

// 2 τ + τ² from the first point on, τ = t − 1; 8 at the second point, 6 per time after it; −2 per time before the
// first.
TEST(TimeCurve, Integral) {
  const TimeCurve curve(points);
  for (const auto& [time, integral] :
       {std::array{-1., -4.}, {0.5, -1.}, {1., 0.}, {1.5, 1.25}, {2., 3.}, {3., 8.}, {4., 14.}, {5., 20.}, {7., 32.}})
    EXPECT_DOUBLE_EQ(curve.integral(time), integral) << time;
}

// Of a step of 0.5 from 1.5 on: velocity at 1.75, mean of the displacement's rate, integral of the acceleration.
TEST(Motion, VelocityByQuantity) {
  Motion motion(points);
  motion.scale = 3;
  EXPECT_DOUBLE_EQ(motion.velocity(1.5, 0.5), 3 * 3.5);
  motion.quantity = Motion::Quantity::displacement;
  EXPECT_DOUBLE_EQ(motion.velocity(1.5, 0.5), 3 * 2);
  EXPECT_DOUBLE_EQ(motion.velocity(2.5, 1), 3 * (6 - 5));
  EXPECT_DOUBLE_EQ(motion.velocity(2, 0), 3 * 2);
  motion.quantity = Motion::Quantity::acceleration;
  motion.initial = 10;
  // The curve's value before its first point counts from time 0 on.
  EXPECT_DOUBLE_EQ(motion.velocity(1.5, 0.5), 10 + 3 * (2 * 0.75 + 0.75 * 0.75 + 2));
  EXPECT_DOUBLE_EQ(motion.velocity(4, 2), 10 + 3 * (20 + 2));
  // With a birth the curve begins there.
  motion.birth = 2;
  EXPECT_DOUBLE_EQ(motion.velocity(2.5, 0.5), 10 + 3 * (2 * 0.75 + 0.75 * 0.75));
  EXPECT_EQ(Motion().velocity(1, 1), 0);
}

TEST(Motion, ActsBetweenBirthAndDeath) {
  Motion motion(points);
  motion.birth = 1;
  motion.death = 2;
  EXPECT_FALSE(motion.active(0.5, 0.5));
  EXPECT_TRUE(motion.active(0.75, 0.5));
  EXPECT_TRUE(motion.active(1.75, 0.5));
  EXPECT_FALSE(motion.active(2, 0.5));
  EXPECT_FALSE(motion.active(0.5, 0));
  EXPECT_TRUE(motion.active(1, 0));
}

}  // namespace
}  // namespace gapcheck::solver::motion_test
