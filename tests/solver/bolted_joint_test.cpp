// A bolt of one spotweld beam between two plates: the preload closes the gap and clamps them.
#include <cmath>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::bolted_joint_test {
namespace {

constexpr double preload = 500;  // N

/// A plate of 4 x 4 quads with sides of 5, thickness 2, its nodes from `first` on; the middle 3 x 3 nodes and the
/// bolt's node `head` form the nodal rigid body `id`, the four corners are node set `id` + 10.
std::string plate_with_head(int id, int first, int head, double height) {
  std::string text = "*NODE\n", inner, corners;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) {
      const int node = first + i + 5 * j;
      text += fmt::format("{},{},{},{}\n", node, 5. * (i - 2), 5. * (j - 2), height);
      if (std::abs(i - 2) <= 1 && std::abs(j - 2) <= 1) inner += fmt::format("{}\n", node);
      if (std::abs(i - 2) == 2 && std::abs(j - 2) == 2) corners += fmt::format("{}\n", node);
    }
  text += "*ELEMENT_SHELL\n";
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const int a = first + i + 5 * j;
      text += fmt::format("{},{},{},{},{},{}\n", 100 * id + i + 4 * j, id, a, a + 1, a + 6, a + 5);
    }
  return text + fmt::format("*SET_NODE_LIST\n{}\n{}{}\n*SET_NODE_LIST\n{}\n{}", id, inner, head, id + 10, corners) +
         fmt::format("*CONSTRAINED_NODAL_RIGID_BODY\n{},0,{}\n*PART\nplate\n{},1,1\n", 50 + id, id, id);
}

const std::string joint =
    "*CONTROL_TERMINATION\n4.\n*NODE\n901,0.,0.,-2.\n902,0.,0.,4.2\n903,1.,0.,0.\n" + plate_with_head(1, 101, 901, 0) +
    plate_with_head(2, 201, 902, 2.2) +
    "*SECTION_SHELL\n1,2,,3\n2.\n*MAT_ELASTIC\n1,7.85e-6,210.,0.3\n"
    "*ELEMENT_BEAM\n7,3,901,902,903\n*PART\nbolt\n3,3,3\n*SECTION_BEAM\n3,9,1.,2,1\n6.,6.\n"
    "*MAT_SPOTWELD\n3,7.85e-6,210.,0.3,100.,1.\n\n*SET_BEAM\n1\n7\n*INITIAL_AXIAL_FORCE_BEAM\n1,9,0.5\n"
    "*DEFINE_CURVE\n9\n0.,0.\n1.,1.\n3.,1.\n*BOUNDARY_SPC_SET\n11,0,1,1,1\n*DAMPING_GLOBAL\n0,20.\n"
    "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n0.\n\n";

// In kN, mm, ms: the bolt pulls with 0.5 kN; the plates come together over 0.2 mm and press with what the bolt does not
// spend on bending the lower plate's corners. After the curve has ended the bolt keeps its force.
TEST(BoltedJoint, PreloadClampsThePlates) {
  RunScene scene(joint);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double at_end_of_curve = 0, clamped = 0, worst = 0;
  scene.go([&](const auto& run) {
    const double time = run.stepper().state().time, bolt = run.stepper().structure().beams.axial(0);
    if (time <= 3) {
      worst = std::max(worst, std::abs(bolt - preload / 1000 * std::min(time, 1.0)));
      at_end_of_curve = bolt;
      clamped = run.contacts()[0].state().force_a.norm();
    }
  });
  EXPECT_LT(worst, 1e-12);
  EXPECT_NEAR(at_end_of_curve, 0.5, 1e-12);
  EXPECT_NEAR(clamped / 0.5, 1, 1e-3);
  EXPECT_NEAR(scene.run().stepper().structure().beams.axial(0) / 0.5, 1, 2e-3) << "kept when the curve is over";
  EXPECT_NEAR(scene.run().contacts()[0].state().force_a.norm() / 0.5, 1, 2e-3);
  const Energies& e = scene.energies();
  EXPECT_GT(e.external, 0.01);
  EXPECT_NEAR(e.total() / e.external, 1, 1e-3);
}

}  // namespace
}  // namespace gapcheck::solver::bolted_joint_test
