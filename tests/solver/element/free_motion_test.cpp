// Free bodies that turn and vibrate: nothing supplies energy, so nothing may gain any.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/output/state_balance.hpp"
#include "solver/run_scene.hpp"

namespace gapcheck::solver::free_motion_test {
namespace {

// Steel in mm, ms, kg.
const std::string steel = "*MAT_ELASTIC\n1,7.85e-6,210.,0.3\n";

/// n³ bricks of side 5 about the origin.
std::string block(int n) {
  std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
  const auto id = [&](int i, int j, int k) { return 1 + i + (n + 1) * (j + (n + 1) * k); };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        nodes += fmt::format("{},{},{},{}\n", id(i, j, k), 5 * i - 2.5 * n, 5 * j - 2.5 * n, 5 * k - 2.5 * n);
  int element = 0;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        solids += fmt::format("{},1,{},{},{},{},{},{},{},{}\n", ++element, id(i, j, k), id(i + 1, j, k),
                              id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1),
                              id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1));
  return nodes + solids + "*PART\nblock\n1,1,1\n*SECTION_SOLID\n1,1\n" + steel;
}

/// n² quads, or twice as many triangles, of side 5 about the origin, whose nodes are moved by up to `skew`.
std::string plate(int n, bool triangles, double skew = 1) {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  const auto id = [&](int i, int j) { return 1 + i + (n + 1) * j; };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      nodes += fmt::format("{},{},{},0.\n", id(i, j), 5 * i - 2.5 * n + skew / 2 * ((7 * i + 3 * j) % 5 - 2),
                           5 * j - 2.5 * n + skew / 2 * ((3 * i + 11 * j) % 5 - 2));
  int element = 0;
  const auto add = [&](int a, int b, int c, int d) {
    shells += fmt::format("{},1,{},{},{},{}\n", ++element, a, b, c, d);
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
      if (!triangles) {
        add(a, b, c, d);
      } else {
        add(a, b, c, c);
        add(c, d, a, a);
      }
    }
  return nodes + shells + "*PART\nplate\n1,1,1\n*SECTION_SHELL\n1,2\n1.,1.,1.,1.\n" + steel;
}

struct Course {
  double least = 1e300, greatest = 0;  ///< kinetic energy over the initial one
  double early = 0;                    ///< the greatest in the first thousand cycles
  double ratio = 1;
  double created = 0;  ///< by the elements, by their state, at the end, over the largest energy
};

Course calculate(const std::string& deck, std::uint64_t cycles) {
  RunSettings settings;
  settings.cycles = cycles;
  settings.step.energy_tolerance = 0;
  RunScene scene(deck + "*CONTROL_TERMINATION\n1e9\n", settings);
  EXPECT_TRUE(scene.prepared()) << scene.message();
  Course course;
  if (!scene.prepared()) return course;
  scene.go([&](const solver::Run& run) {
    const Energies& e = run.stepper().energies();
    course.least = std::min(course.least, e.printed_kinetic / e.printed_initial);
    course.greatest = std::max(course.greatest, e.printed_kinetic / e.printed_initial);
    if (run.stepper().state().cycle < 1000) course.early = course.greatest;
    course.ratio = e.ratio();
  });
  const StateBalance balance = state_balance(scene.run());
  course.created = balance.created() / balance.largest;
  return course;
}

std::string hourglass(int ihq) { return fmt::format("*CONTROL_HOURGLASS\n{},0.1\n", ihq); }

std::uint64_t cycles() {
  const char* given = std::getenv("GAPCHECK_FREE_CYCLES");
  return given == nullptr ? 20000 : std::strtoull(given, nullptr, 10);
}

class FreeRotation : public testing::TestWithParam<std::tuple<int, double>> {};

std::string spin(double rate) {
  return fmt::format("*INITIAL_VELOCITY_GENERATION\n1,2,{},0.,0.,0.\n0.,0.,0.,1.,2.,3.\n", rate);
}

/// `least`: vibration takes its share of the rotation, in ten million cycles of a plate 0.2 %.
void expect_constant(const Course& course, const std::string& name, double least = 0.999) {
  EXPECT_NEAR(course.created, 0, 1e-3);
  EXPECT_GT(course.least, least);
  EXPECT_LT(course.greatest, 1.001);
  testing::Test::RecordProperty(name, fmt::format("{:.6f} {:.6f}", course.least, course.greatest));
}

// The strain by which the block stretches is ρ (ω r)² / E, about 4e-5 of the energy at 10 rad/ms.
TEST_P(FreeRotation, OfBricksKeepsItsEnergy) {
  const auto [ihq, rate] = GetParam();
  expect_constant(calculate(block(2) + hourglass(ihq) + spin(rate), cycles()),
                  fmt::format("free_rotation_ihq_{}_spin_{:g}", ihq, rate));
}

// Viscous control does not hold skewed quads together: they creep, and hourglass energy is what the rotation loses.
TEST_P(FreeRotation, OfSkewedQuadsKeepsItsEnergy) {
  const auto [ihq, rate] = GetParam();
  const Course course = calculate(plate(2, false) + hourglass(ihq) + spin(rate), cycles());
  const std::string name = fmt::format("free_rotation_quads_ihq_{}_spin_{:g}", ihq, rate);
  if (ihq > 3) return expect_constant(course, name, 0.995);
  EXPECT_NEAR(course.created, 0, 1e-3);
  EXPECT_LT(course.greatest, 1.001);
  EXPECT_GT(course.least, 0.2);
  RecordProperty(name, fmt::format("{:.6f} {:.6f}", course.least, course.greatest));
}

TEST_P(FreeRotation, OfTrianglesKeepsItsEnergy) {
  const auto [ihq, rate] = GetParam();
  expect_constant(calculate(plate(2, true) + hourglass(ihq) + spin(rate), cycles()),
                  fmt::format("free_rotation_triangles_ihq_{}_spin_{:g}", ihq, rate), 0.995);
}

INSTANTIATE_TEST_SUITE_P(All, FreeRotation, testing::Combine(testing::Values(1, 2, 3, 4, 5), testing::Values(2., 10.)),
                         [](const auto& one) {
                           return fmt::format("ihq_{}_spin_{:g}", std::get<0>(one.param), std::get<1>(one.param));
                         });

// Viscous control has no stiffness, so a turning block creeps into its hourglass modes and flies apart: 14,000 cycles
// for e times the amplitude at 10 rad/ms, and fewer with the square of the rate. The run ends and says what helps.
TEST(FreeRotationForLong, ViscousControlDoesNotHoldABlock) {
  for (const int ihq : {3, 4}) {  // 2 begins without a rounding error to grow from
    RunSettings settings;
    settings.cycles = 50000;
    RunScene scene(block(2) + hourglass(ihq) + spin(50) + "*CONTROL_TERMINATION\n1e9\n", settings);
    ASSERT_TRUE(scene.prepared()) << scene.message();
    const auto end = scene.try_to_go();
    EXPECT_EQ(!end || *end == RunEnd::failed, ihq == 3) << ihq;
    EXPECT_EQ(scene.message().find("IHQ = 4 or 5") != std::string::npos, ihq == 3) << scene.message();
  }
}

/// Velocities in all directions, of at most `size`, that no two nodes of a plate share.
std::string velocities(int nodes, double size) {
  std::string text = "*INITIAL_VELOCITY_NODE\n";
  for (int node = 1; node <= nodes; ++node)
    text += fmt::format("{},{:.4f},{:.4f},{:.4f}\n", node, size * std::sin(12.9898 * node),
                        size * std::sin(78.233 * node), size / 10 * std::sin(37.719 * node));
  return text;
}

class FreeVibration : public testing::TestWithParam<std::tuple<int, double>> {};

// A step that follows the vibration lets a plate of squares gain half of its energy in 10,000 cycles, and burst later.
TEST_P(FreeVibration, OfPlatesGainsNothing) {
  const auto [ihq, skew] = GetParam();
  for (const bool triangles : {false, true}) {
    const Course course = calculate(plate(2, triangles, skew) + hourglass(ihq) + velocities(9, 1), cycles());
    EXPECT_LT(course.greatest, 1.001);
    EXPECT_NEAR(course.ratio, 1, 1e-3);
    EXPECT_NEAR(course.created, 0, 1e-3);
    RecordProperty(fmt::format("free_vibration_{}_ihq_{}_skew_{:g}", triangles ? "triangles" : "quads", ihq, skew),
                   fmt::format("{:.6f}", course.greatest));
  }
}

INSTANTIATE_TEST_SUITE_P(All, FreeVibration, testing::Combine(testing::Values(1, 2, 3, 4, 5), testing::Values(0., 1.)),
                         [](const auto& one) {
                           return fmt::format("ihq_{}_skew_{:g}", std::get<0>(one.param), std::get<1>(one.param));
                         });

// A lone brick that breathes: without bulk viscosity the energy comes back in every period, with it only less does. Its
// frequency is the bound's, so it stretches seven times as far as a slow one, and what is not linear shows.
TEST(FreeVibrationOfOne, BrickGainsNothing) {
  std::string velocities = "*INITIAL_VELOCITY_NODE\n";
  for (int node = 1; node <= 8; ++node)
    velocities += fmt::format("{},{},{},{}\n", node, (node - 1) & 1 ? 1. : -1., (node - 1) & 2 ? 1. : -1.,
                              (node - 1) & 4 ? 1. : -1.);
  const Course free = calculate(block(1) + velocities + "*CONTROL_BULK_VISCOSITY\n1e-30,1e-30\n", cycles());
  EXPECT_LT(free.early, 1.03);
  EXPECT_NEAR(free.greatest, free.early, 1e-3);
  EXPECT_LT(free.least, 0.1);
  const Course viscous = calculate(block(1) + velocities, cycles());
  EXPECT_LT(viscous.greatest, 1 + 1e-3);
  RecordProperty("free_vibration_brick", fmt::format("{:.6f} {:.6f}", free.greatest, viscous.greatest));
}

}  // namespace
}  // namespace gapcheck::solver::free_motion_test
