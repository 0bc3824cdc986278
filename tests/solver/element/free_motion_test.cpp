// Free bodies that turn and vibrate: nothing supplies energy, so nothing may gain any.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

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

struct Course {
  double least = 1e300, greatest = 0;  ///< kinetic energy over the initial one
  double ratio = 1;
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
    course.ratio = e.ratio();
  });
  return course;
}

std::string hourglass(int ihq) { return fmt::format("*CONTROL_HOURGLASS\n{},0.1\n", ihq); }

std::uint64_t cycles() {
  const char* given = std::getenv("GAPCHECK_FREE_CYCLES");
  return given == nullptr ? 20000 : std::strtoull(given, nullptr, 10);
}

class FreeRotation : public testing::TestWithParam<std::tuple<int, double>> {};

// The strain by which the block stretches is ρ (ω r)² / E, about 4e-5 of the energy at 10 rad/ms.
TEST_P(FreeRotation, OfBricksKeepsItsEnergy) {
  const auto [ihq, spin] = GetParam();
  const Course course =
      calculate(block(2) + hourglass(ihq) +
                    fmt::format("*INITIAL_VELOCITY_GENERATION\n1,2,{},0.,0.,0.\n0.,0.,0.,1.,2.,3.\n", spin),
                cycles());
  EXPECT_GT(course.least, 0.999);
  EXPECT_LT(course.greatest, 1.001);
  RecordProperty(fmt::format("free_rotation_ihq_{}_spin_{:g}", ihq, spin),
                 fmt::format("{:.6f} {:.6f}", course.least, course.greatest));
}

INSTANTIATE_TEST_SUITE_P(All, FreeRotation, testing::Combine(testing::Values(1, 2, 3, 4, 5), testing::Values(2., 10.)),
                         [](const auto& one) {
                           return fmt::format("ihq_{}_spin_{:g}", std::get<0>(one.param), std::get<1>(one.param));
                         });

// A lone brick that breathes: without bulk viscosity the energy comes back in every period, with it only less does.
TEST(FreeVibration, OfALoneBrickGainsNothing) {
  std::string velocities = "*INITIAL_VELOCITY_NODE\n";
  for (int node = 1; node <= 8; ++node)
    velocities += fmt::format("{},{},{},{}\n", node, (node - 1) & 1 ? 1. : -1., (node - 1) & 2 ? 1. : -1.,
                              (node - 1) & 4 ? 1. : -1.);
  const Course free = calculate(block(1) + velocities + "*CONTROL_BULK_VISCOSITY\n1e-30,1e-30\n", cycles());
  EXPECT_NEAR(free.greatest, 1, 1e-3);
  EXPECT_LT(free.least, 0.1);
  const Course viscous = calculate(block(1) + velocities, cycles());
  EXPECT_LT(viscous.greatest, 1 + 1e-3);
  RecordProperty("free_vibration_brick", fmt::format("{:.6f} {:.6f}", free.greatest, viscous.greatest));
}

}  // namespace
}  // namespace gapcheck::solver::free_motion_test
