#include <cmath>

#include "solver/output/run_states.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::failure_test {
namespace {

RunSettings cycles(std::uint64_t count) {
  RunSettings settings;
  settings.cycles = count;
  return settings;
}

/// Material 003 without hardening.
std::string failing(int id, double young, double yield, double strain) {
  return fmt::format("*MAT_PLASTIC_KINEMATIC\n{},1.,{},0.,{},0.,0.\n0.,0.,{}\n", id, young, yield, strain);
}

TEST(Failure, PointsLoseTheirStressAndKeepNone) {
  Material material = plastic_kinematic(1, 1000, 0.3, 10, 0, 0);
  material.failure_strain = 0.02;
  for (const bool plane : {false, true}) {
    PointState point;
    const Symmetric increment{0.001, 0, 0, 0, 0, 0};
    double largest = 0;
    int steps = 0;
    for (; !point.failed && steps < 1000; ++steps) {
      largest = std::max(largest, point.plastic_strain);
      if (plane)
        update_plane_stress(material, increment, 1, point);
      else
        update_stress(material, increment, 1, point);
    }
    EXPECT_LT(largest, 0.02);
    EXPECT_GE(point.plastic_strain, 0.02);
    EXPECT_EQ(point.stress, Symmetric{});
    const double strain = point.plastic_strain;
    if (plane) {
      EXPECT_EQ(update_plane_stress(material, increment, 1, point), 0);
    } else {
      update_stress(material, increment, 1, point);
    }
    EXPECT_EQ(point.stress, Symmetric{});
    EXPECT_EQ(point.plastic_strain, strain);
  }
}

/// One element of 1 x 1 (x 1) whose nodes at x = 0 are held and those at x = 1 move by 0.4 along x at a constant
/// velocity.
std::string pulled(bool solid, double velocity = 1) {
  const std::string move =
      fmt::format("*DEFINE_CURVE\n1\n0.,{0}\n1.,{0}\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,0,1\n", velocity);
  const std::string end = failing(1, 1000, 10, 0.2) + fmt::format("*CONTROL_TERMINATION\n{}\n", 0.4 / velocity) + move;
  if (solid)
    return brick_bar(1, {1, 1, 1}) + "*PART\np\n1,1,1\n*SECTION_SOLID\n1,1\n" + end +
           "*SET_NODE_LIST\n1\n1,3,5,7\n*SET_NODE_LIST\n2\n2,4,6,8\n*BOUNDARY_SPC_SET\n1,0,1,1,1\n";
  return plate(1, 1, {1, 1, 0}) + "*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n0.1\n" + end +
         "*SET_NODE_LIST\n1\n1,3\n*SET_NODE_LIST\n2\n2,4\n*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n";
}

// Uniaxial, ν = 0 in the elastic range, and so slow that the inertia of the sides does not count: it fails where log
// strain less σ/E has reached the failure strain, and takes no more work from then on.
TEST(Failure, PulledElementFails) {
  for (const bool solid : {false, true}) {
    const double velocity = 0.1;
    RunSettings fine;
    fine.step.greatest_step = 5e-3;
    RunScene scene(pulled(solid, velocity), fine);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double failed_at = 0, internal = 0;
    scene.go([&](const solver::Run& run) {
      if (run.stepper().state().failed.count == 0 || failed_at > 0) return;
      failed_at = run.stepper().state().time;
      internal = run.stepper().energies().internal;
    });
    const State& state = scene.state();
    EXPECT_EQ(state.failed.count, 1u);
    EXPECT_EQ((solid ? state.failed.solids : state.failed.shells).at(0), true);
    EXPECT_NEAR(std::log(1 + velocity * failed_at), 0.2 + 0.01, 1e-3) << solid;
    EXPECT_EQ(scene.energies().internal, internal);
    // σ₀ over the volume: constant in flow, but a shell keeps its thickness while its area grows with exp(ε/2).
    EXPECT_NEAR(internal, solid ? 10 * 0.2 : 0.1 * 20 * (std::exp(0.1) - 1), 0.05 * internal) << solid;
    EXPECT_NEAR(scene.energies().ratio(), 1, 1e-3);
    double mass = 0;
    for (const double m : state.mass) mass += m;
    EXPECT_NEAR(mass, solid ? 1 : 0.1, 1e-12);
    ASSERT_EQ(scene.run().stepper().failures().size(), 1u);
    EXPECT_EQ(scene.run().stepper().failures()[0].time, failed_at);
  }
}

// A bar whose middle is weak is torn apart: momentum stays, energies stay in balance, the halves go on as they were.
TEST(Failure, BarTornApart) {
  std::string deck =
      brick_bar(5, {1, 1, 1}) + "*PART\np\n1,1,1\n*PART\nweak\n2,1,2\n*SECTION_SOLID\n1,1\n" +
      "*MAT_ELASTIC\n1,1.,1000.,0.\n" + failing(2, 1000, 5, 0.05) +
      "*INITIAL_VELOCITY_GENERATION\n1,3,0.,1.,0.5,0.\n*SET_NODE_LIST\n1\n4,5,6,10,11,12,16,17\n18,22,23,24\n"
      "*CONTROL_TERMINATION\n2.\n";
  deck.replace(deck.find("\n3,1,"), 5, "\n3,2,");
  RunSettings constant;
  constant.step.greatest_step = 0.005;
  RunScene scene(deck, constant);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const Vector before = scene.momentum();
  EXPECT_GT(before.norm(), 1);
  scene.go([&](const solver::Run&) { EXPECT_LT((scene.momentum() - before).norm(), 1e-12 * before.norm()); });
  EXPECT_EQ(scene.state().failed.count, 1u);
  EXPECT_TRUE(scene.state().failed.solids.at(2));
  EXPECT_NEAR(scene.energies().ratio(), 1, 1e-9);
  EXPECT_GT(scene.state().x[3].x() - scene.state().x[2].x(), 1.3);
  const results::GlobalState global = global_state(scene.run());
  EXPECT_GT(global.eroded_internal, 0.2);
  EXPECT_LT(global.ratio_without_eroded, global.ratio);
  EXPECT_NEAR(global.total * (1 - global.ratio_without_eroded / global.ratio),
              global.eroded_internal + global.eroded_hourglass, 1e-9);
}

// Bent, the outer layers fail first, the shell only with the last of them.
TEST(Failure, ShellFailsWithItsLastLayer) {
  const std::string deck =
      plate(1, 1, {1, 1, 0}) + "*PART\np\n1,1,1\n*SECTION_SHELL\n1,2,,4\n0.2\n" + failing(1, 1000, 1, 0.02) +
      "*CONTROL_TERMINATION\n1.\n*DEFINE_CURVE\n1\n0.,1.\n1.,1.\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,6,0,1\n"
      "*SET_NODE_LIST\n1\n1,3\n*SET_NODE_LIST\n2\n2,4\n*SET_NODE_LIST\n3\n1,2,3,4\n"
      "*BOUNDARY_PRESCRIBED_MOTION_SET\n1,6,0,1,-1.\n*BOUNDARY_SPC_SET\n3,0,1,1,1,1,0,1\n";
  RunSettings small;
  small.step.greatest_step = 5e-4;
  RunScene scene(deck, small);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double outer = 0, all = 0;
  scene.go([&](const solver::Run& run) {
    const auto points = run.stepper().structure().shells.points(0);
    const double time = run.stepper().state().time;
    if (outer == 0 && points.front().failed) outer = time;
    if (all == 0 && run.stepper().state().failed.count > 0) all = time;
  });
  EXPECT_GT(outer, 0);
  // Gauss points at 0.861 and 0.340 of half the thickness.
  EXPECT_NEAR(all / outer, 0.861136 / 0.339981, 0.05);
}

TEST(Failure, LastStepGoesOnWhenAllHaveFailed) {
  std::string deck = pulled(false);
  RunScene scene(deck, cycles(100000));
  scene.go();
  EXPECT_GE(scene.state().time, 0.4);
  EXPECT_EQ(scene.state().failed.count, 1u);
}

}  // namespace
}  // namespace gapcheck::solver::failure_test
