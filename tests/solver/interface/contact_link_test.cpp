#include "solver/interface/contact_link.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace gapcheck::solver::contact_link_test {
namespace {

constexpr double stiffness = 100, depth = 0.02, dt = 0.1;  // pushes with 2

LinkForce force(const LinkSpring& spring, const Vector& velocity, const Vector& before = Vector::Zero(),
                double penetration = depth) {
  LinkForce link;
  link.normal = Vector::UnitZ();
  link.set_forces(spring, penetration, velocity, before, dt);
  return link;
}

LinkSpring spring() {
  LinkSpring s;
  s.stiffness = stiffness;
  return s;
}

TEST(ContactLink, PushesInProportionToTheDepth) {
  const LinkForce link = force(spring(), {1, 2, 3});
  EXPECT_DOUBLE_EQ(link.push, 2);
  EXPECT_EQ(link.damping, 0);
  EXPECT_EQ(link.friction, Vector::Zero());
  EXPECT_DOUBLE_EQ(link.stored(depth), 100 * 0.02 * 0.02 / 2);
  EXPECT_EQ(force(spring(), {0, 0, 0}, Vector::Zero(), -depth).push, 0) << "it never pulls";
}

TEST(ContactLink, DampingActsBothWaysButNeverPulls) {
  LinkSpring damped = spring();
  damped.damping = 5;
  EXPECT_DOUBLE_EQ(force(damped, {7, 0, -0.1}).damping, 0.5);
  EXPECT_DOUBLE_EQ(force(damped, {7, 0, 0.1}).damping, -0.5);
  EXPECT_DOUBLE_EQ(force(damped, {7, 0, 10}).damping, -2);
}

TEST(ContactLink, FrictionIsASpringUpToItsLimit) {
  LinkSpring rough = spring();
  rough.rubs = true;
  rough.friction = {0.3, 0.3, 0, 0};
  const Vector before(0.1, 0, 0.5);  // the normal has turned: its part along it is dropped
  EXPECT_NEAR((force(rough, {0.01, -0.02, 0}, before).friction - Vector(0.1 - 0.1, 0.2, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((force(rough, {1, 0, -3}).friction - Vector(-0.6, 0, 0)).norm(), 0, 1e-15);
}

// The limit counts what presses, damping included.
TEST(ContactLink, FrictionIsLimitedByPushAndDamping) {
  LinkSpring rough = spring();
  rough.rubs = true;
  rough.friction = {0.3, 0.3, 0, 0};
  rough.damping = 5;
  EXPECT_NEAR(force(rough, {1, 0, -0.1}).friction.x(), -0.3 * 2.5, 1e-15);
  EXPECT_NEAR(force(rough, {1, 0, 0.1}).friction.x(), -0.3 * 1.5, 1e-15);
  EXPECT_NEAR(force(rough, {1, 0, 10}).friction.norm(), 0, 1e-15) << "nothing presses";
}

// Each half of a step counts the work of the force at one of its ends.
TEST(ContactLink, WorkOfOneStep) {
  LinkSpring rough = spring();
  rough.rubs = true;
  rough.friction = {0.3, 0.3, 0, 0};
  rough.damping = 5;
  const Vector tracked(1, 0, -0.1), reference(0, 0, 0.2);
  const LinkForce link = force(rough, tracked - reference);
  LinkWork work;
  work.add(link, tracked, reference, dt);
  EXPECT_NEAR(work.damping, dt / 2 * 1.5 * 0.3, 1e-15);
  EXPECT_NEAR(work.friction, dt / 2 * 0.3 * 3.5 * 1, 1e-15);
  EXPECT_NEAR(work.on_tracked, dt / 2 * (3.5 * 0.1 + 0.3 * 3.5), 1e-15);
  EXPECT_NEAR(work.on_reference, dt / 2 * 3.5 * 0.2, 1e-15);
}

// By side: `exchanged` is the pass whose tracked points are on side B.
TEST(ContactLink, EnergiesBySide) {
  const LinkWork work{.friction = 1, .damping = 2, .on_tracked = 4, .on_reference = 8};
  for (const auto& [exchanged, single, a, b] :
       {std::tuple{false, false, 4., 8.}, std::tuple{true, false, 8., 4.}, std::tuple{false, true, 12., 0.}}) {
    ContactState state;
    state.single_surface = single;
    add_energies(work, exchanged, state);
    EXPECT_EQ(state.energy_a, a) << exchanged << single;
    EXPECT_EQ(state.energy_b, b) << exchanged << single;
    EXPECT_EQ(state.friction, 1);
    EXPECT_EQ(state.damping, 2);
  }
}

}  // namespace
}  // namespace gapcheck::solver::contact_link_test
