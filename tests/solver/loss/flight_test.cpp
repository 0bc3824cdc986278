// Motion along straight lines: prescribed motions against sums of small steps.
#include "solver/loss/flight.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gapcheck::solver::flight_test {
namespace {

Motion motion(Motion::Quantity quantity, std::vector<TimeCurve::Point> points, double scale) {
  Motion m(std::move(points));
  m.quantity = quantity;
  m.scale = scale;
  return m;
}

TEST(Flight, WaysAndSpeedsOfMotionsAgreeWithSmallSteps) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 60; ++n) {
    std::vector<TimeCurve::Point> points;
    for (int i = 0; i < 5; ++i) points.push_back({0.3 * i - 0.2 + 0.1 * unit(random), unit(random)});
    const auto quantity = n % 2 == 0 ? Motion::Quantity::velocity : Motion::Quantity::displacement;
    const Motion m = motion(quantity, points, 1 + unit(random));
    constexpr int steps = 20000;
    constexpr double until = 1.5, dt = until / steps;
    double way = 0, lowest = 0, highest = 0, slowest = 1e9, fastest = -1e9;
    for (int i = 0; i < steps; ++i) {
      const double speed = m.velocity(i * dt, dt);
      way += speed * dt;
      lowest = std::min(lowest, way);
      highest = std::max(highest, way);
      slowest = std::min(slowest, speed);
      fastest = std::max(fastest, speed);
    }
    EXPECT_NEAR(way_of(m, until), way, 1e-7);
    const auto ways = ways_of(m, until), speeds = speeds_of(m, 0, until);
    EXPECT_NEAR(ways[0], lowest, 5e-4);
    EXPECT_NEAR(ways[1], highest, 5e-4);
    EXPECT_LE(ways[0], lowest + 1e-7) << "the box must hold all ways";
    EXPECT_GE(ways[1], highest - 1e-7);
    EXPECT_NEAR(speeds[0], slowest, 1e-2);
    EXPECT_NEAR(speeds[1], fastest, 1e-2);
    EXPECT_LE(speeds[0], slowest + 1e-9) << "the bound of the speed must hold";
    EXPECT_GE(speeds[1], fastest - 1e-9);
  }
}

TEST(Flight, ConstantVelocitiesHaveBoxesAndRelativeSpeeds) {
  const Flight flight({Vector(1, -2, 0), Vector(0, 0, 3), Vector::Zero()});
  EXPECT_TRUE(flight.any());
  EXPECT_EQ(flight.way(NodeIndex{0}, 2), Vector(2, -4, 0));
  EXPECT_EQ(flight.ways(NodeIndex{0}, 2).low, Vector(0, -4, 0));
  EXPECT_EQ(flight.ways(NodeIndex{0}, 2).high, Vector(2, 0, 0));
  EXPECT_DOUBLE_EQ(flight.relative_speed(NodeIndex{0}, NodeIndex{1}, 0, 1), std::sqrt(14.));
  EXPECT_FALSE(Flight(std::vector<Vector>(3, Vector::Zero())).any());
}

}  // namespace
}  // namespace gapcheck::solver::flight_test
