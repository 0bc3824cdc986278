// A block slides over a slab whose sides are flush with its own: its nodes lie in the planes of the slab's side faces.
#include <gtest/gtest.h>

#include <algorithm>

#include "solver/mortar/mortar_scene.hpp"

namespace gapcheck::solver::flush_slide_test {
namespace {

std::string set_of_levels(int id, const MortarBlock& block, int first, int last) {
  std::string text = fmt::format("*SET_NODE_LIST\n{}\n", id);
  for (int k = first; k <= last; ++k) text += block.level(k);
  return text;
}

/// Pressed 0.05 into the slab until the time 20, then moved along it without friction.
std::string sliding_block() {
  const MortarBlock slab{1, {24, 1, 4}, {0, 0, -0.5}, {3, 0.125, 0.5}, 0, 1};
  const MortarBlock block{2, {5, 1, 4}, {0.31, 0, 1e-4}, {0.75, 0.125, 0.5}, 0, 2};
  return slab.mesh() + block.mesh() + "*MAT_ELASTIC\n1,1.,1.,0.3\n*MAT_ELASTIC\n2,10.,10.,0.3\n" +
         set_of_levels(1, slab, 0, 0) + set_of_levels(2, slab, 1, 4) + set_of_levels(3, block, 0, 4) +
         set_of_levels(4, block, 4, 4) +
         "*BOUNDARY_SPC_SET\n1,0,1,1,1\n2,0,0,1,0\n3,0,0,1,0\n"
         "*BOUNDARY_PRESCRIBED_MOTION_SET\n4,3,2,1\n4,1,2,2\n"
         "*DEFINE_CURVE\n1\n0.,0.\n20.,-0.05\n200.,-0.05\n*DEFINE_CURVE\n2\n0.,0.\n20.,0.\n40.,0.2\n80.,0.6\n200.,1.8\n"
         "*DAMPING_GLOBAL\n0,1.\n*CONTROL_TERMINATION\n80.\n*CONTROL_TIMESTEP\n0.,0.6\n"
         "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n0.\n1.,1.\n1\n";
}

TEST(FlushSlide, KeepsItsNormalForce) {
  RunScene scene(sliding_block());
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double pressed = 0, least = 1e300;
  scene.go([&](const solver::Run& run) {
    const double force = std::abs(run.contacts()[0].state().force_a.z());
    const double time = run.stepper().state().time;
    if (time < 22) pressed = force;
    if (time > 30) least = std::min(least, force);
  });
  EXPECT_GT(pressed, 0);
  EXPECT_GT(least, 0.8 * pressed);
  testing::Test::RecordProperty("least_share", fmt::format("{:.3f}", least / pressed));
}

}  // namespace
}  // namespace gapcheck::solver::flush_slide_test
