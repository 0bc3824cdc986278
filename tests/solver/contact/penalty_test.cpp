// Contact springs as they act in a run: how deep and how long a node penetrates, and how stiff they are by the deck.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::penalty_test {
namespace {

constexpr double pi = std::numbers::pi;

/// A held quad of 1 x 1 in z = 0 of thickness 0.1, modulus 1000, and node 5 of mass 1 above its middle. `cards`: of the
/// contact from card 3 on; `more`: further keywords.
std::string node_over_held_quad(double height, const std::string& cards, const std::string& more) {
  return fmt::format("*NODE\n1,0.,0.,0.,7,7\n2,1.,0.,0.,7,7\n3,1.,1.,0.,7,7\n4,0.,1.,0.,7,7\n5,0.5,0.5,{:.17g}\n",
                     height) +
         "*ELEMENT_SHELL\n1,1,1,2,3,4\n*PART\np\n1,1,1\n*SECTION_SHELL\n1,2\n0.1\n*MAT_ELASTIC\n1,1.,1000.,0.25\n"
         "*ELEMENT_MASS\n5,5,1.\n1,1,1.\n2,2,1.\n3,3,1.\n4,4,1.\n*SET_NODE_LIST\n1\n5\n*SET_PART_LIST\n1\n1\n"
         "*CONTROL_TERMINATION\n1e9\n" +
         more + "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n1,1,4,2\n0.\n" + cards;
}

/// Slope of y over x in logarithms, by least squares.
double slope(const std::vector<std::pair<double, double>>& points) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [a, b] : points) {
    x += std::log(a);
    y += std::log(b);
    xx += std::log(a) * std::log(a);
    xy += std::log(a) * std::log(b);
  }
  const auto n = static_cast<double>(points.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

// k ~ SFS: the deepest point v √(m/k) and the time of contact π √(m/k) fall with its root, over four decades.
TEST(Penalty, DepthAndTimeFallWithTheRootOfTheScale) {
  constexpr double v = 0.005;
  const double unit = 0.1 * (1000 / 1.5) / std::sqrt(2.0);
  std::vector<std::pair<double, double>> depths, times;
  for (const double scale : {0.01, 0.1, 1.0, 10.0, 100.0}) {
    const double frequency = std::sqrt(unit * scale);
    RunSettings settings;
    settings.step.greatest_step = 0.01 / frequency;
    settings.until = 1.2 * pi / frequency;
    RunScene scene(node_over_held_quad(0.05, fmt::format("{0},{0}\n0\n0.,0,0,1\n", scale),
                                       fmt::format("*INITIAL_VELOCITY_NODE\n5,0.,0.,{}\n", -v)),
                   settings);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    double deepest = 0, inside = 0;
    scene.go([&](const solver::Run& run) {
      for (const ContactNode& node : run.contacts()[0].nodes()) {
        deepest = std::max(deepest, node.penetration);
        inside += run.stepper().next_step();
      }
    });
    EXPECT_NEAR(deepest / (v / frequency), 1, 1e-3) << scale;
    EXPECT_NEAR(inside / (pi / frequency), 1, 0.01) << scale;
    EXPECT_NEAR(scene.state().v[4].z() / v, 1, 1e-3) << scale;
    depths.emplace_back(scale, deepest);
    times.emplace_back(scale, inside);
  }
  EXPECT_NEAR(slope(depths), -0.5, 1e-4);
  EXPECT_NEAR(slope(times), -0.5, 1e-3);
  RecordProperty("penetration_over_SFS_exponent", fmt::format("{:.5f}", slope(depths)));
  RecordProperty("contact_time_over_SFS_exponent", fmt::format("{:.5f}", slope(times)));
}

/// Force over penetration of the only node that is pressed, after one cycle.
double measured_stiffness(const std::string& deck) {
  RunSettings settings;
  settings.cycles = 1;
  settings.step.greatest_step = 1e-6;
  RunScene scene(deck, settings);
  double stiffness = 0;
  scene.go([&](const solver::Run& run) {
    const auto nodes = run.contacts()[0].nodes();
    ASSERT_EQ(nodes.size(), 1u);
    stiffness = nodes[0].force.norm() / nodes[0].penetration;
  });
  return stiffness;
}

// A corner of two quads of different size stands on a quad of another material: each PENOPT takes its own of them.
// K = E / 1.5; SLSFAC SFS K A / diagonal is 0.3 · 4000 / 1.5 · 0.18 / 0.6 = 240 for the large quad at the corner,
// 160 for the small one, and 0.45 · 1000 / 1.5 / √2 for the quad below.
TEST(Penalty, PenoptChoosesTheSpring) {
  constexpr double sfs = 2, sfm = 3, slsfac = 0.15, t = 0.04;
  constexpr double segment = 300 / std::numbers::sqrt2, weighted = (0.18 * 240 + 0.08 * 160) / 0.26;
  constexpr std::array<double, 5> expected{160, segment, 160, weighted, weighted / t};
  for (int penopt = 1; penopt <= 5; ++penopt) {
    const double stiffness = measured_stiffness(
        "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.5,0.5,0.06\n6,0.8,0.5,0.36\n7,0.5,0.5,0.66\n"
        "8,0.2,0.5,0.36\n9,0.5,0.7,0.26\n10,0.5,0.5,0.46\n11,0.5,0.3,0.26\n"
        "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,5,6,7,8\n3,2,5,9,10,11\n*PART\nlower\n1,1,1\n*PART\nupper\n2,2,2\n"
        "*SECTION_SHELL\n1,2\n0.1\n*SECTION_SHELL\n2,2\n0.04\n*MAT_ELASTIC\n1,1.,1000.,0.25\n"
        "*MAT_ELASTIC\n2,1.,4000.,0.25\n*CONTROL_TERMINATION\n1.\n" +
        fmt::format("*CONTROL_CONTACT\n{},0.,0,0,{}\n", slsfac, penopt) +
        fmt::format("*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE\n2,1,3,3\n0.\n{},{}\n0\n0.,0,0,1\n", sfs, sfm));
    EXPECT_NEAR(stiffness / expected[static_cast<std::size_t>(penopt - 1)], 1, 1e-9) << penopt;
  }
}

// SOFT = 1: the spring of the step that DTSTIF names, where that is stiffer than the one of the materials.
TEST(Penalty, SoftOneReckonsWithDtstif) {
  const double soft_0 = 0.1 * (1000 / 1.5) / std::sqrt(2.0);
  for (const double step : {0.01, 0.02, 1.0}) {
    const double stiffness =
        measured_stiffness(node_over_held_quad(0.04, fmt::format("1.,1.\n1,0.2\n0.,0,0,1\n1,0,0.,{}\n", step), ""));
    // SOFSCL · 0.5 m* / Δt²; the node's mass of 1 is the smaller one.
    EXPECT_NEAR(stiffness / std::max(soft_0, 0.2 * 0.5 * 1 / (step * step)), 1, 1e-9) << step;
    EXPECT_EQ(stiffness > 2 * soft_0, step < 1);
  }
}

/// `deck` with the third card of *PART_CONTACT (FS, FD, DC, VC, OPTT, SFT, SSF) and FS of the contact.
std::string with_part_contact(std::string deck, const std::string& card, const std::string& fs) {
  const std::string part = "*PART\np\n1,1,1\n", card2 = "4,2\n0.\n";
  deck.replace(deck.find(part), part.size(), "*PART_CONTACT\np\n1,1,1\n" + card + "\n");
  return deck.replace(deck.find(card2), card2.size(), "4,2\n" + fs + "\n");
}

// *PART_CONTACT: SSF scales the spring of the part's segments; OPTT and SFT replace and scale their thickness.
TEST(Penalty, PartsScaleTheirStiffnessAndThickness) {
  const double spring = 0.1 * (1000 / 1.5) / std::sqrt(2.0);
  const auto of = [](const std::string& card) {
    RunSettings settings;
    settings.cycles = 1;
    settings.step.greatest_step = 1e-6;
    RunScene scene(with_part_contact(node_over_held_quad(0.04, "1.,1.\n0\n0.,0,0,1\n", ""), card, "0."), settings);
    EXPECT_TRUE(scene.prepared()) << scene.message();
    std::pair<double, double> found;
    if (!scene.prepared()) return found;
    scene.go([&](const solver::Run& run) {
      const auto nodes = run.contacts()[0].nodes();
      if (!nodes.empty()) found = {nodes[0].penetration, nodes[0].force.norm()};
    });
    return found;
  };
  EXPECT_NEAR(of("0.,0.,0.,0.,0.,0.,2.5").second / (2.5 * spring * 0.01), 1, 1e-9);
  EXPECT_NEAR(of("0.,0.,0.,0.,0.,0.,0.").second / (spring * 0.01), 1, 1e-9);
  EXPECT_NEAR(of("0.,0.,0.,0.,0.12").first, 0.02, 1e-12) << "OPTT";
  EXPECT_NEAR(of("0.,0.,0.,0.,0.,0.9").first, 0.005, 1e-12) << "SFT";
}

// FS = -1: the friction of the segment's part, by the speed, and no more than VC times the segment's area.
TEST(Penalty, PartsHaveTheirFriction) {
  for (const double limit : {0.0, 0.05}) {
    RunSettings settings;
    settings.cycles = 60;
    settings.step.greatest_step = 1e-3;
    const std::string deck = node_over_held_quad(0.04, "1.,1.\n0\n0.,0,0,1\n", "*INITIAL_VELOCITY_NODE\n5,2.\n");
    RunScene scene(with_part_contact(deck, fmt::format("0.3,0.1,0.5,{}", limit), "-1."), settings);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    int seen = 0;
    scene.go([&](const solver::Run& run) {
      const auto nodes = run.contacts()[0].nodes();
      if (run.stepper().state().cycle < 30 || nodes.empty()) return;
      // That of the next half step, by which the coefficient differs in its fifth digit.
      const double speed = run.stepper().state().v[4].head<2>().norm();
      const double coulomb = (0.1 + 0.2 * std::exp(-0.5 * speed)) * nodes[0].force.z();
      EXPECT_NEAR(nodes[0].force.head<2>().norm(), limit > 0 ? std::min(limit, coulomb) : coulomb, 5e-6);
      ++seen;
    });
    EXPECT_GT(seen, 20);
  }
}

// SLDTHK coats a brick's face; SLDSTF takes the place of its bulk modulus.
TEST(Penalty, CoatOfSolids) {
  for (const double modulus : {0.0, 5000.0}) {
    const double stiffness = measured_stiffness(
        "*NODE\n1,0.,0.,0.\n2,1.,0.,0.\n3,1.,1.,0.\n4,0.,1.,0.\n5,0.,0.,2.\n6,1.,0.,2.\n7,1.,1.,2.\n8,0.,1.,2.\n"
        "9,0.5,0.5,2.04\n*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*ELEMENT_MASS\n1,9,1.\n*PART\np\n1,1,1\n*SECTION_"
        "SOLID\n1,1\n"
        "*MAT_ELASTIC\n1,1.,1000.,0.25\n*SET_NODE_LIST\n1\n9\n*CONTROL_TERMINATION\n1.\n"
        "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n1,1,4,3\n0.\n1.,1.\n0\n" +
        fmt::format("0.,0,0,1,0,0,0.1,{}\n", modulus));
    // SLSFAC K A² / V of a brick of 1 x 1 x 2.
    EXPECT_NEAR(stiffness / (0.1 * (modulus > 0 ? modulus : 1000 / 1.5) / 2), 1, 1e-9) << modulus;
  }
}

}  // namespace
}  // namespace gapcheck::solver::penalty_test
