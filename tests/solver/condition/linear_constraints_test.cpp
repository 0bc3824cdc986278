#include "solver/condition/linear_constraints.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "solver/conditioned.hpp"

namespace gapcheck::solver::linear_constraints_test {
namespace {

/// Masses of 1, 2, … n at x = 1, 2, … n, numbered from 1.
std::string masses(int n) {
  std::string nodes = "*NODE\n", elements = "*ELEMENT_MASS\n";
  for (int i = 1; i <= n; ++i) {
    nodes += fmt::format("{},{}.,0.,0.\n", i, i);
    elements += fmt::format("{},{},{}.\n", i, i, i);
  }
  return nodes + elements;
}

const std::string constant = "*DEFINE_CURVE\n9\n0.,1.\n9.,1.\n";

// Nodes 1 and 2 share x until 0.5: F / (m₁ + m₂) there, F / m after it; y is free.
TEST(LinearConstraints, JoinedNodesShareTheirMomentum) {
  constexpr double dt = 1e-3, force = 6;
  Stepper stepper = good(masses(2) +
                         "*SET_NODE_LIST\n4\n1,2\n*CONSTRAINED_NODE_SET_ID\n77\n4,1,0.4995\n"
                         "*LOAD_NODE_POINT\n1,1,9,6.\n1,2,9,3.\n" +
                         constant)
                        .stepper(fixed_step(dt));
  run(stepper, 500);
  const double together = force / 3 * dt * 499.5;
  EXPECT_NEAR(stepper.state().v[0].x(), together, 1e-12);
  EXPECT_NEAR(stepper.state().v[1].x(), together, 1e-12);
  EXPECT_NEAR(stepper.state().v[0].y(), 3 * dt * 499.5, 1e-12);
  EXPECT_EQ(stepper.state().v[1].y(), 0);
  EXPECT_NEAR(stepper.energies().total() - stepper.energies().initial, stepper.energies().external, 1e-12);
  run(stepper, 100);
  EXPECT_NEAR(stepper.state().v[0].x(), together + force * dt * 100, 1e-12);
  EXPECT_NEAR(stepper.state().v[1].x(), together, 1e-12);
}

// A lever, 2 u₁ = u₂: node 2 moves twice as far, so its mass counts four times at node 1.
TEST(LinearConstraints, Lever) {
  constexpr double dt = 1e-3, force = 5;
  Stepper stepper =
      good(masses(2) + "*CONSTRAINED_LINEAR_GLOBAL\n1\n1,1,2.\n2,1,-1.\n*LOAD_NODE_POINT\n1,1,9,5.\n" + constant)
          .stepper(fixed_step(dt));
  run(stepper, 400);
  const double first = force / (1 + 4 * 2) * dt * 399.5;
  EXPECT_NEAR(stepper.state().v[0].x(), first, 1e-12);
  EXPECT_NEAR(stepper.state().v[1].x(), 2 * first, 1e-12);
  EXPECT_NEAR(stepper.state().x[1].x() - 2, 2 * (stepper.state().x[0].x() - 1), 1e-12);
  const Energies& e = stepper.energies();
  EXPECT_NEAR(e.total() - e.initial, e.external, 1e-12);
  EXPECT_NEAR(e.external, force * (stepper.state().x[0].x() - 1 - dt * first), 1e-9) << "only the load works";
}

// Periodic pairs u₁ − u₂ = u₃ and u₄ − u₅ = u₃, of which 4 moves with 6, and the first of them twice: the accelerations
// are those of all equations of motion with their multipliers at once.
TEST(LinearConstraints, GroupsAreSolvedAtOnce) {
  const std::string deck =
      masses(6) +
      "*CONSTRAINED_LINEAR_GLOBAL\n1\n1,1,1.\n2,1,-1.\n3,1,-1.\n*CONSTRAINED_LINEAR_GLOBAL\n2\n4,1,1."
      "\n5,1,-1.\n3,1,-1.\n*CONSTRAINED_LINEAR_GLOBAL\n3\n1,1,2.\n2,1,-2.\n3,1,-2.\n"
      "*SET_NODE_LIST\n4\n4,6\n*CONSTRAINED_NODE_SET\n4,7\n";
  Conditioned ready = good(deck);
  ASSERT_EQ(ready.forces.size(), 1u);
  State& state = ready.structure.state;
  state.cycle = 1;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  Forces net, external;
  net.resize(6);
  external.resize(6);
  for (std::size_t i = 0; i < 6; ++i) net.force[i].x() = any(random);
  // Rows: m a + cᵀ λ = f, then the three independent equations.
  Eigen::MatrixXd c(3, 6);
  c << 1, -1, -1, 0, 0, 0, 0, 0, -1, 1, -1, 0, 0, 0, 0, 1, 0, -1;
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(9, 9);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(9);
  for (int i = 0; i < 6; ++i) {
    all(i, i) = i + 1;
    right[i] = net.force[static_cast<std::size_t>(i)].x();
  }
  all.topRightCorner(6, 3) = c.transpose();
  all.bottomLeftCorner(3, 6) = c;
  const Eigen::VectorXd wanted = all.fullPivLu().solve(right);
  ready.forces[0]->add(state, external);
  ready.forces[0]->react(state, 0.1, 0.1, net, external);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(net.force[static_cast<std::size_t>(i)].x() / (i + 1), wanted[i], 1e-10) << i;
  EXPECT_NEAR(net.force[3].x() / 4 - net.force[5].x() / 6, 0, 1e-12);
}

// A mass on a stiff arm of length 3 beside a free beam's end: v₂ = 3 ω₁ about z.
TEST(LinearConstraints, Rotations) {
  Conditioned ready = good(
      "*NODE\n1,0.,0.,0.\n2,3.,0.,0.\n*ELEMENT_MASS\n1,1,5.\n2,2,2.\n"
      "*NODE\n3,0.,0.,7.\n*ELEMENT_BEAM\n1,1,1,3\n*PART\np\n1,1,1\n*SECTION_BEAM\n1,2\n"
      "0.02,3e-5,3e-5,7e-5\n*MAT_ELASTIC\n1,2.,1000.,0.25\n"
      "*CONSTRAINED_LINEAR_GLOBAL\n1\n2,2,1.\n1,2,-1.\n1,6,-3.\n*BOUNDARY_SPC_NODE\n3,0,1,1,1,1,1,1\n"
      "*CONSTRAINED_LINEAR_GLOBAL\n2\n1,2,1.\n");
  ASSERT_EQ(ready.forces.size(), 1u);
  State& state = ready.structure.state;
  state.cycle = 1;
  Forces net, external;
  net.resize(3);
  external.resize(3);
  net.moment[0].z() = 7;
  ready.forces[0]->add(state, external);
  ready.forces[0]->react(state, 0.1, 0.1, net, external);
  const double spin = net.moment[0].z() / state.inertia[0];
  EXPECT_NEAR(spin, 7 / (state.inertia[0] + 2 * 9), 1e-12);
  EXPECT_NEAR(net.force[1].y() / 2, 3 * spin, 1e-12);
  EXPECT_NEAR(net.force[0].y(), 0, 1e-12);
}

/// A system turned by 30 degrees about z and tilted, as id 5, and the same axes as columns.
const std::string tilted = "*DEFINE_COORDINATE_VECTOR\n5,3.,1.,0.5,-1.,2.,0.3\n";

Matrix tilted_axes() {
  const Vector x = Vector(3, 1, 0.5).normalized(), z = x.cross(Vector(-1, 2, 0.3)).normalized();
  Matrix axes;
  axes << x, z.cross(x), z;
  return axes;
}

// 2 u₁ = u₂ along a slanted axis: along it the lever's acceleration, across it the masses' own.
TEST(LinearConstraints, LeverAlongALocalAxis) {
  constexpr double dt = 1e-3, force = 5;
  for (int freedom = 1; freedom <= 3; ++freedom) {
    Stepper stepper = good(masses(2) + tilted +
                           fmt::format("*CONSTRAINED_LINEAR_LOCAL\n1\n1,{0},5,2.\n2,{0},5,-1.\n"
                                       "*LOAD_NODE_POINT\n1,1,9,5.\n",
                                       freedom) +
                           constant)
                          .stepper(fixed_step(dt));
    run(stepper, 400);
    const Vector axis = tilted_axes().col(freedom - 1), load = force * Vector::UnitX();
    const double along = load.dot(axis) / (1 + 4 * 2);
    const Vector first = (load - load.dot(axis) * axis + along * axis) * dt * 399.5;
    EXPECT_NEAR((stepper.state().v[0] - first).norm(), 0, 1e-12) << freedom;
    EXPECT_NEAR((stepper.state().v[1] - 2 * along * dt * 399.5 * axis).norm(), 0, 1e-12) << freedom;
    const Energies& e = stepper.energies();
    EXPECT_NEAR(e.total() - e.initial, e.external, 1e-12) << freedom;
  }
}

// CID 0 and a system along the global axes are _GLOBAL, bit by bit; each node may have axes of its own.
TEST(LinearConstraints, LocalAxesPerNode) {
  const auto velocities = [](const std::string& equation) {
    Stepper stepper = good(masses(2) + tilted + "*DEFINE_COORDINATE_VECTOR\n6,0.,1.,0.,-1.,0.,0.\n" +
                           "*DEFINE_COORDINATE_VECTOR\n7,1.,0.,0.,0.,1.,0.\n" + equation +
                           "*LOAD_NODE_POINT\n1,1,9,5.\n1,2,9,2.\n" + constant)
                          .stepper(fixed_step(1e-3));
    run(stepper, 100);
    return std::array{stepper.state().v[0], stepper.state().v[1]};
  };
  const auto global = velocities("*CONSTRAINED_LINEAR_GLOBAL\n1\n1,1,2.\n2,2,-1.\n");
  EXPECT_EQ(velocities("*CONSTRAINED_LINEAR_LOCAL\n1\n1,1,0,2.\n2,2,7,-1.\n"), global);
  EXPECT_EQ(velocities("*CONSTRAINED_LINEAR_LOCAL\n1\n1,1,,2.\n2,1,6,-1.\n"), global);  // x of 6 is y
  EXPECT_GT(global[1].y(), 0.01);
  EXPECT_NE(velocities("*CONSTRAINED_LINEAR_LOCAL\n1\n1,1,5,2.\n2,2,5,-1.\n"), global);
}

// The rotation about a local axis alone is taken.
TEST(LinearConstraints, LocalRotations) {
  Conditioned ready = good(
      "*NODE\n1,0.,0.,0.\n2,3.,0.,0.\n*ELEMENT_MASS\n1,1,5.\n2,2,2.\n"
      "*NODE\n3,0.,0.,7.\n*ELEMENT_BEAM\n1,1,1,3\n*PART\np\n1,1,1\n*SECTION_BEAM\n1,2\n"
      "0.02,3e-5,3e-5,7e-5\n*MAT_ELASTIC\n1,2.,1000.,0.25\n*BOUNDARY_SPC_NODE\n3,0,1,1,1,1,1,1\n" +
      tilted + "*CONSTRAINED_LINEAR_LOCAL\n1\n1,5,5,1.\n");
  State& state = ready.structure.state;
  state.cycle = 1;
  Forces net, external;
  net.resize(3);
  external.resize(3);
  const Vector moment(7, -2, 4), axis = tilted_axes().col(1);
  net.moment[0] = moment;
  ready.forces.at(0)->add(state, external);
  ready.forces.at(0)->react(state, 0.1, 0.1, net, external);
  EXPECT_NEAR((net.moment[0] - (moment - moment.dot(axis) * axis)).norm(), 0, 1e-12);
  EXPECT_NEAR(net.force[0].norm(), 0, 1e-12);
}

TEST(LinearConstraints, InitialVelocities) {
  Stepper stepper = good(masses(3) +
                         "*SET_NODE_LIST\n4\n1,2,3\n*CONSTRAINED_NODE_SET\n4,4\n*INITIAL_VELOCITY_NODE\n"
                         "3,8.,4.,2.\n")
                        .stepper(fixed_step(1e-3));
  run(stepper, 5);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(stepper.state().v[i].x(), 3 * 8 / 6., 1e-14);
    EXPECT_NEAR(stepper.state().v[i].y(), 3 * 4 / 6., 1e-14);
    EXPECT_NEAR(stepper.state().v[i].z(), i == 2 ? 2 : 0, 1e-14);
  }
}

TEST(LinearConstraints, Codes) {
  for (int code = 1; code <= 7; ++code) {
    Conditioned ready = good(masses(2) + fmt::format("*SET_NODE_LIST\n4\n1,2\n*CONSTRAINED_NODE_SET\n4,{}\n", code));
    ready.structure.state.cycle = 1;
    Forces net, external;
    net.resize(2);
    external.resize(2);
    net.force[0] = Vector(3, 3, 3);
    ready.forces.at(0)->add(ready.structure.state, external);
    ready.forces.at(0)->react(ready.structure.state, 0.1, 0.1, net, external);
    const std::string shared = std::array{"", "x", "y", "z", "xy", "yz", "xz", "xyz"}[static_cast<std::size_t>(code)];
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(net.force[0][axis], shared.find("xyz"[axis]) != std::string::npos ? 1 : 3, 1e-14) << code << axis;
    EXPECT_NEAR((net.force[0] + net.force[1] - Vector(3, 3, 3)).norm(), 0, 1e-14);
    EXPECT_NEAR((external.force[0] + external.force[1]).norm(), 0, 1e-14);
  }
}

TEST(LinearConstraints, Refused) {
  const auto refused = [](const std::string& deck, Failure::Kind kind, std::string_view text) {
    const Conditioned bad = conditioned(deck);
    ASSERT_FALSE(bad.status.ok()) << text;
    EXPECT_EQ(bad.status.error().kind, kind) << text;
    EXPECT_NE(bad.status.error().message.find(text), std::string::npos) << bad.status.error().message;
    EXPECT_GT(bad.status.error().place.line, 0u) << text;
  };
  const auto equation = [](const std::string& terms, const std::string& more = "") {
    return masses(3) + more + "*CONSTRAINED_LINEAR_GLOBAL\n1\n" + terms;
  };
  const auto joined = [](const std::string& card, const std::string& more = "") {
    return masses(3) + "*SET_NODE_LIST\n4\n1,2\n*SET_NODE_LIST\n5\n3\n" + more + "*CONSTRAINED_NODE_SET\n" + card;
  };
  refused(equation(""), Failure::Kind::contradiction, "no degrees of freedom");
  refused(equation("1,1,1.\n8,1,1.\n"), Failure::Kind::unknown_reference, "node 8");
  refused(equation("1,7,1.\n2,1,1.\n"), Failure::Kind::not_calculated, "DOF = 7");
  refused(equation("1,0,1.\n2,1,1.\n"), Failure::Kind::not_calculated, "DOF = 0");
  refused(equation("1,1,0.\n2,1,1.\n"), Failure::Kind::contradiction, "COEF");
  refused(equation("1,4,1.\n2,1,1.\n"), Failure::Kind::zero_mass, "rotational inertia");
  refused(equation("1,1,1.\n2,1,1.\n", "*BOUNDARY_SPC_NODE\n2,0,1\n"), Failure::Kind::not_calculated, "held or moved");
  refused(equation("1,1,1.\n2,1,1.\n", "*RIGIDWALL_PLANAR\n0\n0.,0.,-9.,0.,0.,1.\n"), Failure::Kind::not_calculated,
          "rigid walls");
  refused(equation("1,1,1.\n11,1,1.\n", rigid_box + rigid_material), Failure::Kind::not_calculated, "rigid body");
  const auto local = [](const std::string& terms, const std::string& more = "") {
    return masses(3) + more + tilted + "*CONSTRAINED_LINEAR_LOCAL\n1\n" + terms;
  };
  refused(local(""), Failure::Kind::contradiction, "*CONSTRAINED_LINEAR_LOCAL: constraint 1: it has no degrees");
  refused(local("1,1,8,1.\n"), Failure::Kind::not_calculated, "local system 8");
  refused(local("1,1,-5,1.\n"), Failure::Kind::not_calculated, "local system -5");
  refused(local("1,1,4,1.\n", "*DEFINE_COORDINATE_NODES\n4,1,2,3\n"), Failure::Kind::not_calculated,
          "do not span a plane");
  refused(local("1,1,4,1.\n", "*NODE\n7,0.,1.,0.\n*DEFINE_COORDINATE_NODES\n4,1,2,7,1\n"),
          Failure::Kind::not_calculated, "moves with its nodes");
  refused(local("1,7,5,1.\n"), Failure::Kind::not_calculated, "DOF = 7");
  refused(local("1,1,5,0.\n"), Failure::Kind::contradiction, "COEF");
  refused(local("8,1,5,1.\n"), Failure::Kind::unknown_reference, "node 8");
  refused(local("1,4,5,1.\n"), Failure::Kind::zero_mass, "rotational inertia");
  refused(local("1,1,5,1.\n", "*BOUNDARY_SPC_NODE\n1,0,0,1\n"), Failure::Kind::not_calculated, "held or moved");
  refused(joined("6,1\n"), Failure::Kind::unknown_reference, "node set 6");
  refused(joined("5,1\n"), Failure::Kind::contradiction, "has 1 nodes");
  refused(joined("4,8\n"), Failure::Kind::not_calculated, "DOF = 8");
  refused(joined("4,-1\n"), Failure::Kind::not_calculated, "DOF = -1");
  refused(joined("4,1,-2.\n"), Failure::Kind::contradiction, "TF");
  refused(joined("4,1\n4,7\n"), Failure::Kind::not_calculated, "two sets");
  EXPECT_EQ(good(joined("4,1\n4,2\n")).warnings, "");
}

}  // namespace
}  // namespace gapcheck::solver::linear_constraints_test
