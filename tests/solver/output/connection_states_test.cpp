#include "solver/output/connection_states.hpp"

#include <cmath>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::connection_states_test {
namespace {

RunSettings small_steps() {
  RunSettings settings;
  settings.step.greatest_step = 1e-4;
  return settings;
}

// Two masses m1, m2 that fly apart along (3, 4, 0) / 5: u = v / ω sin ωt with ω² = k (1/m1 + 1/m2), and the spring
// pulls its first node towards the second one. A damper takes c du/dt. The third has PF = 1.
TEST(SpringStates, ForceIsThatOnTheFirstNode) {
  constexpr double stiffness = 50, speed = 2;
  RunScene scene(
      "*NODE\n1,0.,0.,0.\n2,0.6,0.8,0.\n3,0.,9.,0.\n4,1.,9.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,3.\n3,3,1.\n4,4,1.\n"
      "*ELEMENT_DISCRETE\n11,1,1,2\n12,2,3,4\n13,1,1,2,0,1e-9,1\n*PART\nspring\n1,1,1\n*PART\ndamper\n2,1,2\n"
      "*SECTION_DISCRETE\n1,0\n\n*MAT_SPRING_ELASTIC\n1,50.\n*MAT_DAMPER_VISCOUS\n2,0.5\n"
      "*INITIAL_VELOCITY_NODE\n2,1.2,1.6,0.\n4,-1.,0.,0.\n*CONTROL_TERMINATION\n0.3\n",
      small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const double omega = std::sqrt(stiffness * (1 / 2.0 + 1 / 3.0));
  double most = 0;
  scene.go([&](const solver::Run& run) {
    const std::vector<results::SpringForce> springs = spring_states(run);
    ASSERT_EQ(springs.size(), 2u);
    const double u = speed / omega * std::sin(omega * run.stepper().state().time);
    EXPECT_EQ(springs[0].spring, 11);
    EXPECT_FALSE(springs[0].torsional);
    EXPECT_NEAR(springs[0].change, u, 1e-5);
    EXPECT_NEAR(springs[0].resultant, stiffness * u, 1e-5 * stiffness);
    EXPECT_NEAR((springs[0].force - springs[0].resultant * Vector(0.6, 0.8, 0)).norm(), 0, 1e-12);
    // Pressed together: the damper pushes its first node away from the second one.
    EXPECT_EQ(springs[1].spring, 12);
    EXPECT_LT(springs[1].resultant, 0);
    EXPECT_NEAR(springs[1].force.x(), springs[1].resultant, 1e-12);
    EXPECT_NEAR(springs[1].resultant, -0.5 * std::exp(-run.stepper().state().time), 1e-3);
    most = std::max(most, springs[0].resultant);
  });
  EXPECT_NEAR(most, stiffness * speed / omega, 0.01);
}

// A body of mass 3 on a hinge along x, at rest: its weight, with its centre 2/3 along the hinge. On the second body.
TEST(JointStates, WeightOnAHinge) {
  RunScene scene(
      "*NODE\n10,0.,0.,0.\n11,1.,0.,0.\n12,0.,1.,0.\n13,0.,0.,1.\n20,0.,0.,0.\n21,1.,0.,0.\n22,1.,0.,0.5\n23,1.,0.,-0."
      "5\n"
      "*ELEMENT_MASS\n10,10,1.\n11,11,1.\n12,12,1.\n13,13,1.\n20,20,1.\n22,22,1.\n23,23,1.\n"
      "*SET_NODE_LIST\n1\n10,11,12,13\n*SET_NODE_LIST\n2\n20,21,22,23\n"
      "*CONSTRAINED_NODAL_RIGID_BODY_SPC\n1,0,1\n1.,7,7\n*CONSTRAINED_NODAL_RIGID_BODY\n2,0,2\n"
      "*CONSTRAINED_JOINT_REVOLUTE_ID\n31,hinge\n10,20,11,21\n*LOAD_BODY_Z\n8,10.\n*DEFINE_CURVE\n8\n0.,1.\n1.,1.\n"
      "*CONTROL_TERMINATION\n0.01\n",
      small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  std::size_t seen = 0;
  scene.go([&](const solver::Run& run) {
    const std::vector<results::JointForce> joints = joint_states(run);
    ASSERT_EQ(joints.size(), 1u);
    EXPECT_EQ(joints[0].joint, 31);
    EXPECT_FALSE(joints[0].local);
    // Gravity pulls down the z axis: the hinge holds the body up, and against turning about y.
    EXPECT_NEAR((joints[0].force - Vector(0, 0, 30)).norm(), 0, 1e-8) << run.stepper().state().time;
    EXPECT_NEAR((joints[0].moment - Vector(0, -20, 0)).norm(), 0, 1e-8);
    ++seen;
  });
  EXPECT_GT(seen, 50u);
}

}  // namespace
}  // namespace gapcheck::solver::connection_states_test
