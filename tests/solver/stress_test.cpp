// Contact where it is hard: partners of very different stiffness, very thin shells, corners where many parts meet,
// nodes that slide off edges, steps at the limit, many nodes. Nothing may become a NaN, and no node in a contact zone
// may go without a record. To be run with GAPCHECK_CONTRACT=ON as well: nothing here may hang on the last bit.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "solver/contact_scene.hpp"

namespace gapcheck::solver::stress_test {
namespace {

StepSettings steps(double greatest) {
  StepSettings settings;
  settings.greatest_step = greatest;
  settings.energy_tolerance = 0;
  return settings;
}

bool all_finite(const ContactScene& scene) {
  for (const auto* list : {&scene.state().x, &scene.state().v})
    for (const Vector& v : *list)
      if (!v.allFinite()) return false;
  const Energies& e = scene.stepper->energies();
  return std::isfinite(e.total()) && std::isfinite(e.ratio());
}

/// n x n shells of a part in a plane of constant z, nodes from part · 1000000 on.
std::string sheet(int part, int n, const Vector& corner, double size) {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  const int first = part * 1'000'000;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      nodes += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", first + i + j * (n + 1), corner.x() + size * i / n,
                           corner.y() + size * j / n, corner.z());
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = first + i + j * (n + 1);
      shells += fmt::format("{},{},{},{},{},{}\n", a, part, a, a + 1, a + n + 2, a + n + 1);
    }
  return nodes + shells + fmt::format("*PART\nsheet\n{0},{0},{0}\n", part);
}

std::string properties(int part, double thickness, double young) {
  return fmt::format("*SECTION_SHELL\n{0},2\n{1}\n*MAT_ELASTIC\n{0},1.,{2},0.25\n", part, thickness, young);
}

ContactScene::Prepare throws(std::size_t first, const Vector& velocity) {
  return [=](Structure& s) {
    for (std::size_t i = first; i < s.state.v.size(); ++i) s.state.v[i] = velocity;
  };
}

struct Ratio {
  const char* name;
  const char* type;
  const char* soft;
};

class StiffnessRatio : public testing::TestWithParam<Ratio> {};

TEST_P(StiffnessRatio, StaysFiniteAndKeepsItsMomentum) {
  for (const double ratio : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    ContactScene scene(sheet(1, 2, {0, 0, 0}, 1) + sheet(2, 3, {0.1, 0.2, 0.051}, 0.7) + properties(1, 0.05, 1000) +
                           properties(2, 0.05, 1000 * ratio) + "*SET_PART_LIST\n1\n1,2\n*CONTACT_" + GetParam().type +
                           "\n1,0,2\n0.3,0.2\n1.,1.\n" + GetParam().soft + "\n0.\n",
                       throws(9, {0.02, 0.01, -0.2}), steps(2e-3));
    ASSERT_TRUE(scene.stepper) << scene.why_not;
    const Vector before = scene.momentum();
    bool touched = false;
    for (int cycle = 0; cycle < 1500; ++cycle) {
      const SolverStatus status = scene.stepper->step();
      ASSERT_TRUE(status.ok()) << ratio << ": " << status.error().message;
      touched = touched || scene.result().touching > 0;
    }
    EXPECT_TRUE(all_finite(scene)) << ratio;
    EXPECT_LE((scene.momentum() - before).norm(), 1e-10 * before.norm()) << ratio;
    EXPECT_TRUE(touched) << ratio;
    EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 0.05) << ratio;
  }
}

INSTANTIATE_TEST_SUITE_P(All, StiffnessRatio,
                         testing::Values(Ratio{"t13_soft_0", "AUTOMATIC_SINGLE_SURFACE", "0"},
                                         Ratio{"t13_soft_1", "AUTOMATIC_SINGLE_SURFACE", "1"},
                                         Ratio{"t13_soft_2", "AUTOMATIC_SINGLE_SURFACE", "2,,,,2,5"},
                                         Ratio{"t26", "AUTOMATIC_GENERAL", "0"}),
                         [](const auto& one) { return std::string(one.param.name); });

// Thickness a millionth of the edge: as long as they come slowly enough, no node passes without a record.
TEST(Stress, VeryThinShells) {
  constexpr double thickness = 1e-6, speed = 1e-6;
  for (const char* soft : {"0", "1", "2"}) {
    ContactScene scene(sheet(1, 2, {0, 0, 0}, 1) + sheet(2, 2, {0.1, 0.2, 1.2 * thickness}, 0.7) +
                           properties(1, thickness, 1000) + properties(2, thickness, 1000) +
                           "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,3,3\n0.\n1.,1.\n" + soft + "\n0.,0,0,1\n",
                       throws(9, {0, 0, -speed}), steps(5e-3));
    ASSERT_TRUE(scene.stepper) << scene.why_not;
    for (int cycle = 0; cycle < 200; ++cycle) {
      ASSERT_TRUE(scene.stepper->begin_step().ok());
      std::size_t in_zone = 0, listed = 0;
      for (std::size_t i = 9; i < 18; ++i)
        in_zone += std::abs(scene.state().x[i].z() - scene.state().x[4].z()) < 0.5 * thickness;
      for (const ContactNode& node : scene.contacts->nodes(0)) listed += node.node.value >= 9;
      ASSERT_GE(listed, in_zone) << "cycle " << cycle;
      scene.stepper->end_step();
    }
    EXPECT_TRUE(all_finite(scene));
  }
}

/// Eight cubes of a part each around the origin, a gap apart; `shift`: out of line with each other by so much.
std::string eight_cubes(double gap, double shift) {
  std::string text;
  for (int part = 1; part <= 8; ++part) {
    const auto side = [&](int axis) { return ((part - 1) >> axis & 1) != 0 ? 1.0 : -1.0; };
    const Vector middle = (0.5 + gap / 2) * Vector(side(0), side(1), side(2)) +
                          shift * Vector(part % 3, part * part % 5, part * part % 7);
    text += "*NODE\n";
    for (int i = 0; i < 8; ++i)
      text += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", 10 * part + i,
                          middle.x() + (i % 4 == 1 || i % 4 == 2 ? 0.5 : -0.5), middle.y() + (i % 4 >= 2 ? 0.5 : -0.5),
                          middle.z() + (i >= 4 ? 0.5 : -0.5));
    text += fmt::format("*ELEMENT_SOLID\n{},{}", part, part);
    for (int i = 0; i < 8; ++i) text += fmt::format(",{}", 10 * part + i);
    text += fmt::format("\n*PART\nc\n{},1,1\n", part);
  }
  return text + "*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,1.,1000.,0.25\n";
}

// With and without corners and side faces that are exactly in line: nodes are then on the surface of their neighbours
// and not in it.
TEST(Stress, CornerOfEightParts) {
  for (const double shift : {0.0, 0.0007})
    for (const char* soft : {"0", "1", "2"}) {
      ContactScene scene(
          eight_cubes(0.02, shift) + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.2,0.2\n1.,1.\n" + soft + "\n0.,0,0,1\n",
          [](Structure& s) {
            for (std::size_t i = 0; i < s.state.x.size(); ++i) {
              const std::size_t part = i / 8;
              for (int axis = 0; axis < 3; ++axis)
                s.state.v[i][axis] = ((part >> axis & 1) != 0 ? -1 : 1) * (0.05 + 0.003 * static_cast<double>(part));
            }
          },
          steps(8e-3));  // a lone cube leaves no room for contact at its own step
      ASSERT_TRUE(scene.stepper) << scene.why_not;
      const Vector before = scene.momentum();
      SolverStatus status;
      for (int cycle = 0; cycle < 800 && status.ok(); ++cycle) status = scene.stepper->step();
      ASSERT_TRUE(status.ok()) << "SOFT = " << soft << " " << status.error().message;
      EXPECT_LT(scene.stepper->energies().ratio(), 1.1) << soft;
      EXPECT_TRUE(all_finite(scene));
      EXPECT_LE((scene.momentum() - before).norm(), 1e-11 * (1 + before.norm()));
    }
}

// Pressed on a plate, it slides over the plate's rim and falls: contact ends, and nothing is left of it.
TEST(Stress, NodeSlidesOffAnEdge) {
  for (const char* type : {"AUTOMATIC_SURFACE_TO_SURFACE", "AUTOMATIC_GENERAL"})
    for (const char* soft : {"0", "2"}) {
      const std::string sides = std::string(type) == "AUTOMATIC_GENERAL" ? "\n0\n" : "\n2,1,3,3\n";
      ContactScene scene(sheet(1, 2, {0, 0, 0}, 1) + sheet(2, 1, {0.6, 0.4, 0.0501}, 0.2) + properties(1, 0.05, 1000) +
                             properties(2, 0.05, 1000) + "*CONTACT_" + type + sides + "0.1,0.1\n1.,1.\n" + soft +
                             "\n0.,0,0,1\n",
                         throws(9, {1, 0, -0.05}), steps(1e-3));
      ASSERT_TRUE(scene.stepper) << scene.why_not;
      bool touched = false;
      while (scene.state().time < 2) {
        const SolverStatus status = scene.stepper->step();
        ASSERT_TRUE(status.ok()) << status.error().message;
        touched = touched || scene.result().touching > 0;
      }
      EXPECT_TRUE(touched);
      EXPECT_TRUE(all_finite(scene));
      EXPECT_GT(scene.state().x[9].x(), 1.2);
      EXPECT_TRUE(scene.contacts->nodes(0).empty());
      EXPECT_NEAR(scene.stepper->energies().ratio(), 1, 0.05);
    }
}

/// Speed with which central differences of the step 2 `share` / ω throw a mass out of a spring that held it at rest, in
/// units of ω times the penetration.
double thrown_out(double share) {
  double penetration = 1, speed = 0, kick = share;  // half a step at first
  for (; penetration > 0; kick = 2 * share) {
    speed += kick * penetration;
    penetration -= 2 * share * speed;
  }
  return speed;
}

// Steps below and above the limit 2 / ω: the node leaves as central differences say. Beyond the limit it gets more than
// the spring held.
TEST(Stress, StepAtTheLimit) {
  constexpr double penetration = 0.15;
  // k = 0.1 K A / longest diagonal, between masses of 1 and 4.
  const double frequency = std::sqrt(0.1 * (1000 / 1.5) / std::sqrt(2.0) * (1 + 0.25));
  for (const double share : {0.1, 0.5, 0.6, 0.9, 0.99, 1.01, 1.5}) {
    StepSettings settings = steps(share * 2 / frequency);
    settings.bounded_step = false;
    settings.time_step_factor = 1e30;
    ContactScene scene(node_over_quad(0.5 - penetration, 1, "0\n0.,0,0,1\n"), {}, settings);
    ASSERT_TRUE(scene.stepper) << scene.why_not;
    for (int cycle = 0; cycle < 200; ++cycle) ASSERT_TRUE(scene.stepper->step().ok()) << share;
    EXPECT_TRUE(all_finite(scene)) << share;
    const double speed = scene.state().v[4].z() - scene.state().v[0].z();
    EXPECT_NEAR(speed, thrown_out(share) * frequency * penetration, 1e-8) << share;
  }
}

TEST(Stress, HundredThousandNodesOnAPlate) {
  constexpr int n = 316;
  constexpr std::size_t plate = 121, count = (n + 1) * (n + 1);
  ContactScene scene(sheet(1, 10, {0, 0, 0}, 1) + sheet(2, n, {0.001, 0.002, 0.0501}, 0.99) +
                         properties(1, 0.05, 1000) + properties(2, 0.05, 1000) +
                         "*CONTROL_CONTACT\n0.1\n0,0,0,0,4,1\n" +
                         "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n2,1,3,3\n0.\n1.,1.\n0\n0.,0,0,1\n",
                     throws(plate, {0, 0, -2}), steps(2e-5));
  ASSERT_TRUE(scene.stepper) << scene.why_not;
  ASSERT_EQ(scene.state().x.size(), plate + count);
  for (int cycle = 0; cycle < 8; ++cycle) {
    const SolverStatus status = scene.stepper->step();
    ASSERT_TRUE(status.ok()) << status.error().message;
  }
  EXPECT_TRUE(all_finite(scene));
  EXPECT_EQ(scene.result().touching + scene.result().released, count);
  EXPECT_EQ(scene.contacts->nodes(0).size(), count);
}

}  // namespace
}  // namespace gapcheck::solver::stress_test
