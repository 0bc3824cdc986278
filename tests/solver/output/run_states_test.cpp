#include "solver/output/run_states.hpp"

#include "solver/run_scene.hpp"

namespace gapcheck::solver::run_states_test {
namespace {

// A free mass under a force, a fixed one under the same force, one whose velocity grows by 3 per time: accelerations
// are F/m, 0 and 3; velocities are those half a step later.
TEST(NodeStates, MotionOfHistoryNodes) {
  constexpr double step = 0.01;
  RunSettings settings;
  settings.step.greatest_step = step;
  RunScene scene(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,2.,0.,0.\n*ELEMENT_MASS\n1,1,2.5\n2,2,1.\n3,3,4.\n"
      "*DEFINE_CURVE\n5\n0.,5.\n9.,5.\n*DEFINE_CURVE\n6\n0.,0.\n9.,27.\n*LOAD_NODE_POINT\n1,1,5,1.\n2,1,5,1.\n3,2,5,1."
      "\n"
      "*BOUNDARY_SPC_NODE\n2,0,1,1,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n3,1,0,6\n"
      "*DATABASE_NODOUT\n0.1\n*DATABASE_HISTORY_NODE\n1,2,3\n*CONTROL_TERMINATION\n0.5\n",
      settings);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  int seen = 0;
  scene.go([&](const solver::Run& run) {
    const std::vector<results::NodeState> nodes = node_states(run);
    ASSERT_EQ(nodes.size(), 3u);
    const double time = run.stepper().state().time, later = time + step / 2;
    EXPECT_EQ(nodes[2].node, 3);
    EXPECT_NEAR((nodes[0].acceleration - Vector(2, 0, 0)).norm(), 0, 1e-13);
    EXPECT_NEAR((nodes[0].velocity - later * Vector(2, 0, 0)).norm(), 0, 1e-13);
    EXPECT_NEAR((nodes[0].displacement - time * time * Vector(1, 0, 0)).norm(), 0, 1e-13);
    EXPECT_NEAR(nodes[1].acceleration.norm(), 0, 1e-13);
    EXPECT_EQ(nodes[1].position, Vector(1, 0, 0));
    EXPECT_NEAR((nodes[2].acceleration - Vector(3, 1.25, 0)).norm(), 0, 1e-11) << time;
    EXPECT_NEAR((nodes[2].velocity - later * Vector(3, 1.25, 0)).norm(), 0, 1e-13);
    ++seen;
  });
  EXPECT_EQ(seen, 51);
}

}  // namespace
}  // namespace gapcheck::solver::run_states_test
