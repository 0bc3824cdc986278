#include "audit/fix/gaps.hpp"

#include <gtest/gtest.h>

namespace gapcheck::audit::gaps_test {
namespace {

const std::vector<Vector> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.25, 0.5, 0.1}};

Gap gap_over_square() {
  Gap gap;
  gap.node = NodeIndex{4};
  gap.corners = {NodeIndex{0}, NodeIndex{1}, NodeIndex{2}, NodeIndex{3}};
  return gap;
}

TEST(Gaps, MeasuresAlongTheSide) {
  Gap gap = gap_over_square();
  GapState state = measure_gap(gap, corners);
  EXPECT_TRUE(state.counts);
  EXPECT_NEAR(state.gap, 0.1, 1e-15);
  EXPECT_NEAR(state.direction.z(), 1, 1e-15);
  EXPECT_NEAR(state.share[0] + state.share[3], 0.75, 1e-14);
  EXPECT_NEAR(state.share[0] + state.share[1] + state.share[2] + state.share[3], 1, 1e-14);
  gap.side = -1;
  state = measure_gap(gap, corners);
  EXPECT_NEAR(state.gap, -0.1, 1e-15);
  EXPECT_NEAR(state.direction.z(), -1, 1e-15);
}

TEST(Gaps, BesideAnEdgeTheWayLeadsAwayFromIt) {
  std::vector<Vector> x = corners;
  x[4] = {-0.1, 0.5, 0.1};
  const GapState state = measure_gap(gap_over_square(), x);
  EXPECT_TRUE(state.counts);
  EXPECT_NEAR(state.gap, std::sqrt(0.02), 1e-15);
  EXPECT_NEAR(state.direction.x(), -std::sqrt(0.5), 1e-14);
  x[4] = {-0.6, 0.5, 0.1};
  EXPECT_FALSE(measure_gap(gap_over_square(), x).counts);
}

// A beam counts up to a quarter of its length beyond its ends, as segments do.
TEST(Gaps, BeamsCountUpToTheEndOfTheirBand) {
  Gap gap = gap_over_square();
  gap.kind = audit::GapKind::line;
  gap.corners = {NodeIndex{0}, NodeIndex{1}, NodeIndex{1}, NodeIndex{1}};
  const auto counts = [&](double x) {
    std::vector<Vector> at = corners;
    at[4] = {x, 0, 0.125};
    return measure_gap(gap, at).counts;
  };
  EXPECT_TRUE(counts(1.25) && counts(-0.25));
  EXPECT_FALSE(counts(1.2501) || counts(-0.2501));
}

TEST(Gaps, ThicknessAndMidSurfacesShift) {
  Gap gap = gap_over_square();
  gap.shift = {0, 0, 0.3};
  gap.offset = 0.05;
  EXPECT_NEAR(measure_gap(gap, corners).gap, 0.35, 1e-14);
}

TEST(Gaps, BeamAxesAreLeftAlongTheShortestWay) {
  Gap gap = gap_over_square();
  gap.kind = audit::GapKind::line;
  gap.corners = {NodeIndex{0}, NodeIndex{1}, NodeIndex{1}, NodeIndex{1}};
  std::vector<Vector> x = corners;
  x[4] = {0.25, 0, 0.1};
  const GapState state = measure_gap(gap, x);
  EXPECT_NEAR(state.gap, 0.1, 1e-15);
  EXPECT_NEAR(state.direction.z(), 1, 1e-15);
  EXPECT_NEAR(state.share[0], 0.75, 1e-14);
  x[4] = {0.25, 0, 0};
  EXPECT_NEAR(std::abs(measure_gap(gap, x).direction.x()), 0, 1e-14);
}

TEST(Gaps, FacetsWithoutAreaGiveNoDirectionThatIsNoNumber) {
  std::vector<Vector> x(5, Vector::Zero());
  const GapState state = measure_gap(gap_over_square(), x);
  EXPECT_TRUE(state.direction.allFinite());
}

}  // namespace
}  // namespace gapcheck::audit::gaps_test
