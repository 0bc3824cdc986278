// A bar pulled beyond its yield stress by prescribed motion: the force follows the curve of the deck.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/run_scene.hpp"

namespace gapcheck::solver::yield_test {
namespace {

constexpr double young = 1000, poisson = 0.3;

struct Pulled {
  const char* name;
  bool bricks;
  bool curve;  ///< material 024 with a curve, otherwise 003 with SIGY and ETAN
};

/// Yield stress over plastic strain, of the cards below.
double hardening(const Pulled& bar, double strain) {
  if (!bar.curve) return 10 + 50 * young / (young - 50) * strain;
  return strain < 0.05 ? 10 + 100 * strain : 15 + (strain - 0.05) * 5 / 0.15;
}

/// Stress, and its elastic strain, of a strain reached without unloading.
double stress_at(const Pulled& bar, double strain) {
  double low = 0, high = strain;  // plastic strain
  if (young * strain <= hardening(bar, 0)) return young * strain;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (young * (strain - middle) > hardening(bar, middle) ? low : high) = middle;
  }
  return hardening(bar, low);
}

std::string numbers(int first, int step, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += fmt::format("{}{}", i == 0 ? "" : ",", first + i * step);
  return text + "\n";
}

class PulledBar : public testing::TestWithParam<Pulled> {};

TEST_P(PulledBar, FollowsTheCurve) {
  const Pulled& bar = GetParam();
  constexpr double length = 4, elongation = 0.6, end = 200;
  // Sets: 1 the end that is held, 2 the one that is pulled, 3 the side y = 0, 4 the side z = 0.
  std::string deck = bar.bricks ? brick_bar(4, {1, 1, 1}) : plate(4, 1, {1, 1, 0});
  const int rows = bar.bricks ? 4 : 2;
  deck += "*SET_NODE_LIST\n1\n" + numbers(1, 5, rows) + "*SET_NODE_LIST\n2\n" + numbers(5, 5, rows);
  deck += "*SET_NODE_LIST\n3\n" + numbers(1, 1, 5) + (bar.bricks ? numbers(11, 1, 5) : "");
  deck += "*SET_NODE_LIST\n4\n" + numbers(1, 1, 8) + numbers(9, 1, 2);
  deck += "*BOUNDARY_SPC_SET\n1,0,1\n3,0,0,1\n4,0,0,0,1\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,2,7\n";
  deck += fmt::format("*DEFINE_CURVE\n7\n0.,0.\n{},{}\n", end, elongation);
  deck += "*DEFINE_CURVE\n8\n0.,10.\n0.05,15.\n0.2,20.\n";
  deck += "*PART\np\n1,1,1\n" + (bar.bricks ? solid_section : shell_section) + "*CONTROL_SHELL\n20.,0,0,1\n";
  deck += bar.curve ? fmt::format("*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,1.,{},{}\n0.,0.,8\n", young, poisson)
                    : fmt::format("*MAT_PLASTIC_KINEMATIC\n1,1.,{},{},10.,50.,0.5\n", young, poisson);
  deck += fmt::format("*CONTROL_TERMINATION\n{}\n", end);
  RunScene scene(deck);
  ASSERT_TRUE(scene.prepared()) << scene.message();
  const double section = bar.bricks ? 1 : 0.1;
  double worst = 0;
  scene.go([&](const solver::Run& run) {
    const State& state = run.stepper().state();
    const double strain = std::log((state.x[4].x() - state.x[0].x()) / length);
    if (strain < 0.004) return;
    double force = 0;
    for (int i = 0; i < rows; ++i) force -= run.stepper().external().force[static_cast<std::size_t>(5 * i)].x();
    const double stress = stress_at(bar, strain), elastic = stress / young;
    const double expected = stress * section * std::exp(-2 * poisson * elastic - (strain - elastic));
    worst = std::max(worst, std::abs(force / expected - 1));
  });
  EXPECT_NEAR(scene.state().x[4].x(), length + elongation, 1e-3);
  EXPECT_LT(worst, 0.02);
  RecordProperty(fmt::format("pulled_bar_{}_largest_error", bar.name), fmt::format("{:.4f}", worst));
}

INSTANTIATE_TEST_SUITE_P(All, PulledBar,
                         testing::Values(Pulled{"bricks_024", true, true}, Pulled{"shells_024", false, true},
                                         Pulled{"bricks_003", true, false}, Pulled{"shells_003", false, false}),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace gapcheck::solver::yield_test
