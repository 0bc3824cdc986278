// Decks with thick shells.
#include "solver/build/build_thick_shells.hpp"

#include <cmath>
#include <numbers>

#include "solver/output/plot.hpp"
#include "solver/output/state_balance.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::build_thick_shells_test {
namespace {

/// A strip of n thick shells along x, 1 wide and `thickness` high, held at x = 0.
std::string strip(int n, double length, double thickness, const std::string& section, const std::string& material,
                  bool held = true) {
  std::string text = "*NODE\n";
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 2; ++j)
        text += fmt::format("{},{},{},{},{}\n", 1 + 4 * i + 2 * k + j, length * i / n, j, k * thickness,
                            held && i == 0 ? 7 : 0);
  text += "*ELEMENT_TSHELL\n";
  for (int i = 0; i < n; ++i) {
    const int a = 1 + 4 * i, b = a + 4;
    text += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", i + 1, a, b, b + 1, a + 1, a + 2, b + 2, b + 3, a + 3);
  }
  return text + "*PART\nstrip\n1,1,1\n*SECTION_TSHELL\n" + section + material;
}

const std::string elastic = "*MAT_ELASTIC\n1,2.,1000.,0.\n", five = "1,1,0.8333333333,5\n";

TEST(BuildThickShells, MassLayersAndAxes) {
  const Structure structure = structure_of(strip(2, 4, 0.5, five, elastic));
  ASSERT_EQ(structure.thick_shells.size(), 2u);
  EXPECT_NEAR(structure.state.mass[0], 2 * 2 * 0.5 / 8, 1e-12);
  EXPECT_NEAR(structure.state.mass[4], 2 * 2 * 0.5 / 4, 1e-12);
  EXPECT_EQ(structure.thick_shells.properties(0).layers.size(), 5u);
  EXPECT_NEAR(structure.thick_shells.properties(0).shear_factor, 0.8333333333, 1e-12);
  EXPECT_NEAR(structure.thick_shells.state(0).shell.thickness, 0.5, 1e-12);
}

// First frequency of a cantilever: 1.8751² √(E I / ρ A l⁴) less than 1 % by shear and rotation; 16 shells.
TEST(BuildThickShells, FirstFrequencyOfACantilever) {
  std::string text = strip(16, 10, 0.3, five, elastic) + "*INITIAL_VELOCITY_NODE\n";
  for (int i = 1; i <= 16; ++i)
    for (int k = 1; k <= 4; ++k) text += fmt::format("{},0.,0.,{:.6g}\n", 4 * i + k, 1e-4 * std::pow(i / 16.0, 2));
  const double omega = 1.8751 * 1.8751 * std::sqrt(1000.0 / 2 * 0.3 * 0.3 / 12 / 1e4);
  text += fmt::format("*CONTROL_TERMINATION\n{}\n", 1.1 * std::numbers::pi / omega);
  RunScene scene(text);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  double back = 0, before = 1, created = 0;
  scene.go([&](const solver::Run& run) {
    const double z = run.stepper().state().x[64].z();
    if (before > 0 && z <= 0 && run.stepper().state().time > 0.1) back = run.stepper().state().time;
    before = z == 0 ? before : z;
    created = std::max(created, std::abs(state_balance(run).created()) / std::max(state_balance(run).largest, 1e-300));
  });
  RecordProperty("frequency", fmt::format("{:.3g}", std::numbers::pi / omega / back));
  EXPECT_NEAR(std::numbers::pi / omega / back, 1, 0.02);
  EXPECT_NEAR(scene.energies().total() / scene.energies().initial, 1, 1e-3);
  EXPECT_LT(created, 0.02);
}

// A strip that is pulled yields at σ A; the plot has the stress.
TEST(BuildThickShells, PulledStripYields) {
  std::string text = strip(3, 3, 0.4, five, "*MAT_PLASTIC_KINEMATIC\n1,2.,1000.,0.3,5.,50.\n", false) +
                     "*BOUNDARY_PRESCRIBED_MOTION_SET\n1,1,2,1,-1.\n2,1,2,1,1.\n*DEFINE_CURVE\n1\n0.,0.\n40.,0.06\n"
                     "*SET_NODE_LIST\n1\n1,2,3,4\n*SET_NODE_LIST\n2\n13,14,15,16\n*CONTROL_TERMINATION\n40.\n";
  RunScene scene(text);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  scene.go();
  const Structure& structure = scene.run().stepper().structure();
  for (std::size_t i = 0; i < 3; ++i)
    for (const PointState& point : structure.thick_shells.points(i)) {
      EXPECT_NEAR(point.stress[xx], 5 + 50.0 / 0.95 * point.plastic_strain, 0.02);
      EXPECT_NEAR(point.plastic_strain, std::log(1.04) - 6.7e-3, 1e-3);
    }
  const auto& x = scene.state().x;
  EXPECT_NEAR((x[6].z() - x[4].z()) / 0.4, 1 - 0.0325 / 2 - 0.3 * 0.0067, 2e-3) << "it thins";
}

TEST(BuildThickShells, WhatIsWrongOrOtherwiseCalculatedIsNamed) {
  const auto refused = [](const std::string& text, const std::string& part) {
    const Failure failure = failure_of(text);
    EXPECT_NE(failure.message.find(part), std::string::npos) << part << ": " << failure.message;
    EXPECT_GT(failure.place.line, 0u) << part;
  };
  std::string turned = strip(1, 1, 0.5, five, elastic);
  const std::string order = "1,1,1,5,6,2,3,7,8,4";
  ASSERT_NE(turned.find(order), std::string::npos);
  turned.replace(turned.find(order), order.size(), "1,1,3,7,8,4,1,5,6,2");
  refused(turned, "thick shell 1 has no volume");
  refused(strip(1, 1, 0.5, "1,1,-1.,2\n", elastic), "shear factor SHRF -1");
  refused(strip(1, 1, 0.5, five, "*MAT_MOONEY-RIVLIN_RUBBER\n1,1e-6,0.49,1.,0.5\n"), "calculated in solids only");
  const auto warned = [](const std::string& text, const std::string& part) {
    const model::Read read = model::read_text(text);
    Diagnostics diagnostics;
    ASSERT_TRUE(build_structure(read.model, {}, diagnostics));
    ASSERT_EQ(diagnostics.sorted().size(), 1u) << text;
    EXPECT_NE(diagnostics.sorted()[0].message.find(part), std::string::npos) << diagnostics.sorted()[0].message;
  };
  warned(strip(1, 1, 0.5, "1,3,,2\n", elastic), "thick shells of ELFORM 3 are calculated as ELFORM 1");
  warned(strip(1, 1, 0.5, "1,1,,200\n", elastic), "NIP is 200; 10 points are calculated");
  warned(strip(1, 1, 0.5, five, "*MAT_PLASTIC_KINEMATIC\n1,2.,1000.,0.3,5.,0.,0.\n0.,0.,0.2\n"),
         "thick shells do not fail");
}

// A rigid strip is a body with the mass of its volume.
TEST(BuildThickShells, RigidParts) {
  const Structure structure = structure_of(strip(2, 4, 0.5, five, "*MAT_RIGID\n1,2.,1000.,0.3\n", false));
  EXPECT_EQ(structure.thick_shells.size(), 0u);
  ASSERT_EQ(structure.rigid.size(), 1u);
  EXPECT_NEAR(structure.rigid[0].mass(), 2 * 4 * 0.5, 1e-12);
}

}  // namespace
}  // namespace gapcheck::solver::build_thick_shells_test
