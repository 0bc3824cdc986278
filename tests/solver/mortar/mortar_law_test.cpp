// The pressure law of mortar contact: closed forms, no kink, and the energy as its integral.
#include "solver/mortar/mortar_law.hpp"

#include <gtest/gtest.h>

namespace gapcheck::solver::mortar_law_test {
namespace {

constexpr MortarLaw law{50, 0.03, 50};

TEST(MortarLaw, QuadraticThenLinear) {
  EXPECT_EQ(law.pressure(0), 0);
  EXPECT_EQ(law.pressure(-1), 0);
  // κ ε d_c x² / 4 with x = d / (ε d_c).
  EXPECT_NEAR(law.pressure(0.03), 50 * 0.03 / 4, 1e-15);
  EXPECT_NEAR(law.pressure(0.06), 50 * 0.03, 1e-14);
  EXPECT_NEAR(law.pressure(1.03), 50, 1e-12);
}

// Steeper than κ: the curve goes on, up to any depth without a bound; less steep: the line begins at a smaller
// pressure.
TEST(MortarLaw, FollowsTheFormulaUpToTheBound) {
  constexpr MortarLaw free{50, 0.03}, steep{50, 0.03, 500}, flat{50, 0.03, 5};
  for (const double depth : {0.001, 0.02, 0.5, 0.6}) {
    EXPECT_NEAR(free.pressure(depth), 50 * depth * depth / 0.12, 1e-12);
    EXPECT_NEAR(steep.pressure(depth), free.pressure(depth), 1e-12);
  }
  EXPECT_NEAR(steep.pressure(0.7) - steep.pressure(0.6), 0.1 * 500, 1e-10);
  EXPECT_NEAR(flat.pressure(0.006), free.pressure(0.006), 1e-15);
  EXPECT_NEAR(flat.pressure(0.106) - flat.pressure(0.006), 0.1 * 5, 1e-12);
  for (const MortarLaw& one : {free, steep, flat}) {
    double sum = 0;
    for (int i = 0; i < 8000; ++i) sum += 1e-4 * one.pressure(1e-4 * i + 5e-5);
    EXPECT_NEAR(one.energy(0.8), sum, 1e-5 * sum);
    for (const double depth : {0.001, 0.02, 0.5, 2.0})
      EXPECT_NEAR(one.depth_of(one.pressure(depth)), depth, 1e-12 * depth);
  }
}

TEST(MortarLaw, SlopeHasNoJump) {
  const auto slope = [&](double depth) { return (law.pressure(depth + 1e-8) - law.pressure(depth - 1e-8)) / 2e-8; };
  EXPECT_NEAR(slope(0.03), 25, 1e-4);
  EXPECT_NEAR(slope(0.0599), 50, 0.1);
  EXPECT_NEAR(slope(0.0601), 50, 1e-4);
}

TEST(MortarLaw, EnergyIsTheIntegralOfThePressure) {
  double sum = 0, depth = 0;
  constexpr double step = 1e-5;
  for (; depth < 0.2; depth += step) {
    EXPECT_NEAR(law.energy(depth), sum, 1e-7);
    sum += step * law.pressure(depth + step / 2);
  }
}

TEST(MortarLaw, DepthOfAPressure) {
  for (const double depth : {0.001, 0.03, 0.06, 0.061, 3.0})
    EXPECT_NEAR(law.depth_of(law.pressure(depth)), depth, 1e-12 * depth);
  EXPECT_EQ(law.depth_of(0), 0);
  EXPECT_EQ((MortarLaw{0, 0.1}).depth_of(5), 0);
  EXPECT_NEAR((MortarLaw{2, 0}).pressure(3), 6, 1e-15) << "linear without a knee";
}

}  // namespace
}  // namespace gapcheck::solver::mortar_law_test
