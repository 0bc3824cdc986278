#include "solver/material/hardening.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace gapcheck::solver::hardening_test {
namespace {

TEST(YieldCurve, InterpolatesAndGoesOn) {
  const YieldCurve curve({{0, 100}, {0.1, 200}, {0.3, 240}});
  EXPECT_DOUBLE_EQ(curve.stress(0), 100);
  EXPECT_DOUBLE_EQ(curve.stress(0.05), 150);
  EXPECT_DOUBLE_EQ(curve.stress(0.1), 200);
  EXPECT_DOUBLE_EQ(curve.stress(0.2), 220);
  EXPECT_DOUBLE_EQ(curve.stress(0.4), 260);
}

TEST(YieldCurve, MendsItsPoints) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const YieldCurve curve({{0.1, 100}, {0.1, 500}, {nan, 1}, {0.05, 7}, {0.2, 150}});
  EXPECT_DOUBLE_EQ(curve.stress(0.05), 100);
  EXPECT_DOUBLE_EQ(curve.stress(0.15), 125);
  EXPECT_TRUE(YieldCurve(std::vector<YieldCurve::Point>{}).empty());
  EXPECT_DOUBLE_EQ(YieldCurve({{0, 80}}).stress(3), 80);
}

// trial − R Δ = σ(p + Δ) by hand: 1000 Δ in each segment.
TEST(YieldCurve, SolvesAcrossSegments) {
  const YieldCurve curve({{0, 100}, {0.1, 200}, {0.3, 240}});
  const auto first = curve.solve(200, 1000, 0, 1);  // 200 − 1000 Δ = 100 + 1000 Δ
  EXPECT_DOUBLE_EQ(first.increment, 0.05);
  EXPECT_DOUBLE_EQ(first.slope, 1000);
  const auto second = curve.solve(420, 1000, 0, 1);  // 420 − 1000 Δ = 200 + 200 (Δ − 0.1): Δ = 0.2
  EXPECT_DOUBLE_EQ(second.increment, 0.2);
  EXPECT_NEAR(second.slope, 200, 1e-9);
  const auto beyond = curve.solve(860, 1000, 0, 1);  // 860 − 1000 Δ = 240 + 200 (Δ − 0.3): 680 = 1200 Δ
  EXPECT_NEAR(beyond.increment, 680.0 / 1200, 1e-15);
  const auto scaled = curve.solve(500, 1000, 0.1, 2);  // 500 − 1000 Δ = 400 + 400 Δ
  EXPECT_NEAR(scaled.increment, 100.0 / 1400, 1e-15);
}

TEST(YieldCurve, SoftensWithoutRunningAway) {
  // A slope of -10000, steeper than the resistance, counts as one just below that: a millionth of it is left until the
  // corner at 0.01, then the level part has all of it.
  const YieldCurve curve({{0, 100}, {0.01, 0.001}, {1, 0.001}});
  const auto result = curve.solve(150, 1000, 0, 1);
  EXPECT_NEAR(result.increment, 0.01 + (50 - 1e-3 * 0.01) / 1000, 1e-14);
}

TEST(RateScale, CowperSymonds) {
  EXPECT_DOUBLE_EQ(rate_scale(40, 40, 5), 2);
  EXPECT_DOUBLE_EQ(rate_scale(32 * 40, 40, 5), 3);
  EXPECT_DOUBLE_EQ(rate_scale(0, 40, 5), 1);
  EXPECT_DOUBLE_EQ(rate_scale(40, 0, 5), 1);
  EXPECT_DOUBLE_EQ(rate_scale(40, 40, 0), 1);
}

}  // namespace
}  // namespace gapcheck::solver::hardening_test
