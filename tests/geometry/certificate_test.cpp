#include "geometry/certificate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "families.hpp"
#include "geometry/view.hpp"
#include "reference.hpp"

namespace gapcheck::geometry::test::certificate_test {
namespace {

/// Every proof about every point of a facet must be true, also with a poor point and with corners that are off by what
/// the certificate allows.
TEST(Certificate, NeverProvesWhatIsFalse) {
  Maker maker(307);
  std::size_t proofs = 0;
  for (int i = 0; i < 20000; ++i) {
    const Family family = i % 3 == 0 ? Family::skew : i % 3 == 1 ? Family::warped : Family::far_away;
    const Pair pair = maker.make(family);
    const mpf_class exact = squared_distance(pair.facet, pair.query);
    const double distance = std::sqrt(exact.get_d());
    Corners e = seen_from(pair.facet, pair.query);
    const double size = size_of(e);
    for (Vector& corner : e) corner += 14 * roundoff * size * maker.point(1);
    if (pair.facet.triangle) e[3] = e[2];
    const double s = i % 5 == 0 ? 1.0 : maker.uniform(-1, 1), t = i % 7 == 0 ? -1.0 : maker.uniform(-1, 1);
    const Location best = pair.facet.triangle ? locate_on_triangle(e) : locate_on_patch(e, Patch(e));
    for (double factor : {0.5, 0.9, 1 - 1e-9, 1 - 1e-15, 1.0, 1 + 1e-15, 1 + 1e-9, 1.1, 2.0}) {
      const double bound = factor * distance;
      const bool closer = exact < mpf_class(bound, 600) * bound;
      const Certificate certificate(size, bound);
      if (certificate.separated_by_mean_plane(e)) {
        EXPECT_FALSE(closer) << describe(pair, bound);
      }
      for (const auto& [x, y] : {std::pair(s, t), std::pair(best.s, best.t)}) {
        const Verdict verdict = certificate.at(e, x, y, pair.facet.triangle);
        proofs += verdict == Verdict::closer || verdict == Verdict::apart ? 1 : 0;
        if (verdict == Verdict::closer) {
          EXPECT_TRUE(closer) << describe(pair, bound);
        }
        if (verdict == Verdict::apart) {
          EXPECT_FALSE(closer) << describe(pair, bound);
        }
      }
    }
  }
  EXPECT_GT(proofs, 100000u);
}

TEST(Certificate, TheAxisTestIsExact) {
  Maker maker(311);
  int separated = 0;
  for (int i = 0; i < 20000; ++i) {
    const Pair pair = maker.make(i % 2 == 0 ? Family::lattice : Family::far_away);
    const double bound = i % 4 == 0 ? maker.integer(1, 6) : maker.uniform(0, 2);
    if (!separated_by_axis(seen_from(pair.facet, pair.query), bound)) continue;
    ++separated;
    EXPECT_GE(squared_distance(pair.facet, pair.query), mpf_class(bound, 600) * bound) << describe(pair, bound);
  }
  EXPECT_GT(separated, 1000);
}

/// f(s, t) - drop is a lower bound of f on a dense grid.
TEST(Certificate, NothingDropsBelowTheLargestDrop) {
  Maker maker(313);
  int bounded = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pair pair = maker.make(i % 2 == 0 ? Family::warped : Family::skew);
    const Corners e = seen_from(pair.facet, pair.query);
    const Location near = locate_on_patch(e, Patch(e), i % 3 == 0);
    const Vector w = blend(e, quad_weights(near.s, near.t));
    const double drop = largest_drop(Patch(e), near.s, near.t, w, size_of(e));
    if (std::isinf(drop)) continue;
    ++bounded;
    for (int j = 0; j <= 50; ++j) {
      for (int k = 0; k <= 50; ++k) {
        const double value = blend(e, quad_weights(-1 + 0.04 * j, -1 + 0.04 * k)).squaredNorm();
        ASSERT_GE(value, w.squaredNorm() - drop - 1e-14) << describe(pair);
      }
    }
  }
  EXPECT_GT(bounded, 500);
}

TEST(Certificate, NearestMeansNearest) {
  Maker maker(317);
  int proven = 0;
  for (int i = 0; i < 3000; ++i) {
    const Pair pair = maker.make(i % 2 == 0 ? Family::warped : Family::skew);
    const Corners e = seen_from(pair.facet, pair.query);
    const Location at = locate_on_patch(e, Patch(e));
    if (!is_nearest(e, Patch(e), at.s, at.t)) continue;
    ++proven;
    const double distance = mpf_class(sqrt(squared_distance(pair.facet, pair.query))).get_d();
    EXPECT_NEAR(blend(e, quad_weights(at.s, at.t)).norm(), distance, 1e-12 * (1 + distance)) << describe(pair);
  }
  EXPECT_GT(proven, 1000);
}

}  // namespace
}  // namespace gapcheck::geometry::test::certificate_test
