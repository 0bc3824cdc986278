#include "solver/rigid/rigid_body.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapcheck::solver::rigid_body_test {
namespace {

/// Point masses with the principal inertias 1, 2 and 2.5 about x, y, z.
RigidBody brick() {
  // Six points ± a on each axis with mass ½ each: Ixx = b² + c², and so on.
  const double a = std::sqrt(1.75), b = std::sqrt(0.75), c = std::sqrt(0.25);
  const std::vector<PointMass> points{{{a, 0, 0}, 0.5},  {{-a, 0, 0}, 0.5}, {{0, b, 0}, 0.5},
                                      {{0, -b, 0}, 0.5}, {{0, 0, c}, 0.5},  {{0, 0, -c}, 0.5}};
  return RigidBody(points, 0);
}

TEST(RigidBody, MassCentreInertia) {
  const RigidBody body = brick();
  EXPECT_DOUBLE_EQ(body.mass(), 3);
  EXPECT_NEAR((body.inertia() - Matrix(Vector(1, 2, 2.5).asDiagonal())).norm(), 0, 1e-14);
  const std::vector<PointMass> two{{{1, 0, 0}, 1}, {{4, 0, 0}, 2}};
  const RigidBody line(two, 0);
  EXPECT_NEAR((line.center() - Vector(3, 0, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR(line.inertia()(1, 1), 1 * 4 + 2 * 1, 1e-14);
  EXPECT_GT(line.inertia()(0, 0), 0);
}

// Spun about its middle axis it tumbles; momentum and energy stay for ever.
TEST(RigidBody, FreeSpinKeepsMomentumAndEnergy) {
  RigidBody body = brick();
  body.set_motion({1, 2, 3}, {0.01, 3, 0.02});
  const Vector momentum = body.angular_momentum();
  const double energy = momentum.dot(body.angular_velocity()) / 2;
  bool tumbled = false;
  for (int i = 0; i < 20000; ++i) {
    body.accelerate(Vector::Zero(), Vector::Zero(), 0.01, {});
    body.move(0.01);
    tumbled |= body.rotation()(1, 1) < -0.9;
  }
  EXPECT_TRUE(tumbled);
  EXPECT_EQ((body.angular_momentum() - momentum).norm(), 0);
  EXPECT_NEAR(momentum.dot(body.angular_velocity()) / 2 / energy, 1, 1e-10);
  EXPECT_NEAR((body.rotation() * body.rotation().transpose() - Matrix::Identity()).norm(), 0, 1e-10);
  EXPECT_NEAR((body.center() - 200 * Vector(1, 2, 3)).norm(), 0, 1e-8);
}

// About a principal axis the angle is 2 atan(ω dt / 2) per step: second order.
TEST(RigidBody, SteadySpin) {
  RigidBody body = brick();
  body.set_motion(Vector::Zero(), {0, 0, 2});
  for (int i = 0; i < 100; ++i) body.move(0.01);
  const double angle = 100 * 2 * std::atan(0.01);
  EXPECT_NEAR(body.rotation()(0, 0), std::cos(angle), 1e-13);
  EXPECT_NEAR(body.rotation()(1, 0), std::sin(angle), 1e-13);
  EXPECT_NEAR((body.place({1, 0, 0}) - Vector(std::cos(angle), std::sin(angle), 0)).norm(), 0, 1e-13);
}

// V = F t / m, ω = T t / I about a principal axis; the direction held does not move.
TEST(RigidBody, ForceTorqueAndHeldDirections) {
  RigidBody body = brick();
  for (int i = 0; i < 100; ++i) {
    body.accelerate({3, 6, 0}, {0, 0, 2.5}, 0.01, {.freedoms = 2});
    body.move(0.01);
  }
  EXPECT_NEAR(body.velocity().x(), 1, 1e-13);
  EXPECT_EQ(body.velocity().y(), 0);
  EXPECT_NEAR(body.angular_velocity().z(), 1, 1e-12);
  EXPECT_NEAR(body.center().x(), 0.5 * 1.01, 1e-12);
}

}  // namespace
}  // namespace gapcheck::solver::rigid_body_test
