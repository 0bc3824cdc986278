#include "geometry/exact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "families.hpp"
#include "reference.hpp"

namespace gapcheck::geometry::test::exact_test {
namespace {

TEST(Exact, TrianglesAndSegmentsAgreeWithRationals) {
  Maker maker(401);
  for (int i = 0; i < 9000; ++i) {
    const Pair pair = maker.make(all_families[i % 9]);
    const auto& x = pair.facet.x;
    const mpq_class triangle = squared_distance(x[0], x[1], x[2], pair.query);
    const mpq_class segment = squared_distance(x[0], x[1], pair.query);
    for (double nudge : {-1.0, 0.0, 1.0}) {
      const auto beside = [&](const mpq_class& square) {
        return std::nextafter(std::sqrt(square.get_d()), nudge * std::numeric_limits<double>::infinity());
      };
      if (triangle > 0) {
        const double bound = nudge == 0 ? std::sqrt(triangle.get_d()) : beside(triangle);
        EXPECT_EQ(exact::triangle_closer(x[0], x[1], x[2], pair.query, bound),
                  triangle < mpq_class(bound) * mpq_class(bound))
            << describe(pair, bound);
      }
      if (segment > 0) {
        const double bound = nudge == 0 ? std::sqrt(segment.get_d()) : beside(segment);
        EXPECT_EQ(exact::segment_closer(x[0], x[1], pair.query, bound), segment < mpq_class(bound) * mpq_class(bound))
            << describe(pair, bound);
      }
    }
  }
}

Facet quad(Vector a, Vector b, Vector c, Vector d) { return {{a, b, c, d}, false}; }

TEST(Exact, FlatAndConvex) {
  const Vector o(0, 0, 0), x(1, 0, 0), xy(1, 1, 0), y(0, 1, 0);
  EXPECT_TRUE(exact::flat_and_convex(quad(o, x, xy, y)));
  EXPECT_TRUE(exact::flat_and_convex(quad(y, xy, x, o)));
  EXPECT_TRUE(exact::flat_and_convex(quad(o, x, xy, xy))) << "collapsed edge";
  EXPECT_TRUE(exact::flat_and_convex(quad(o, x, xy, 0.5 * xy))) << "three in a row";
  EXPECT_TRUE(exact::flat_and_convex(quad(o, x, 3 * x, 2 * x))) << "all in a row";
  EXPECT_TRUE(exact::flat_and_convex(quad(o, o, o, o)));
  EXPECT_FALSE(exact::flat_and_convex(quad(o, x, y, xy))) << "crossed";
  EXPECT_FALSE(exact::flat_and_convex(quad(o, x, 0.25 * xy, y))) << "dart";
  EXPECT_FALSE(exact::flat_and_convex(quad(o, x, o, y))) << "folded";
  EXPECT_FALSE(exact::flat_and_convex(quad(o, x, xy + Vector(0, 0, 1e-300), y))) << "warped, if only just";
}

/// On flat convex quads the patch is the two triangles, so the proofs for patches must say the same.
TEST(Exact, ThePatchOfAFlatQuadIsItsTriangles) {
  Maker maker(409);
  std::size_t settled = 0;
  for (int i = 0; i < 3000; ++i) {
    const Pair pair = maker.make(Family::lattice);
    const auto& x = pair.facet.x;
    if (pair.facet.triangle || !exact::flat_and_convex(pair.facet)) continue;
    const mpq_class square =
        std::min(squared_distance(x[0], x[1], x[2], pair.query), squared_distance(x[0], x[2], x[3], pair.query));
    const double bound = std::sqrt(square.get_d());
    if (!(bound > 0)) continue;
    const Verdict verdict = exact::piece_verdict(pair.facet, pair.query, bound, {}, 0, 0);
    if (verdict == Verdict::open) continue;
    ++settled;
    EXPECT_EQ(verdict == Verdict::closer, square < mpq_class(bound) * mpq_class(bound)) << describe(pair, bound);
  }
  EXPECT_GT(settled, 1000u);
}

TEST(Exact, TheFanCoversTheQuad) {
  const Facet saddle = quad({0, 0, 1}, {1, 0, -1}, {1, 1, 1}, {0, 1, -1});
  EXPECT_TRUE(exact::fan_closer(saddle, {0.5, 0.5, 0.1}, 0.11));
  EXPECT_FALSE(exact::fan_closer(saddle, {0.5, 0.5, 3}, 2));
  for (const Vector& corner : saddle.x) EXPECT_TRUE(exact::fan_closer(saddle, corner, 1e-300));
  EXPECT_TRUE(exact::fan_closer(saddle, {0.5, 0.5, 0}, 1e-300)) << "the centre of the patch";
}

TEST(Exact, Orientation) {
  EXPECT_EQ(exact::orientation({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}), 1);
  EXPECT_EQ(exact::orientation({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}), -1);
  EXPECT_EQ(exact::orientation({1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 0}), 0);
  EXPECT_EQ(exact::orientation({1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 5e-324}, {0, 0, 0}), 1);
}

}  // namespace
}  // namespace gapcheck::geometry::test::exact_test
