// When a moving node meets a moving segment: closed forms, and a walk in small steps as the slow twin.
#include "solver/loss/time_of_contact.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gapcheck::solver::time_of_contact_test {
namespace {

using Kind = TimeOfContact::Kind;

/// Node 4 and the segment of the nodes 0 … 3.
struct Scene {
  MovingPair pair;
  std::vector<Vector> v = std::vector<Vector>(5, Vector::Zero());
  Scene() {
    pair.facet.x = {Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)};
    for (std::uint32_t i = 0; i < 4; ++i) pair.corners[i] = NodeIndex{i};
    pair.node = NodeIndex{4};
    pair.contact_distance = 0.25;
  }
  [[nodiscard]] TimeOfContact meet(double until) const { return time_of_contact(Flight(v), pair, until); }
  [[nodiscard]] double distance(double time) const {
    geometry::Facet facet = pair.facet;
    for (std::size_t i = 0; i < 4; ++i) facet.x[i] += time * v[i];
    const Vector point = pair.point + time * v[4];
    if (pair.line) return std::sqrt(geometry::closest_point_on_line(facet.x[0], facet.x[1], point).squared_distance);
    return std::sqrt(geometry::closest_point(facet, point).squared_distance);
  }
};

TEST(TimeOfContact, FlatContactIsMetInOneStep) {
  Scene scene;
  scene.pair.point = Vector(0.3, 0.4, 1.25);
  scene.v[4] = Vector(0.2, 0.1, -2);
  const TimeOfContact contact = scene.meet(10);
  ASSERT_EQ(contact.kind, Kind::met);
  EXPECT_DOUBLE_EQ(contact.time, 0.5);
  EXPECT_DOUBLE_EQ(contact.speed(), 2);
  EXPECT_NEAR((contact.normal - Vector::UnitZ()).norm(), 0, 1e-15);
  EXPECT_EQ(contact.steps, 2u);
  EXPECT_NEAR(contact.weights[0], (1 - 0.4) * (1 - 0.45), 1e-12) << "at 0.4, 0.45 of the quad";
  EXPECT_EQ(scene.meet(0.499).kind, Kind::none);
  // The segment comes instead.
  for (std::size_t i = 0; i < 4; ++i) scene.v[i] = -scene.v[4];
  scene.v[4].setZero();
  EXPECT_DOUBLE_EQ(scene.meet(10).time, 0.5);
  // Both go the same way.
  scene.v[4] = scene.v[0];
  EXPECT_EQ(scene.meet(1e9).kind, Kind::none);
}

TEST(TimeOfContact, AnEdgeIsMetOnItsCylinder) {
  Scene scene;
  scene.pair.contact_distance = 0.5;
  scene.pair.point = Vector(-5, 0.5, 0.3);
  scene.v[4] = Vector(2, 0, 0);
  const TimeOfContact contact = scene.meet(10);
  ASSERT_EQ(contact.kind, Kind::met);
  EXPECT_NEAR(contact.time, (5 - 0.4) / 2, 1e-9);
  EXPECT_NEAR(contact.speed(), 2 * 0.8, 1e-8);
}

TEST(TimeOfContact, ABeamAxisIsMetOnItsCylinder) {
  Scene scene;
  scene.pair.line = true;
  scene.pair.point = Vector(0.5, 3, 0.15);
  scene.v[4] = Vector(0, -1, 0);
  const TimeOfContact contact = scene.meet(10);
  ASSERT_EQ(contact.kind, Kind::met);
  EXPECT_NEAR(contact.time, 3 - 0.2, 1e-9);
  EXPECT_NEAR(contact.weights[0], 0.5, 1e-12);
}

TEST(TimeOfContact, WhatIsInsideFromTheStartHasBegun) {
  Scene scene;
  scene.pair.point = Vector(0.5, 0.5, 0.2);
  scene.v[4] = Vector(0, 0, -1);
  EXPECT_EQ(scene.meet(1).kind, Kind::begun);
  scene.pair.point.z() = 0.25;
  EXPECT_EQ(scene.meet(1).kind, Kind::met);
  EXPECT_EQ(scene.meet(1).time, 0);
}

TEST(TimeOfContact, WhereNothingCountsItIsMetWhenItBeginsToCount) {
  Scene scene;
  scene.pair.point = Vector(-1, 0.5, 0.1);
  scene.v[4] = Vector(1, 0, 0);
  // Only over the face, at x = 0; it is near enough since x = -0.229.
  scene.pair.counts = [](const geometry::ClosestPoint& closest) { return std::abs(closest.free_s) <= 1; };
  const TimeOfContact contact = scene.meet(10);
  ASSERT_EQ(contact.kind, Kind::met);
  EXPECT_NEAR(contact.time, 1, 1e-9);
  scene.pair.counts = [](const geometry::ClosestPoint&) { return false; };
  EXPECT_EQ(scene.meet(10).kind, Kind::none);
}

TEST(TimeOfContact, AgreesWithAWalkInSmallStepsOnRandomScenes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vector(unit(random), unit(random), unit(random)); };
  constexpr int steps = 4000;
  constexpr double until = 4;
  int met = 0, none = 0, grazed = 0;
  std::uint64_t closest_points = 0;
  for (int n = 0; n < 400; ++n) {
    Scene scene;
    scene.pair.contact_distance = 0.05 + 0.2 * std::abs(unit(random));
    for (Vector& corner : scene.pair.facet.x) corner += 0.3 * vector();
    if (n % 4 == 1) {
      scene.pair.facet.x[3] = scene.pair.facet.x[2];
      scene.pair.corners[3] = scene.pair.corners[2];
      scene.pair.facet.triangle = true;
    }
    scene.pair.line = n % 4 == 2;
    const Vector common = vector();
    for (Vector& v : scene.v) v = n % 3 == 0 ? common : Vector(common + 0.3 * vector());
    if (n % 4 == 1) scene.v[3] = scene.v[2];
    scene.pair.point = 2.5 * vector();
    scene.v[4] = common + 0.5 * (Vector(0.5, 0.5, 0) - scene.pair.point) + 0.2 * vector();
    const TimeOfContact contact = scene.meet(until);
    closest_points += contact.steps;
    const double h = scene.pair.contact_distance;
    double walked = -1, least = 1e9;
    for (int i = 0; i <= steps && walked < 0; ++i) {
      const double time = until * i / steps, distance = scene.distance(time);
      least = std::min(least, distance);
      if (distance <= h) walked = time;
    }
    SCOPED_TRACE(n);
    ASSERT_NE(contact.kind, Kind::undecided);
    if (walked == 0) {
      EXPECT_EQ(contact.kind, Kind::begun);
    } else if (walked > 0) {
      ++met;
      ASSERT_EQ(contact.kind, Kind::met) << "a contact is missed";
      EXPECT_LE(contact.time, walked + 1e-8);
      EXPECT_GE(contact.time, walked - until / steps - 1e-8) << "it is met too early";
      EXPECT_NEAR(scene.distance(contact.time), h, 2e-9);
    } else if (contact.kind == Kind::met) {
      ++grazed;
      EXPECT_NEAR(scene.distance(contact.time), h, 2e-9);
      EXPECT_NEAR(least, h, 1e-5) << "it is met between two steps of the walk";
    } else {
      ++none;
      EXPECT_EQ(contact.kind, Kind::none);
    }
  }
  fmt::print("{} met, {} not, {} grazed; {:.1f} closest points for each\n", met, none, grazed,
             static_cast<double>(closest_points) / 400);
  EXPECT_GT(met, 100);
  EXPECT_GT(none, 50);
}

}  // namespace
}  // namespace gapcheck::solver::time_of_contact_test
