#include "solver/output/boundary_work.hpp"

#include "solver/conditioned.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::boundary_work_test {
namespace {

const std::string end = "*CONTROL_TERMINATION\n0.05\n*DATABASE_BNDOUT\n0.01\n*DATABASE_SPCFORC\n0.01\n";

RunSettings small_steps() {
  RunSettings settings;
  settings.step.greatest_step = 1e-4;
  return settings;
}

// A bar held at one end and pulled at the other: what the supports and the loads do to it is the rate of its momentum,
// at every step; and in the other directions nothing.
TEST(Supports, BalanceLoadsAndInertia) {
  RunScene scene(brick_bar(4, {0.2, 0.5, 0.25}) + elastic_deck(solid_section, 1000, 0.3, 2) +
                     "*SET_NODE_LIST\n3\n5,10,15,20\n*SET_NODE_LIST\n4\n1,6,11,16\n*DEFINE_CURVE\n1\n0.,1.\n1.,9.\n"
                     "*LOAD_NODE_SET\n3,1,1,1.\n3,3,1,0.5\n*BOUNDARY_SPC_SET\n4,0,1,1,1\n" +
                     end,
                 small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const HeldFreedoms held(scene.run());
  ASSERT_EQ(held.nodes.size(), 4u);
  Vector before = Vector::Zero();
  double worst = 0, most = 0;
  scene.go([&](const solver::Run& run) {
    const State& state = run.stepper().state();
    const results::SupportStates supports = support_states(run, held);
    const double load = 4 * (1 + 8 * state.time);
    Vector now = Vector::Zero();
    for (std::size_t i = 0; i < state.x.size(); ++i) now += state.mass[i] * state.v[i];
    const Vector rate = (now - before) / ((state.dt + run.stepper().next_step()) / 2);
    worst = std::max(worst, (supports.resultant + load * Vector(1, 0, 0.5) - rate).norm());
    most = std::max(most, supports.resultant.norm());
    before = now;
    ASSERT_EQ(supports.supports.size(), 4u);
    EXPECT_FALSE(supports.supports[0].rotation);
  });
  EXPECT_GT(most, 4);
  EXPECT_LT(worst, 1e-10 * most);
}

// One node held in x by a support, moved in y by a curve and pushed in all directions: each row has its own part. In a
// local system the support's row is in its axes.
TEST(Supports, PartsOfOneNode) {
  RunScene scene(
      "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n*ELEMENT_MASS\n1,1,2.\n2,2,2.\n*DEFINE_CURVE\n1\n0.,0.\n1.,3.\n*DEFINE_"
      "CURVE\n2\n0.,5."
      "\n1.,5.\n*BOUNDARY_SPC_NODE\n1,0,1\n2,9,1,1,1\n*DEFINE_COORDINATE_VECTOR\n9,0.,1.,0.,-1.,0.,0.\n"
      "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,2,0,1\n*LOAD_NODE_POINT\n1,1,2,1.\n1,2,2,1.\n1,3,2,1.\n2,1,2,1.\n" +
          end,
      small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const HeldFreedoms held(scene.run());
  BoundaryWork work(scene.run(), held);
  scene.go([&](const solver::Run& run) {
    work.advance(run);
    const results::SupportStates supports = support_states(run, held);
    ASSERT_EQ(supports.supports.size(), 2u);
    EXPECT_NEAR((supports.supports[0].force - Vector(-5, 0, 0)).norm(), 0, 1e-10);
    // Local x is the global y, local y the negative global x.
    EXPECT_NEAR((supports.supports[1].force - Vector(0, 5, 0)).norm(), 0, 1e-10);
    EXPECT_NEAR((supports.resultant - Vector(-10, 0, 0)).norm(), 0, 1e-10);
  });
  const std::vector<results::BoundaryState> states = work.states();
  ASSERT_EQ(states.size(), 3u);
  const double time = scene.state().time;
  EXPECT_EQ(states[0].kind, results::BoundaryKind::discrete);
  EXPECT_NEAR((states[0].force - Vector(5, 5, 5)).norm(), 0, 1e-12);
  // The velocity is 3 t along y: the mass needs 6, of which the load gives 5. Along z the load alone moves it.
  EXPECT_EQ(states[2].kind, results::BoundaryKind::velocity);
  EXPECT_EQ(states[2].id, 1);
  EXPECT_NEAR((states[2].force - Vector(0, 1, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR(states[2].energy, 1.5 * time * time, 1e-9);
  EXPECT_NEAR(states[0].energy, 5 * 1.5 * time * time + 5 * 2.5 / 2 * time * time, 1e-9);
}

// A rigid body on a given path: the reaction of its motion is m a, and together with the work of a load on it its
// energy; the pressure on a free plate does p A per length.
TEST(BoundaryWork, BodiesAndPressures) {
  RunScene scene(
      rigid_box +
          "*MAT_RIGID\n7,2.,1000.,0.3\n1,5,7\n*DEFINE_CURVE\n1\n0.,0.\n1.,3.\n*DEFINE_CURVE\n2\n0.,5.\n1.,5.\n" +
          "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n7,1,0,1\n*LOAD_RIGID_BODY\n7,1,2,1.\n" +
          "*NODE\n1,10.,0.,0.\n2,11.,0.,0.\n3,11.,1.,0.\n4,10.,1.,0.\n*ELEMENT_SHELL\n1,1,1,2,3,4\n" +
          elastic_deck(shell_section, 1000, 0.3, 2) + "*LOAD_SEGMENT\n2,1.,0.,1,2,3,4\n" + end,
      small_steps());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  BoundaryWork work(scene.run(), HeldFreedoms(scene.run()));
  scene.go([&](const solver::Run& run) { work.advance(run); });
  const std::vector<results::BoundaryState> states = work.states();
  ASSERT_EQ(states.size(), 6u);
  const double time = scene.state().time, mass = 12;
  EXPECT_TRUE(states[0].body);
  EXPECT_EQ(states[0].id, 7);
  EXPECT_NEAR(states[0].energy, 5 * 1.5 * time * time, 1e-9);
  Vector pressure = Vector::Zero();
  double pressed = 0;
  for (std::size_t i = 1; i < 5; ++i) {
    pressure += states[i].force;
    pressed += states[i].energy;
  }
  EXPECT_NEAR((pressure - Vector(0, 0, -5)).norm(), 0, 1e-12);
  // A mass of 0.2 with a = 25.
  EXPECT_NEAR(pressed, 5 * 25.0 / 2 * time * time, 1e-8);
  EXPECT_TRUE(states[5].body);
  EXPECT_NEAR((states[5].force - Vector(3 * mass - 5, 0, 0)).norm(), 0, 1e-9);
  EXPECT_NEAR(states[5].energy + states[0].energy, mass / 2 * 9 * time * time, 1e-7);
}

}  // namespace
}  // namespace gapcheck::solver::boundary_work_test
