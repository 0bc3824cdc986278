#include "solver/output/body_states.hpp"

#include <cmath>

#include "solver/conditioned.hpp"
#include "solver/output/run_states.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::body_states_test {
namespace {

RunSettings small_steps(double step = 1e-3) {
  RunSettings settings;
  settings.step.greatest_step = step;
  return settings;
}

// A box that turns about a principal axis with its centre on a line: everything in rbdout is known, and its nodes in
// nodout have turned by ω t and feel ω² r.
TEST(Bodies, TurningBox) {
  const double omega = 2, speed = 3;
  RunScene scene(rigid_box + rigid_material +
                     "*INITIAL_VELOCITY_RIGID_BODY\n7,3.,0.,0.,0.,0.,2.\n*DATABASE_RBDOUT\n0.1\n*DATABASE_NODOUT\n0.1\n"
                     "*DATABASE_HISTORY_NODE\n12\n*CONTROL_TERMINATION\n0.5\n",
                 small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  BodyTurns bodies(scene.run());
  NodeTurns nodes(scene.run());
  scene.go([&](const solver::Run& run) {
    bodies.advance(run);
    nodes.advance(run);
    const double time = run.stepper().state().time;
    const std::vector<results::BodyMotion> list = bodies.states(run);
    ASSERT_EQ(list.size(), 1u);
    const results::BodyMotion& body = list[0];
    EXPECT_EQ(body.body, 7);
    EXPECT_FALSE(body.nodal);
    EXPECT_NEAR((body.displacement - Vector(speed * time, 0, 0)).norm(), 0, 1e-10);
    EXPECT_NEAR((body.position - Vector(0.5 + speed * time, 1, 1.5)).norm(), 0, 1e-10);
    EXPECT_NEAR((body.velocity - Vector(speed, 0, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((body.rotation - Vector(0, 0, omega * time)).norm(), 0, 1e-10);
    EXPECT_NEAR((body.spin - Vector(0, 0, omega)).norm(), 0, 1e-12);
    EXPECT_NEAR(body.acceleration.norm() + body.spin_rate.norm(), 0, 1e-9);
    // The axis of the least inertia is the longest side.
    EXPECT_NEAR(std::abs(body.axes(2, 0)), 1, 1e-12);
    EXPECT_NEAR(body.axes.determinant(), 1, 1e-12);
    const results::NodeState node = node_states(run, &nodes)[0];
    EXPECT_NEAR(node.rotation.z(), omega * time, 2e-6) << "the step turns by 2 atan(ω dt / 2)";
    const Vector arm = node.position - body.position;
    EXPECT_NEAR((node.acceleration + omega * omega * Vector(arm.x(), arm.y(), 0)).norm(), 0, 1e-9);
  });
}

// A node whose angular velocity grows by 4 per time has turned by 2 t² after whole steps.
TEST(NodeTurns, PrescribedRotation) {
  RunScene scene(
      plate(1, 1, {1, 1, 1}) + elastic_deck(shell_section, 1000, 0.3, 2) +
          "*DEFINE_CURVE\n1\n0.,0.\n1.,4.\n*SET_NODE_LIST\n2\n1,2,3,4\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,5,0,1\n"
          "*BOUNDARY_SPC_SET\n2,0,1,1,1\n*DATABASE_NODOUT\n0.1\n*DATABASE_HISTORY_NODE\n3\n"
          "*CONTROL_TERMINATION\n0.1\n",
      small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  NodeTurns turns(scene.run());
  scene.go([&](const solver::Run& run) {
    turns.advance(run);
    const double time = run.stepper().state().time;
    EXPECT_NEAR((turns.rotation(0) - Vector(2 * time * time, 0, 0)).norm(), 0, 1e-12);
  });
}

// A rod that a wall stops: what the wall has given is the momentum that the rod has lost, and its energy row what it
// took; a wall that nothing meets has no force.
TEST(Walls, StopARod) {
  RunScene scene(brick_bar(4, {0.25, 0.1, 0.1}) + elastic_deck(solid_section, 1000, 0, 2) +
                     "*INITIAL_VELOCITY\n\n-2.,0.,0.\n*RIGIDWALL_PLANAR_ID\n31\n0\n-1e-9,0.,0.,1.,0.,0.\n"
                     "*RIGIDWALL_PLANAR_ID\n32\n0\n50.,0.,0.,49.,0.,0.\n*DATABASE_RWFORC\n0.001\n"
                     "*CONTROL_TERMINATION\n0.05\n",
                 small_steps(1e-4));
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const double mass = 2 * 0.01;
  double impulse = 0, most = 0;
  scene.go([&](const solver::Run& run) {
    const std::vector<results::WallForce> walls = wall_states(run);
    ASSERT_EQ(walls.size(), 2u);
    EXPECT_EQ(walls[0].wall, 31);
    EXPECT_NEAR(walls[0].force.x(), walls[0].normal, 1e-12);
    EXPECT_EQ(walls[1].normal, 0);
    impulse += walls[0].normal * (run.stepper().state().dt + run.stepper().next_step()) / 2;
    most = std::max(most, walls[0].normal);
    EXPECT_NEAR(impulse, scene.momentum().x() + 2 * mass, 1e-12);
  });
  EXPECT_GT(impulse, mass);
  const results::GlobalState global = global_state(scene.run());
  ASSERT_EQ(global.walls.size(), 2u);
  EXPECT_EQ(global.walls[0].number, 1);
  EXPECT_GT(global.walls[0].energy, 0);
  EXPECT_EQ(global.walls[1].energy, 0);
  EXPECT_NEAR(global.walls[0].energy, scene.energies().absorbed.walls, 1e-15);
}

}  // namespace
}  // namespace gapcheck::solver::body_states_test
