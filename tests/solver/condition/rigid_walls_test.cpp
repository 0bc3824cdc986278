#include "solver/condition/rigid_walls.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "base/parallel.hpp"
#include "solver/condition/wall_flight.hpp"

namespace gapcheck::solver::rigid_walls_test {
namespace {

// A mass thrown at a plane: it comes to lie on it, gives m v and ½ m v² to it, and stays there.
TEST(RigidWalls, PlasticStop) {
  WallFlight flight = fly(mass_at("0.,0.,0.0123") + "*RIGIDWALL_PLANAR\n1\n0,0,0,0,0,1\n", {0.5, 0, -3}, 1e-3);
  double impulse = 0;
  for (int i = 0; i < 20; ++i) {
    run(flight, 1);
    impulse += flight.wall().force.z() * 1e-3;
    EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-14);
    EXPECT_EQ(flight.wall().normal_force, flight.wall().force.z());
  }
  EXPECT_NEAR(impulse, 2 * 3, 1e-12);
  EXPECT_NEAR(flight.wall().energy, 0.5 * 2 * 9, 1e-12);
  EXPECT_NEAR(flight.stepper.energies().absorbed.walls, 9, 1e-12);
  EXPECT_NEAR(flight.stepper.energies().external, 0, 1e-12);
  EXPECT_NEAR(flight.stepper.state().x[0].z(), 0, 1e-15);
  EXPECT_NEAR(flight.stepper.state().x[0].x(), 0.01, 1e-14);  // nothing along the wall
  EXPECT_NEAR(flight.stepper.state().v[0].z(), 0, 1e-14);
}

// A plane in any direction; a mass that goes away is not held.
TEST(RigidWalls, PlaneInAnyDirection) {
  const std::string wall = "*RIGIDWALL_PLANAR\n1\n1,2,3,2,4,5\n";
  const Vector normal = Vector(1, 2, 2) / 3;
  const Vector along = normal.unitOrthogonal();
  WallFlight flight = fly(mass_at("1.01,2.02,3.02") + wall, along - 4 * normal, 1e-3);
  run(flight, 50);
  EXPECT_NEAR((flight.stepper.state().v[0] - along).norm(), 0, 1e-12);
  EXPECT_NEAR((flight.stepper.state().x[0] - Vector(1, 2, 3)).dot(normal), 0, 1e-14);
  EXPECT_EQ(flight.wall().touching, 0u);
  WallFlight away = fly(mass_at("1.,2.,3.") + wall, 4 * normal, 1e-3);
  run(away, 50);
  EXPECT_NEAR((away.stepper.state().v[0] - 4 * normal).norm(), 0, 1e-14);
  EXPECT_EQ(away.wall().energy, 0);
}

// A weight lies on the wall: its weight is the wall's force, no work. With friction it comes to rest after v / (μ g).
TEST(RigidWalls, WeightAndFriction) {
  constexpr double weight = 6, mass = 2, mu = 0.25, speed = 0.3, step = 1e-3;
  WallFlight flight = fly(mass_at("0.,0.,0.") + "*RIGIDWALL_PLANAR\n1\n0,0,0,0,0,1,0.25\n", {speed, 0, 0}, step);
  flight.stepper.add(std::make_unique<SteadyPush>(Vector(0, 0, -weight)));
  // The load was added behind the walls: reactions come after all loads.
  const double slowing = mu * weight / mass;
  for (int i = 0; i < 100; ++i) {
    run(flight, 1);
    const double mean_steps = 0.5 + i;  // the first step counts half
    EXPECT_NEAR(flight.stepper.state().v[0].x(), speed - slowing * step * mean_steps, 1e-12);
    EXPECT_NEAR(flight.wall().force.z(), weight, 1e-9);
    EXPECT_NEAR(flight.wall().force.x(), -mu * weight, 1e-9);
    EXPECT_EQ(flight.wall().touching, 1u);
  }
  run(flight, 400);
  EXPECT_NEAR(flight.stepper.state().v[0].norm(), 0, 1e-12);
  EXPECT_NEAR(flight.stepper.state().x[0].x(), speed * speed / 2 / slowing, 1e-3 * speed);
  EXPECT_NEAR(flight.wall().energy, 0.5 * mass * speed * speed, 1e-6);  // ½ m v² of the first half step's slowing
  EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-10);
}

// Coulomb on the stopping impulse: v − μ · impulse / m. FRIC 1: no sliding at all.
TEST(RigidWalls, FrictionOnTheImpulse) {
  WallFlight flight = fly(mass_at("0.,0.,0.01") + "*RIGIDWALL_PLANAR\n1\n0,0,0,0,0,1,0.2\n", {5, 0, -3}, 1e-3);
  run(flight, 10);
  EXPECT_NEAR(flight.stepper.state().v[0].x(), 5 - 0.2 * 3, 1e-12);
  EXPECT_NEAR(flight.wall().energy, 0.5 * 2 * (9 + 25 - 4.4 * 4.4), 1e-11);
  WallFlight rough = fly(mass_at("0.,0.,0.01") + "*RIGIDWALL_PLANAR\n1\n0,0,0,0,0,1,1.\n", {5, 0, -3}, 1e-3);
  run(rough, 10);
  EXPECT_NEAR(rough.stepper.state().v[0].norm(), 0, 1e-12);
  EXPECT_NEAR(rough.wall().energy, 0.5 * 2 * (9 + 25), 1e-11);
}

// Who starts behind the wall is not thrown out, but goes no deeper.
TEST(RigidWalls, StartBehind) {
  const std::string deck = mass_at("0.,0.,-0.5") + "*RIGIDWALL_PLANAR\n1\n0,0,0,0,0,1\n";
  WallFlight flight = fly(deck, {1, 0, -3}, 1e-3);
  run(flight, 20);
  EXPECT_NEAR(flight.stepper.state().x[0].z(), -0.5, 1e-14);
  EXPECT_NEAR(flight.stepper.state().v[0].x(), 1, 1e-14);
  WallFlight out = fly(deck, {0, 0, 3}, 1e-3);
  run(out, 20);
  EXPECT_NEAR(out.stepper.state().v[0].z(), 3, 1e-14);
}

// Past a rectangle, and between birth and death only.
TEST(RigidWalls, RectangleAndTimes) {
  const std::string finite = "*RIGIDWALL_PLANAR_FINITE\n1\n0,0,0,0,0,1\n1,0,0,2,3\n";
  WallFlight inside = fly(mass_at("1.,1.,0.") + finite, {0, 0, -3}, 1e-3);
  run(inside, 5);
  EXPECT_EQ(inside.stepper.state().x[0].z(), 0);
  WallFlight past = fly(mass_at("1.,3.1,0.") + finite, {0, 0, -3}, 1e-3);
  run(past, 5);
  EXPECT_LT(past.stepper.state().x[0].z(), -0.014);
  const std::string timed = "*RIGIDWALL_PLANAR\n1,0,0,0.,0.0105,0.0205\n0,0,0,0,0,1\n";
  WallFlight flight = fly(mass_at("0.,0.,0.") + timed, {0, 0, -3}, 1e-3);
  flight.stepper.add(std::make_unique<SteadyPush>(Vector(0, 0, -1)));
  run(flight, 10);
  EXPECT_EQ(flight.wall().touching, 0u);
  run(flight, 10);
  EXPECT_EQ(flight.wall().touching, 1u);
  const double depth = flight.stepper.state().x[0].z();
  EXPECT_NEAR(depth, -0.033, 2e-4);
  run(flight, 10);
  EXPECT_EQ(flight.wall().touching, 0u);
  EXPECT_LT(flight.stepper.state().x[0].z(), depth);
  EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-12);
}

// A mass that meets a cylinder off its middle goes on along it.
TEST(RigidWalls, CylinderKeepsWhatIsAlong) {
  constexpr double step = 1e-5;
  WallFlight flight =
      fly(mass_at("-0.6,0.,0.") + "*RIGIDWALL_GEOMETRIC_CYLINDER\n1\n0,0,-1,0,0,1\n0.5\n", {2, 0, 0.3}, step);
  // Hits at (-0.5, 0): head on, only the motion along the axis is left.
  run(flight, 6000);
  EXPECT_NEAR(flight.stepper.state().v[0].x(), 0, 1e-12);
  EXPECT_NEAR(flight.stepper.state().v[0].z(), 0.3, 1e-12);
  EXPECT_NEAR(flight.stepper.state().x[0].x(), -0.5, 1e-12);
  EXPECT_NEAR(flight.wall().energy, 0.5 * 2 * 4, 1e-9);
  // At 60 degrees from the flight direction the part along the tangent stays: v sin 60.
  const double y = 0.5 * std::sin(std::numbers::pi / 3);
  WallFlight off =
      fly(mass_at(fmt::format("-0.6,{:.15g},0.", y)) + "*RIGIDWALL_GEOMETRIC_CYLINDER\n1\n0,0,-1,0,0,1\n0.5\n",
          {2, 0, 0}, step);
  for (int i = 0; i < 100000 && off.wall().energy == 0; ++i) run(off, 1);
  run(off, 3);
  EXPECT_NEAR(off.stepper.state().v[0].norm(), 2 * std::sin(std::numbers::pi / 3), 1e-3);
  EXPECT_NEAR(off.wall().energy, 4 * 0.25, 1e-2);
  EXPECT_NEAR(off.stepper.energies().ratio(), 1, 1e-10);
}

TEST(RigidWalls, SphereFromInside) {
  WallFlight flight =
      fly(mass_at("0.,0.,0.99") + "*RIGIDWALL_GEOMETRIC_SPHERE_INTERIOR\n1\n0,0,0\n1.\n", {0, 0, 3}, 1e-3);
  run(flight, 20);
  EXPECT_NEAR(flight.stepper.state().x[0].z(), 1, 1e-14);
  EXPECT_NEAR(flight.wall().energy, 9, 1e-12);
}

// Held against the wall's normal the wall has nothing to do; held across it, it stops what is free.
TEST(RigidWalls, ConstrainedNodes) {
  WallFlight flight = fly(mass_at("0.,0.,0.01") + "*RIGIDWALL_PLANAR\n1\n0,0,0,0,1,1\n", {0, 0, -3}, 1e-3, 3);
  run(flight, 20);
  EXPECT_NEAR(flight.stepper.state().x[0].z(), 0, 1e-14);
  EXPECT_EQ(flight.stepper.state().x[0].y(), 0);
  EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-12);
}

// An elastic bar runs into a wall: σ = ρ c v behind the front, so the wall's force is ρ c v A.
TEST(RigidWalls, RodAgainstTheWall) {
  constexpr double young = 400, density = 4, speed = 0.01, wave = 10, area = 0.01;
  constexpr int n = 100;
  WallFlight flight = fly(brick_bar(n, {0.1, 0.1, 0.1}) + elastic_deck(solid_section, young, 0, density) +
                              "*RIGIDWALL_PLANAR\n0\n0,0,0,1,0,0\n",
                          {-speed, 0, 0}, 1e-3);
  double impulse = 0, last = 0;
  while (flight.stepper.state().time < 1) {  // half of the way to the free end and back
    run(flight, 1);
    impulse += flight.wall().normal_force * (flight.stepper.state().time - last);
    last = flight.stepper.state().time;
  }
  EXPECT_NEAR(impulse / (density * wave * speed * area * 1), 1, 0.02);
  EXPECT_NEAR(flight.wall().normal_force / (density * wave * speed * area), 1, 0.05);
  EXPECT_EQ(flight.wall().touching, 4u);
  EXPECT_NEAR(flight.stepper.energies().ratio(), 1, 1e-9);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(flight.stepper.state().x[i * (n + 1)].x(), 0, 1e-12);
  EXPECT_GT(flight.wall().energy, 0);
}

TEST(RigidWalls, WhatIsNotCalculatedIsNamed) {
  const WallFlight flight = fly(mass_at("0.,0.,0.") +
                                    "*RIGIDWALL_PLANAR\n1\n0,0,0,0,0,1,-2.5\n"
                                    "*RIGIDWALL_GEOMETRIC_SPHERE\n1\n0,0,0,0,0,1,3.\n1.\n"
                                    "*RIGIDWALL_PLANAR\n1\n0,0,0,0,0,1\n",
                                {0, 0, 0}, 1);
  EXPECT_EQ(flight.walls->states().size(), 1u);
  EXPECT_EQ(flight.wall().wall, 2u);
  ASSERT_EQ(flight.diagnostics.size(), 2u);
  EXPECT_EQ(flight.diagnostics[0].file, "a.k");
  EXPECT_GT(flight.diagnostics[0].line, 0u);
  EXPECT_EQ(flight.diagnostics[0].message,
            "*RIGIDWALL_PLANAR, wall 1: FRIC below 0 is not calculated; the wall takes no part in the calculation");
}

// Each contradiction ends the run before its first cycle, with the line of the wall.
TEST(RigidWalls, ContradictionsEndTheRun) {
  const auto said = [](const std::string& wall) {
    const SolverStatus status = check_walls(model::read_text(mass_at("0.,0.,0.") + wall).model);
    if (status.ok()) return std::string();
    EXPECT_GT(status.error().place.line, 0u);
    return status.error().message;
  };
  EXPECT_EQ(said("*RIGIDWALL_PLANAR\n1\n0,0,0,0,0,1\n"), "");
  const std::string curve = "*DEFINE_CURVE\n3\n0.,1.\n1.,1.\n*DEFINE_CURVE\n4\n1.,1.\n0.,1.\n";
  EXPECT_EQ(said("*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n1\n0,0,0,0,0,1\n1,0,0\n3,0,0.,0.,1.\n" + curve), "");
  for (const auto& [wall, expected] : std::initializer_list<std::pair<std::string, std::string>>{
           {"*RIGIDWALL_PLANAR\n9\n0,0,0,0,0,1\n", "node set 9"},
           {"*RIGIDWALL_PLANAR\n0,9\n0,0,0,0,0,1\n", "node set 9"},
           {"*RIGIDWALL_PLANAR\n0,0,9\n0,0,0,0,0,1\n", "box 9"},
           {"*RIGIDWALL_PLANAR_MOVING\n0\n0,0,0,0,0,1\n0.,3.\n", "MASS"},
           {"*RIGIDWALL_PLANAR_MOVING\n0\n0,0,0,0,0,1\n-1.,3.\n", "MASS"},
           {"*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n1\n0,0,0,0,0,1\n1,0,0\n9,0,0.,0.,1.\n", "curve 9"},
           {"*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n1\n0,0,0,0,0,1\n1,0,0\n4,0,0.,0.,1.\n" + curve, "do not rise"},
           {"*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n1\n0,0,0,0,0,1\n1,0,0\n3,0\n" + curve, "no direction"},
           {"*RIGIDWALL_PLANAR_ORTHO\n0\n0,0,0,0,0,1\n0.1,0.1\n0,0,0.,0.,2.\n", "D1 to D3"},
           {"*RIGIDWALL_PLANAR_ORTHO\n0\n0,0,0,0,0,1\n-0.1,0.1\n0,0,1.\n", "coefficient"},
           {"*RIGIDWALL_PLANAR_ORTHO\n0\n0,0,0,0,0,1\n0.1,0.1\n1,7\n", "node 7"},
           {"*RIGIDWALL_PLANAR_FORCES\n0\n0,0,0,0,0,1\n-2\n", "SOFT -2"}})
    EXPECT_NE(said(wall).find(expected), std::string::npos) << wall << said(wall);
}

// Numbers without sense must not bring it down.
TEST(RigidWalls, HostileNumbers) {
  WallFlight flight =
      fly(mass_at("1e29,-1e29,0.") + "*RIGIDWALL_PLANAR\n1\n1e29,1e29,1e29,0,0,1\n", {1e200, 1e300, 1e300}, 1);
  SolverStatus status;
  for (int i = 0; i < 5 && status.ok(); ++i) status = flight.stepper.step();
  if (status.ok())
    EXPECT_TRUE(flight.stepper.state().x[0].allFinite() && flight.stepper.state().v[0].allFinite());
  else
    EXPECT_FALSE(status.error().message.empty());
}

TEST(RigidWalls, SameBitsForAnyNumberOfThreads) {
  std::array<State, 2> result;
  std::array<double, 2> energy{};
  for (std::size_t run_number = 0; run_number < 2; ++run_number) {
    const JobLimit jobs(run_number == 0 ? 1 : 4);
    WallFlight flight = fly(plate(60, 60, {0.1, 0.1, 0}) + elastic_deck(shell_section, 1000, 0.3, 1) +
                                "*RIGIDWALL_PLANAR\n0\n0,0,-0.001,0.1,0.05,1,0.3\n",
                            {0, 0, -1}, 1e-3);
    run(flight, 20);
    result[run_number] = flight.stepper.state();
    energy[run_number] = flight.wall().energy;
    EXPECT_GT(energy[run_number], 0);
  }
  EXPECT_EQ(result[0].x, result[1].x);
  EXPECT_EQ(energy[0], energy[1]);
}

}  // namespace
}  // namespace gapcheck::solver::rigid_walls_test
