// Press fit of two rings against Lamé's solution of thick-walled cylinders: INTERFERENCE contacts, whose stiffness
// grows by a curve, and mortar contacts that press the overlap out (IGNORE = 3).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/mortar/mortar_scene.hpp"
#include "solver/output/state_balance.hpp"

namespace gapcheck::solver::interference_test {
namespace {

constexpr double inner = 0.6, middle = 1, outer = 1.5, young = 1000, poisson = 0.3, overlap = 0.002, length = 0.1;

/// A quarter of a ring in plane strain: `n` bricks around, 5 through the wall; node ids from 10000 · part.
std::string ring(int part, double from, double to, int n) {
  std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n", set;
  constexpr int wall = 5;
  const auto id = [&](int i, int j, int k) { return 10000 * part + (k * (n + 1) + j) * (wall + 1) + i; };
  for (int k = 0; k <= 1; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= wall; ++i) {
        const double angle = std::numbers::pi / 2 * j / n, r = from + (to - from) * i / wall;
        // TC: z everywhere (3), y and z (5) at the beginning, z and x (6) at the end.
        const int held = j == 0 ? 5 : j == n ? 6 : 3;
        nodes += fmt::format("{},{:.17g},{:.17g},{:.17g},{}\n", id(i, j, k), r * std::cos(angle), r * std::sin(angle),
                             length * k, held);
      }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < wall; ++i)
      solids += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", id(i, j, 0), part, id(i, j, 0), id(i + 1, j, 0),
                            id(i + 1, j + 1, 0), id(i, j + 1, 0), id(i, j, 1), id(i + 1, j, 1), id(i + 1, j + 1, 1),
                            id(i, j + 1, 1));
  // The face towards the other ring, normals outwards.
  const int i = part == 1 ? wall : 0;
  for (int j = 0; j < n; ++j)
    set += part == 1 ? fmt::format("{},{},{},{}\n", id(i, j, 0), id(i, j + 1, 0), id(i, j + 1, 1), id(i, j, 1))
                     : fmt::format("{},{},{},{}\n", id(i, j, 0), id(i, j, 1), id(i, j + 1, 1), id(i, j + 1, 0));
  return nodes + solids + fmt::format("*PART\nring\n{0},1,1\n*SET_SEGMENT\n{0}\n", part) + set;
}

/// Pressure of the fit for an overlap of the radii (Lamé 1852, plane strain, equal materials).
double pressure_of(double of_radii) {
  const double e = young / (1 - poisson * poisson), nu = poisson / (1 - poisson);
  const double aa = inner * inner, bb = middle * middle, cc = outer * outer;
  return of_radii * e / middle / ((cc + bb) / (cc - bb) + nu + (bb + aa) / (bb - aa) - nu);
}

struct Fit {
  double pressure = 0;  ///< of the force on a quarter
  double depth = 0;     ///< that is left, mean over the nodes
  double growth = 0;    ///< of the outer radius
  double first = 0;     ///< force in the first cycle
  double created = 0;   ///< energy that came from nothing, of the largest energy of the run
};

Fit press(const std::string& contact, int n_inner, int n_outer) {
  RunScene scene(ring(1, inner, middle + overlap / 2, n_inner) + ring(2, middle - overlap / 2, outer, n_outer) +
                 fmt::format("*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,1.,{},{}\n", young, poisson) +
                 "*DEFINE_CURVE\n1\n0.,0.\n1.,1.\n100.,1.\n*DAMPING_GLOBAL\n0,20.\n*CONTROL_TERMINATION\n2.\n" +
                 contact);
  EXPECT_TRUE(scene.prepared()) << scene.message();
  Fit fit;
  if (!scene.prepared()) return fit;
  const Vector before = scene.state().x.back();
  bool first = true;
  scene.go([&](const solver::Run& run) {
    if (std::exchange(first, false)) fit.first = run.contacts()[0].state().force_b.norm();
  });
  const StateBalance balance = state_balance(scene.run());
  fit.created = balance.created() / balance.largest;
  const ContactView view = scene.run().contacts()[0];
  // ∫ p cos θ over a quarter, on the outer ring.
  fit.pressure = view.state().force_b.x() / (middle * length);
  double count = 0;
  for (const ContactNode& node : view.nodes()) {
    fit.depth += node.penetration;
    count += 1;
  }
  fit.depth /= count;
  fit.growth = scene.state().x.back().norm() - before.norm();
  return fit;
}

void expect_lame(const Fit& fit, double within) {
  EXPECT_LT(fit.first, 1e-6) << "the force grows from zero";
  EXPECT_GT(fit.depth, 0);
  EXPECT_NEAR(fit.created, 0, 0.002) << "what the growing stiffness gives is accounted for";
  EXPECT_LT(fit.depth, 0.3 * overlap) << "most of the overlap is gone";
  const double exact = pressure_of(overlap - fit.depth);
  EXPECT_NEAR(fit.pressure, exact, within * exact);
  // u(c) = 2 p b² c / (E' (c² - b²)).
  const double e = young / (1 - poisson * poisson);
  const double growth = 2 * exact * middle * middle * outer / (e * (outer * outer - middle * middle));
  EXPECT_NEAR(fit.growth, growth, within * growth);
  testing::Test::RecordProperty("pressure_ratio", fmt::format("{:.4f}", fit.pressure / exact));
}

TEST(Interference, PressFitOfRings) {
  expect_lame(press("*CONTACT_SURFACE_TO_SURFACE_INTERFERENCE\n1,2\n0.\n20.,20.\n0,1\n", 24, 24), 0.02);
}

TEST(Interference, OneWayTypes) {
  expect_lame(press("*CONTACT_ONE_WAY_SURFACE_TO_SURFACE_INTERFERENCE\n1,2\n0.\n40.,40.\n0,1\n", 24, 24), 0.02);
  std::string nodes = "*SET_NODE_LIST\n7\n";
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j <= 24; ++j) nodes += fmt::format("{}\n", 10000 + (k * 25 + j) * 6 + 5);
  expect_lame(press(nodes + "*CONTACT_NODES_TO_SURFACE_INTERFERENCE\n7,2,4,0\n0.\n40.,40.\n0,1\n", 24, 24), 0.02);
}

/// How much the mean radius of an arc of chords is smaller than that of its corners.
double sagitta(int n) { return 2.0 / 3 * middle * (1 - std::cos(std::numbers::pi / 4 / n)); }

// Springs above the limit of the step are named before the run, with what would be stable.
TEST(Interference, NamesAnUnstableStep) {
  const auto warnings = [](const std::string& scale) {
    const RunScene scene(ring(1, inner, middle + overlap / 2, 24) + ring(2, middle - overlap / 2, outer, 24) +
                         fmt::format("*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,1.,{},{}\n", young, poisson) +
                         "*DEFINE_CURVE\n1\n0.,0.\n1.,1.\n*CONTROL_TERMINATION\n2.\n*CONTACT_SURFACE_TO_SURFACE_"
                         "INTERFERENCE\n1,2\n0.\n" +
                         scale + "," + scale + "\n0,1\n");
    EXPECT_TRUE(scene.prepared()) << scene.message();
    std::string text;
    for (const Diagnostic& one : scene.diagnostics().sorted())
      if (one.message.find("are stable below a step of") != std::string::npos) text += one.message + "\n";
    return text;
  };
  EXPECT_EQ(warnings("2."), "");
  const std::string found = warnings("200.");
  EXPECT_NE(found.find("contact 1, side A"), std::string::npos) << found;
  EXPECT_NE(found.find("set TSSFAC of *CONTROL_TIMESTEP to 0."), std::string::npos) << found;
}

// PENMAX makes the pressure linear nearly from the beginning, and MPAR2 keeps what is deeper than it.
TEST(Interference, MortarPressesTheOverlapOut) {
  const std::string contact = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n1,2\n0.\n20.,20.\n\n0.001\n1,4,1.,0.01\n";
  expect_lame(press(contact, 24, 24), 0.02);
  // So stiff that each step presses out a good part of the depth that gives force.
  EXPECT_NEAR(
      press("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n1,2\n0.\n100.,100.\n\n0.001\n1,3,1.\n", 24, 24).created, 0,
      0.002);
  // Chords that do not match: the polygons overlap by a little more.
  Fit other = press(contact, 60, 48);
  other.depth -= sagitta(48) - sagitta(60);
  expect_lame(other, 0.05);
}

}  // namespace
}  // namespace gapcheck::solver::interference_test
