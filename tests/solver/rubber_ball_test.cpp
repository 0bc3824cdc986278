// A ball of Mooney–Rivlin rubber on a frictionless wall: data/benchmarks/rubber_ball.k.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::rubber_ball_test {
namespace {

std::string ball(const std::string& more = "") {
  std::ifstream file(GAPCHECK_ROOT "/data/benchmarks/rubber_ball.k");
  std::stringstream text;
  text << file.rdbuf();
  std::string deck = text.str();
  deck.replace(deck.find("*PART"), 0, more);
  return deck;
}

// The wall's impulse is the change of momentum, nothing moves the ball sideways, no energy appears, and the ball jumps
// back with less than it came with: what is missing is in its vibrations and in the viscosities.
TEST(RubberBall, Rebounds) {
  RunScene scene(ball());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  EXPECT_EQ(scene.diagnostics().sorted().size(), 0u);
  double mass = 0;
  for (const double m : scene.state().mass) mass += m;
  // The ball that is inscribed by the bricks, less the share that one point per brick leaves out.
  const double full = 1.1e-6 * 4 * std::numbers::pi / 3 * 25 * 25 * 25;
  EXPECT_LT(mass, full);
  EXPECT_GT(mass, 0.95 * full);
  double impulse = 0, viscous = 0, least = 1e9;
  Vector before = scene.momentum();
  const Vector start = before;
  scene.go([&](const solver::Run& run) {
    const Energies& e = run.stepper().energies();
    viscous = e.bulk_viscosity;
    EXPECT_NEAR(e.total(), e.initial, 1e-3 * e.initial);
    for (const Vector& x : run.stepper().state().x) least = std::min(least, x.z());
  });
  impulse = scene.momentum().z() - start.z();
  EXPECT_GT(least, -1e-9);
  EXPECT_GT(viscous, 0);
  EXPECT_LT(scene.energies().printed_internal(), scene.energies().internal);
  EXPECT_NEAR(start.z(), -30 * mass, 1e-9 * mass);
  EXPECT_NEAR(scene.momentum().x(), 0, 1e-6 * std::abs(start.z()));
  EXPECT_NEAR(scene.momentum().y(), 0, 1e-6 * std::abs(start.z()));
  const double rebound = scene.momentum().z() / mass;
  EXPECT_GT(rebound, 0.5 * 30);
  EXPECT_LT(rebound, 30);
  EXPECT_GT(impulse, 1.5 * 30 * mass);
}

// Rubber is refused where it is not calculated, before the first cycle and by name.
TEST(RubberBall, WhatIsNotCalculated) {
  const auto material = [](const std::string& cards) {
    std::string deck = ball();
    const std::size_t from = deck.find("*MAT_MOONEY"), to = deck.find("*RIGIDWALL");
    return RunScene(deck.replace(from, to - from, cards)).message();
  };
  const std::string name = "*MAT_MOONEY-RIVLIN_RUBBER\n";
  EXPECT_NE(material(name + "1,1.1E-6,0.495,0,0\n1.,1.,1.,7\n").find("out of range"), std::string::npos);
  for (const char* constants : {"0.5,5.5E-4,1.4E-4", "-1.,5.5E-4,1.4E-4", "0.495,0,0", "0.495,-5.5E-4,1.4E-4"})
    EXPECT_NE(material(name + "1,1.1E-6," + constants + "\n\n").find("out of range"), std::string::npos) << constants;
  EXPECT_EQ(material(name + "1,1.1E-6,0.495,5.5E-4,1.4E-4\n\n"), "");
}

}  // namespace
}  // namespace gapcheck::solver::rubber_ball_test
