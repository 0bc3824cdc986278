#include "geometry/patch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "families.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry::test::patch_test {
namespace {

TEST(Patch, BothFormsGiveTheSamePoints) {
  Maker maker(211);
  for (int i = 0; i < 1000; ++i) {
    const Pair pair = maker.make(Family::skew);
    const Corners e = seen_from(pair.facet, pair.query);
    const Patch patch(e);
    const double s = maker.uniform(-1, 1), t = maker.uniform(-1, 1);
    const Vector from_form = patch.m + t * patch.b + s * patch.along_s(t);
    EXPECT_LT((from_form - blend(e, quad_weights(s, t))).norm(), 1e-14);
  }
}

/// The search finds what the quick way finds, and on folded quads never less than a dense grid does.
TEST(Patch, SearchIsNoWorseThanTheQuickWayOrAGrid) {
  Maker maker(223);
  for (int i = 0; i < 300; ++i) {
    const Pair pair = maker.make(i % 2 == 0 ? Family::warped : Family::skew);
    const Corners e = seen_from(pair.facet, pair.query);
    const Patch patch(e);
    const auto value = [&](double s, double t) { return blend(e, quad_weights(s, t)).norm(); };
    const Location quick = locate_on_patch(e, patch), searched = search_patch(e, patch);
    const double found = value(searched.s, searched.t);
    EXPECT_LE(found, value(quick.s, quick.t) + 1e-12) << describe(pair);
    double grid = 1e300;
    for (int j = 0; j <= 100; ++j) {
      for (int k = 0; k <= 100; ++k) grid = std::min(grid, value(-1 + 0.02 * j, -1 + 0.02 * k));
    }
    EXPECT_LE(found, grid + 1e-9) << describe(pair);
  }
}

TEST(Patch, TheQuickProjectionIsExactOnFlatQuads) {
  Maker maker(227);
  for (int i = 0; i < 2000; ++i) {
    const Pair pair = maker.make(Family::flat);
    if (pair.facet.triangle) continue;
    const Corners e = seen_from(pair.facet, pair.query);
    const Location quick = locate_on_patch(e, Patch(e), true), full = locate_on_patch(e, Patch(e));
    EXPECT_NEAR(quick.s, full.s, 1e-12) << describe(pair);
    EXPECT_NEAR(quick.t, full.t, 1e-12) << describe(pair);
  }
}

}  // namespace
}  // namespace gapcheck::geometry::test::patch_test
