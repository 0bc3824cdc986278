#include "solver/condition/wall_penalty.hpp"

#include <cmath>

#include "solver/condition/wall_flight.hpp"

namespace gapcheck::solver::wall_penalty_test {
namespace {

/// A rigid cube of side 0.1 and density 4 whose lower face is at `height`.
std::string rigid_cube(double height, double rwpnal) {
  std::string text = "*NODE\n";
  for (int k = 0; k < 8; ++k)
    text += fmt::format("{},{},{},{}\n", k + 1, 0.1 * ((k + 1) / 2 % 2), 0.1 * (k / 2 % 2), height + 0.1 * (k / 4));
  return text +
         "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*PART\np\n1,1,1\n*SECTION_SOLID\n1,1\n*MAT_RIGID\n1,4.,300000.,0.\n" +
         fmt::format("*CONTROL_CONTACT\n,{}\n", rwpnal);
}

constexpr double mass = 4 * 1e-3, spring = 0.1 * 100000 * 0.1;  // of one node: 0.1 K h, K = E / 3

// RWPNAL 0: the body passes; 1: it bounces as a mass on four springs, v √(m / 4 k) deep, and gives all energy back.
TEST(WallPenalty, RigidCubeBounces) {
  const std::string wall = "*RIGIDWALL_PLANAR\n0\n0,0,0,0,0,1\n";
  WallFlight passes = fly(rigid_cube(0, 0) + wall, {0, 0, -1}, 1e-3);
  run(passes, 50);
  EXPECT_NEAR(passes.stepper.state().bodies[0].velocity.z(), -1, 1e-14);
  EXPECT_EQ(passes.wall().energy, 0);
  WallFlight flight = fly(rigid_cube(0, 1) + wall, {0.3, 0, -1}, 1e-5);
  double deepest = 0, most = 0;
  while (flight.stepper.state().time < 0.01) {
    run(flight, 1);
    deepest = std::max(deepest, -flight.stepper.state().x[0].z());
    most = std::max(most, flight.wall().normal_force);
    EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-10);
  }
  RecordProperty("wall_penalty_force_ratio", fmt::format("{:.6f}", most / std::sqrt(mass * 4 * spring)));
  EXPECT_NEAR(deepest, std::sqrt(mass / 4 / spring), 1e-4 * deepest);
  EXPECT_NEAR(most, std::sqrt(mass * 4 * spring), 1e-4 * most);
  EXPECT_NEAR(flight.stepper.state().bodies[0].velocity.z(), 1, 1e-4);
  EXPECT_NEAR(flight.stepper.state().bodies[0].velocity.x(), 0.3, 1e-12);
  EXPECT_EQ(flight.diagnostics.size(), 0u);
}

// Two scales multiply the stiffness: force over √.
TEST(WallPenalty, Scales) {
  WallFlight flight = fly(rigid_cube(0, 2) + "*RIGIDWALL_PLANAR\n0,0,0,0,0,0,8.\n0,0,0,0,0,1\n", {0, 0, -1}, 1e-5);
  double most = 0;
  for (int i = 0; i < 500; ++i) {
    run(flight, 1);
    most = std::max(most, flight.wall().normal_force);
  }
  EXPECT_NEAR(most, 4 * std::sqrt(mass * 4 * spring), 2e-3 * most);
}

// A cube slides on the wall under its weight: it comes to rest after v²/2 μ g and stays.
TEST(WallPenalty, SlidesToRest) {
  constexpr double speed = 0.2, mu = 0.25, weight = 0.08;  // on each of the 8 nodes 0.01
  WallFlight flight =
      fly(rigid_cube(-weight / 4 / spring, 1) + "*RIGIDWALL_PLANAR\n0\n0,0,0,0,0,1,0.25\n", {speed, 0, 0}, 2e-5);
  flight.stepper.add(std::make_unique<SteadyPush>(Vector(0, 0, -0.01)));
  const double stop = speed / (mu * weight / mass), way = speed * stop / 2;
  const double start = flight.stepper.state().bodies.empty() ? 0.05 : flight.stepper.state().bodies[0].center.x();
  while (flight.stepper.state().time < 2 * stop) run(flight, 1);
  EXPECT_NEAR(flight.stepper.state().bodies[0].center.x() - start, way, 0.02 * way);
  EXPECT_LT(flight.stepper.state().bodies[0].velocity.norm(), 0.05 * speed);  // it swings on the spring that sticks
  EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-6);
}

// RWPNAL below 0: springs stop deformable nodes too; a wall with a mass and a cube exchange momentum, none is lost.
TEST(WallPenalty, AllNodesAndAWallWithAMass) {
  std::string deck = rigid_cube(0, -1);
  const std::string rigid = "*MAT_RIGID\n1,4.,300000.,0.\n";
  deck.replace(deck.find(rigid), rigid.size(), "*MAT_ELASTIC\n1,4.,300000.,0.\n");
  WallFlight soft = fly(deck + "*RIGIDWALL_PLANAR\n0\n0,0,0,0,0,1\n", {0, 0, -1}, 1e-5);
  run(soft, 1000);
  double mean = 0;
  for (const Vector& v : soft.stepper.state().v) mean += v.z() / 8;
  EXPECT_GT(mean, 0.9);
  EXPECT_NEAR(soft.stepper.energies().ratio(), 1, 1e-6);
  WallFlight moving = fly(rigid_cube(0, 1) + "*RIGIDWALL_PLANAR_MOVING\n0\n0,0,0,0,0,1\n0.004,0.\n", {0, 0, -1}, 1e-5);
  run(moving, 1000);
  EXPECT_NEAR(moving.stepper.state().bodies[0].velocity.z(), 0, 1e-3);  // equal masses exchange their velocities
  EXPECT_NEAR(moving.wall().velocity.z(), -1, 1e-3);
  EXPECT_NEAR(moving.stepper.energies().ratio(), 1, 1e-6);
}

}  // namespace
}  // namespace gapcheck::solver::wall_penalty_test
