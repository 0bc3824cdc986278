#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "solver/conditioned.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::boundary_test {
namespace {

TEST(Boundary, HoldsFreedomsOfNodesAndSets) {
  const Conditioned plate_held = good(plate(2, 1, {1, 1, 0}) + elastic_deck(shell_section, 1000, 0.3, 7) +
                                      "*SET_NODE_LIST\n3\n1,2\n*BOUNDARY_SPC_SET_ID\n1,left\n3,0,1,0,1,0,0,1\n"
                                      "*BOUNDARY_SPC_NODE\n2,0,0,1\n");
  const Constraints& constraints = plate_held.structure.constraints;
  EXPECT_EQ(constraints.mask(0), 1 + 4 + 32);
  EXPECT_EQ(constraints.mask(1), 1 + 2 + 4 + 32);
  EXPECT_EQ(constraints.mask(2), 0);
  EXPECT_EQ(plate_held.warnings, "");
}

TEST(Boundary, CodesOfNodes) {
  const Conditioned held = good(
      "*NODE\n1,0.,0.,0.,7,4\n"
      "       2             1.0             0.0             0.0       6       0\n"
      "       3             1.0             1.0             0.0       0       0\n"
      "       4             0.0             1.0             0.0\n"
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n" +
      elastic_deck(shell_section, 1000, 0.3, 7));
  EXPECT_EQ(held.structure.constraints.mask(0), 7 + 8 + 16);
  EXPECT_EQ(held.structure.constraints.mask(1), 1 + 4);
  EXPECT_EQ(held.structure.constraints.mask(2), 0);
  EXPECT_EQ(held.structure.constraints.mask(3), 0);
}

TEST(Boundary, NodesOfRigidBodiesAreNotHeld) {
  const Conditioned held = good(rigid_box + rigid_material + "*BOUNDARY_SPC_NODE\n11,0,1,1,1\n");
  EXPECT_EQ(held.structure.constraints.mask(0), 0);
  EXPECT_NE(held.warnings.find("1 of the nodes belong to rigid bodies"), std::string::npos) << held.warnings;
}

const std::string falls = "*LOAD_BODY_Z\n8,-10.\n*DEFINE_CURVE\n8\n0.,-1.\n";  // 10 along −z

// Free before birth, at rest from then on, free again after death.
TEST(Boundary, BirthAndDeath) {
  Stepper stepper =
      good(point_mass + falls + "*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,0,0,1\n0.5,2.\n").stepper(fixed_step(1.0 / 1024));
  const auto z = [&] { return stepper.state().x[0].z(); };
  const int sign = [&] {
    run(stepper, 511);
    return z() > 0 ? 1 : -1;
  }();
  const double fallen = 10 * 0.5 * 0.5 / 2;
  EXPECT_NEAR(z(), sign * 10 * std::pow(511.0 / 1024, 2) / 2, 1e-9);
  run(stepper, 1);
  const double stop = z();
  EXPECT_NEAR(stop, sign * fallen, 1e-9);
  run(stepper, 1536);
  EXPECT_EQ(z(), stop);
  const double weight = sign * 2 * 10;
  EXPECT_NEAR(stepper.external().force[0].z(), 0, 1e-12);  // held: the reaction balances the weight
  run(stepper, 1024);
  EXPECT_NEAR(z() - stop, sign * 10.0 / 2, 0.011);
  EXPECT_NEAR(stepper.external().force[0].z(), weight, 1e-12);
  EXPECT_NEAR(stepper.energies().total(), stepper.energies().external + stepper.energies().initial, 1e-9);
}

// A mass slides down a plane of 30 degrees: g sin 30 along it, m g cos 30 on it.
TEST(Boundary, InALocalSystem) {
  const double angle = std::numbers::pi / 6;
  const std::string plane =
      fmt::format("*DEFINE_COORDINATE_VECTOR\n5,{:.17g},0.,{:.17g},0.,1.,0.\n", std::cos(angle), -std::sin(angle));
  for (const bool set : {false, true}) {
    Stepper stepper =
        good(point_mass + falls + plane +
             (set ? "*SET_NODE\n3\n1\n*BOUNDARY_SPC_SET\n3,5,0,0,1\n" : "*BOUNDARY_SPC_NODE\n1,5,0,0,1\n"))
            .stepper(fixed_step(1.0 / 1024));
    run(stepper, 1024);
    const Vector down(std::cos(angle), 0, -std::sin(angle)), across(std::sin(angle), 0, std::cos(angle));
    const Vector x = stepper.state().x[0];
    const double way = 10 * std::sin(angle) / 2;
    EXPECT_NEAR((x - x.dot(down) * down).norm(), 0, 1e-14);
    EXPECT_NEAR(std::abs(x.dot(down)), way, 1e-9);
    // What is left of weight and reaction.
    EXPECT_NEAR(stepper.external().force[0].dot(across), 0, 1e-13);
    EXPECT_NEAR(stepper.external().force[0].norm(), 2 * 10 * std::sin(angle), 1e-12);
    EXPECT_NEAR(stepper.energies().total(), stepper.energies().external + stepper.energies().initial, 1e-10);
  }
}

// A plate with supports in axes of its own, and the same plate turned with its supports in global axes.
TEST(Boundary, TurnsWithTheSystem) {
  const Matrix turn = Eigen::AngleAxisd(0.8, Vector(1, -2, 0.5).normalized()).toRotationMatrix();
  const std::array<Vector, 4> corners{Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1.1, 0), Vector(0, 1, 0)};
  std::array<std::vector<Vector>, 2> end;
  for (const bool turned : {false, true}) {
    const Matrix by = turned ? turn : Matrix::Identity();
    std::string deck = "*NODE\n";
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector x = by * corners[i];
      deck += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", i + 1, x.x(), x.y(), x.z());
    }
    const Vector a = by.col(0), b = by.col(1);
    deck += "*ELEMENT_SHELL\n1,1,1,2,3,4\n" + elastic_deck(shell_section, 1000, 0.3, 7);
    deck += fmt::format("*DEFINE_COORDINATE_VECTOR\n5,{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", a.x(), a.y(),
                        a.z(), b.x(), b.y(), b.z());
    deck += "*BOUNDARY_SPC_NODE\n1,5,1,0,1,1,0,1\n2,5,0,1,1,0,1,0\n3,5,0,0,1,1\n*INITIAL_VELOCITY_NODE\n";
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector v = by * Vector(0.3, -0.2 * static_cast<double>(i), 0.1), w = by * Vector(0.2, 0.1, -0.3);
      deck += fmt::format("{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", i + 1, v.x(), v.y(), v.z(), w.x(),
                          w.y(), w.z());
    }
    Stepper stepper = good(deck).stepper(fixed_step(1e-3));
    run(stepper, 200);
    EXPECT_NEAR(stepper.energies().total(), stepper.energies().external + stepper.energies().initial, 1e-9);
    end[turned] = stepper.state().x;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT((turn * end[0][i] - end[1][i]).norm(), 1e-12) << i;
    EXPECT_GT((end[0][i] - corners[i]).norm(), 1e-3) << i;
  }
}

TEST(Boundary, WhatIsNotCalculatedIsAFailure) {
  const auto expect = [](const std::string& cards, Failure::Kind kind, std::string_view text) {
    const Conditioned result = conditioned(point_mass + cards);
    ASSERT_FALSE(result.status.ok()) << cards;
    EXPECT_EQ(result.status.error().kind, kind) << result.status.error().message;
    EXPECT_NE(result.status.error().message.find(text), std::string::npos) << result.status.error().message;
  };
  expect("*BOUNDARY_SPC_NODE\n1,5,1\n", Failure::Kind::not_calculated, "*BOUNDARY_SPC_NODE: ");
  EXPECT_EQ(conditioned(point_mass + "*BOUNDARY_SPC_NODE\n1,5,1\n").status.error().place.line, 6U);
  expect("*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,1\n2.,2.\n", Failure::Kind::contradiction, "before its death");
  const std::string tilted = "*DEFINE_COORDINATE_VECTOR\n5,1.,1.,0.,0.,1.,0.\n6,1.,0.,1.,0.,1.,0.\n";
  expect(tilted + "*BOUNDARY_SPC_NODE\n1,5,1\n1,6,1\n", Failure::Kind::not_calculated, "two systems");
  expect(tilted + "*BOUNDARY_SPC_NODE\n1,5,1\n1,0,0,1\n", Failure::Kind::not_calculated, "two systems");
  expect(tilted + "*BOUNDARY_SPC_NODE\n1,0,1\n1,5,0,1\n", Failure::Kind::not_calculated, "two systems");
  expect(tilted + "*BOUNDARY_SPC_NODE\n1,5,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,2,0,9\n*DEFINE_CURVE\n9\n0.,1.\n",
         Failure::Kind::not_calculated, "two systems");
  expect("*NODE\n2,1.,0.,0.\n3,0.,1.,0.\n*DEFINE_COORDINATE_NODES\n5,1,2,3,1\n*BOUNDARY_SPC_NODE\n1,5,1\n",
         Failure::Kind::not_calculated, "FLAG = 1");
  expect("*DEFINE_COORDINATE_VECTOR\n5,1.,1.,0.,2.,2.,0.\n*BOUNDARY_SPC_NODE\n1,5,1\n", Failure::Kind::not_calculated,
         "do not span");
  expect(
      "*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,1\n1.,3.\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,9,,,,2.\n"
      "*DEFINE_CURVE\n9\n0.,1.\n",
      Failure::Kind::contradiction, "held or moved already");
  expect("*BOUNDARY_SPC_SET\n4,0,1\n", Failure::Kind::unknown_reference, "node set 4");
  expect("*BOUNDARY_SPC_NODE\n4,0,1\n", Failure::Kind::unknown_reference, "node 4");
}

// A wall stops what slides along local axes, and what a support has let go.
TEST(Boundary, BesideRigidWalls) {
  const std::string deck = point_mass + "*LOAD_BODY_Z\n8,10.\n*DEFINE_CURVE\n8\n0.,1.\n" +
                           "*RIGIDWALL_PLANAR\n0\n0.,0.,-1.,0.,0.,1.\n*CONTROL_TERMINATION\n2.\n"
                           "*CONTROL_TIMESTEP\n0.001\n*DEFINE_COORDINATE_VECTOR\n5,1.,0.,-1.,0.,1.,0.\n";
  RunScene local(deck + "*BOUNDARY_SPC_NODE\n1,5,0,1,1\n");  // x falls, at 45 degrees
  ASSERT_TRUE(local.prepared()) << local.message();
  local.go();
  EXPECT_NEAR(local.state().x[0].z(), -1, 1e-12);
  EXPECT_NEAR(local.state().x[0].x(), 1, 1e-12);
  EXPECT_NEAR(local.energies().absorbed.walls, 2 * 10 * 1, 0.2);
  EXPECT_NEAR(local.energies().ratio(), 1, 1e-3);
  RunScene timed(deck + "*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,0,0,1\n0.,1.\n");
  ASSERT_TRUE(timed.prepared()) << timed.message();
  double at_death = 0;
  timed.go([&](const solver::Run& run) {
    if (run.stepper().state().time < 0.99) at_death = run.stepper().state().x[0].z();
  });
  EXPECT_EQ(at_death, 0);
  EXPECT_NEAR(timed.state().x[0].z(), -1, 1e-12);
  EXPECT_NEAR(timed.energies().absorbed.walls, 2 * 10 * 1, 0.2);
}

}  // namespace
}  // namespace gapcheck::solver::boundary_test
