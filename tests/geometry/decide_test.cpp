#include "geometry/decide.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "families.hpp"
#include "geometry/exact.hpp"
#include "reference.hpp"

namespace gapcheck::geometry::test::decide_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double up(double x) { return std::nextafter(x, infinity); }
double down(double x) { return std::nextafter(x, 0.0); }

/// Bounds from clear to the last bit around a distance.
std::vector<double> bounds_around(double d) {
  return {0.5 * d, d * (1 - 1e-6), d * (1 - 1e-9),  d * (1 - 1e-12), down(down(d)),  down(d), d,
          up(d),   up(up(d)),      d * (1 + 1e-12), d * (1 + 1e-9),  d * (1 + 1e-6), 2 * d};
}

/// Both modes; they must agree.
bool closer(const Facet& facet, const Vector& query, double bound) {
  const bool fast = decide(facet, query, bound, Mode::filtered).closer;
  EXPECT_EQ(fast, decide(facet, query, bound, Mode::exact).closer) << describe({facet, query}, bound);
  return fast;
}

class DecideFamilies : public testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Geometry, DecideFamilies, testing::ValuesIn(all_families),
                         [](const auto& test) { return std::string(name(test.param)); });

TEST_P(DecideFamilies, EveryDecisionAgreesWithTheReference) {
  Maker maker(17);
  std::size_t triangulated = 0, compared = 0, by_filter = 0;
  for (int i = 0; i < 12000; ++i) {
    const Pair pair = maker.make(GetParam());
    // Quads folded onto themselves are beyond the reference; FoldedQuads has them.
    if (GetParam() == Family::degenerate && !pair.facet.triangle && !exact::flat_and_convex(pair.facet)) continue;
    const mpf_class exact = squared_distance(pair.facet, pair.query);
    const double distance = mpf_class(sqrt(exact)).get_d();
    if (distance < 1e-60) continue;
    for (double bound : bounds_around(distance)) {
      const mpf_class square = mpf_class(bound, 600) * bound;
      const bool expected = square - exact > square * 1e-22;  // less is a tie that the reference reached from above
      const Decision fast = decide(pair.facet, pair.query, bound, Mode::filtered);
      const Decision slow = decide(pair.facet, pair.query, bound, Mode::exact);
      ++compared;
      by_filter += fast.stage == Stage::filter ? 1 : 0;
      ASSERT_EQ(fast.closer, slow.closer) << describe(pair, bound);
      if (fast.stage == Stage::triangulated || slow.stage == Stage::triangulated) {
        ++triangulated;
      } else {
        ASSERT_EQ(fast.closer, expected) << describe(pair, bound);
      }
    }
  }
  EXPECT_GT(compared, 50000u);
  EXPECT_GT(by_filter, compared / 3);
  EXPECT_EQ(triangulated, 0u) << "all of these can be decided on the patch";
}

TEST(Decide, FoldedQuadsAgreeWithTheBracket) {
  Maker maker(23);
  for (int i = 0; i < 300; ++i) {
    const Pair pair = maker.make(i % 2 == 0 ? Family::degenerate : Family::skew);
    const Bracket bracket = distance_bracket(pair.facet, pair.query, 2e-3);
    EXPECT_TRUE(closer(pair.facet, pair.query, bracket.high * (1 + 1e-9) + 1e-9));
    EXPECT_FALSE(closer(pair.facet, pair.query, bracket.low * (1 - 1e-9)));
  }
}

TEST_P(DecideFamilies, TheOrderOfTheCornersDoesNotMatter) {
  Maker maker(29);
  for (int i = 0; i < 1500; ++i) {
    const Pair pair = maker.make(GetParam());
    const double distance = std::sqrt(closest_point(pair.facet, pair.query).squared_distance);
    for (double bound : {down(distance), distance, up(distance)}) {
      const Decision first = decide(pair.facet, pair.query, bound, Mode::filtered);
      for (std::size_t turn = 0; turn < (pair.facet.triangle ? 3 : 4); ++turn) {
        const Facet other = rotated(pair.facet, turn);
        ASSERT_EQ(decide(other, pair.query, bound, Mode::filtered).closer, first.closer) << describe(pair, bound);
        ASSERT_EQ(decide(reversed(other), pair.query, bound, Mode::filtered).closer, first.closer)
            << describe(pair, bound);
      }
    }
  }
}

TEST_P(DecideFamilies, QuarterTurnsAndPowersOfTwoDoNotMatter) {
  Maker maker(31);
  const auto turned = [](const Vector& x) { return Vector(-x.y(), x.x(), x.z()); };
  for (int i = 0; i < 1500; ++i) {
    const Pair pair = maker.make(GetParam());
    const double distance = std::sqrt(closest_point(pair.facet, pair.query).squared_distance);
    if (distance < 1e-60) continue;
    const double factor = std::ldexp(1.0, maker.integer(-200, 200));
    for (double bound : {down(distance), distance, up(distance)}) {
      const bool first = decide(pair.facet, pair.query, bound, Mode::filtered).closer;
      Facet other = pair.facet;
      for (Vector& x : other.x) x = turned(x);
      ASSERT_EQ(decide(other, turned(pair.query), bound, Mode::filtered).closer, first) << describe(pair, bound);
      for (Vector& x : other.x) x *= factor;
      ASSERT_EQ(decide(other, factor * turned(pair.query), factor * bound, Mode::filtered).closer, first)
          << describe(pair, bound);
    }
  }
}

TEST(Decide, TranslationsWithoutRoundingDoNotMatter) {
  Maker maker(37);
  for (int i = 0; i < 3000; ++i) {
    const Pair pair = maker.make(Family::lattice);
    const Vector offset(maker.integer(-1000000, 1000000), maker.integer(-1000000, 1000000), 1 << 30);
    Facet moved = pair.facet;
    for (Vector& x : moved.x) x += offset;
    const double distance = std::sqrt(closest_point(pair.facet, pair.query).squared_distance);
    for (double bound : {down(distance), distance, up(distance)}) {
      ASSERT_EQ(closer(moved, pair.query + offset, bound), closer(pair.facet, pair.query, bound))
          << describe(pair, bound);
    }
  }
}

TEST(Decide, TouchingIsNotCloser) {
  const Facet quad{{Vector(0, 0, 0), Vector(4, 0, 0), Vector(4, 4, 0), Vector(0, 4, 0)}, false};
  const Facet triangle{{Vector(0, 0, 0), Vector(4, 0, 0), Vector(4, 4, 0), Vector(4, 4, 0)}, true};
  const Facet saddle{{Vector(0, 0, 1), Vector(4, 0, -1), Vector(4, 4, 1), Vector(0, 4, -1)}, false};
  struct Case {
    Facet facet;
    Vector query;
    double distance;
  };
  const std::vector<Case> cases{{quad, {2, 2, 3}, 3},      {quad, {1, 3, -0.1}, 0.1},    {quad, {7, 2, 4}, 5},
                                {quad, {7, 8, 12}, 13},    {triangle, {3, 1, 3}, 3},     {triangle, {7, 2, 4}, 5},
                                {triangle, {-3, 0, 4}, 5}, {saddle, {2, 2, 0.75}, 0.75}, {saddle, {-2, -3, 7}, 7},
                                {saddle, {4, 4, 1.5}, 0.5}};
  for (const Case& c : cases) {
    const double scaled[] = {1, 0x1p-40, 0x1p40};
    for (double f : scaled) {
      Facet facet = c.facet;
      for (Vector& x : facet.x) x *= f;
      EXPECT_FALSE(closer(facet, f * c.query, f * c.distance)) << describe({facet, f * c.query}, f * c.distance);
      EXPECT_TRUE(closer(facet, f * c.query, f * up(c.distance))) << describe({facet, f * c.query}, f * c.distance);
      EXPECT_FALSE(closer(facet, f * c.query, f * down(c.distance))) << describe({facet, f * c.query}, f * c.distance);
    }
  }
}

TEST(Decide, BoundsThatAreNoDistances) {
  const Facet quad{{Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)}, false};
  for (double bound : {0.0, -0.0, -1.0, -infinity, nan}) EXPECT_FALSE(closer(quad, {0.5, 0.5, 0}, bound));
  EXPECT_TRUE(closer(quad, {0.5, 0.5, 0}, std::numeric_limits<double>::denorm_min()));
  EXPECT_TRUE(closer(quad, {0.5, 0.5, 1e300}, infinity));
  EXPECT_TRUE(closer(quad, {0.5, 0.5, 1}, 1e300));
}

TEST(Decide, HostileNumbers) {
  const double values[] = {0, 1, -1, 1e-320, 5e-324, 1e-160, 1e-31, 1e31, 1e160, 1.7e308, -1.7e308, infinity, nan};
  Maker maker(41);
  const auto any = [&] { return values[maker.integer(0, std::size(values) - 1)]; };
  for (int i = 0; i < 4000; ++i) {
    Pair pair;
    for (Vector& x : pair.facet.x) x = Vector(any(), any(), any());
    pair.query = Vector(any(), any(), any());
    pair.facet.triangle = i % 2 == 0;
    if (pair.facet.triangle) pair.facet.x[3] = pair.facet.x[2];
    bool finite = pair.query.allFinite();
    for (const Vector& x : pair.facet.x) finite = finite && x.allFinite();
    const double bound = any();
    const bool answer = closer(pair.facet, pair.query, bound);
    EXPECT_TRUE(finite || !answer) << describe(pair, bound);
    if (!finite || !pair.facet.triangle || !(bound > 0) || std::isinf(bound)) continue;
    const auto& x = pair.facet.x;
    EXPECT_EQ(answer, squared_distance(x[0], x[1], x[2], pair.query) < mpq_class(bound) * mpq_class(bound))
        << describe(pair, bound);
  }
}

TEST(Decide, SubnormalFacetsAreDecidedExactly) {
  const double u = std::numeric_limits<double>::denorm_min();
  const Facet quad{{Vector(0, 0, 0), Vector(8 * u, 0, 0), Vector(8 * u, 8 * u, 0), Vector(0, 8 * u, 0)}, false};
  EXPECT_FALSE(closer(quad, Vector(4 * u, 4 * u, 3 * u), 3 * u));
  EXPECT_TRUE(closer(quad, Vector(4 * u, 4 * u, 3 * u), 4 * u));
  EXPECT_FALSE(closer(quad, Vector(11 * u, 4 * u, 4 * u), 5 * u));
}

TEST(Decide, HintsChangeNothing) {
  Maker maker(43);
  for (int i = 0; i < 5000; ++i) {
    const Pair pair = maker.make(i % 2 == 0 ? Family::flat : Family::warped);
    ClosestPoint hint = closest_point(pair.facet, pair.query);
    const double distance = std::sqrt(hint.squared_distance);
    for (double bound : {0.9 * distance, distance, 1.1 * distance}) {
      const bool expected = decide(pair.facet, pair.query, bound, Mode::exact).closer;
      EXPECT_EQ(decide(pair.facet, pair.query, bound, Mode::filtered, &hint).closer, expected);
      ClosestPoint wrong = hint;
      wrong.s = maker.uniform(-2, 2);
      wrong.t = i % 7 == 0 ? nan : maker.uniform(-2, 2);
      EXPECT_EQ(decide(pair.facet, pair.query, bound, Mode::filtered, &wrong).closer, expected)
          << describe(pair, bound);
    }
  }
}

TEST(Decide, CountersSayHow) {
  const Facet quad{{Vector(0, 0, 0), Vector(4, 0, 0), Vector(4, 4, 0), Vector(0, 4, 0)}, false};
  DecisionCounters counters;
  EXPECT_TRUE(closer_than(quad, {2, 2, 1}, 2, Mode::filtered, counters));
  EXPECT_FALSE(closer_than(quad, {2, 2, 3}, 2, Mode::filtered, counters));
  EXPECT_EQ(counters.filter, 2u);
  EXPECT_FALSE(closer_than(quad, {2, 2, 2}, 2, Mode::filtered, counters)) << "a tie along an axis";
  EXPECT_TRUE(closer_than(quad, {1, 3, 2}, up(2), Mode::filtered, counters));
  EXPECT_EQ(counters.interval, 2u);
  EXPECT_FALSE(closer_than(quad, {7, 2, 4}, 5, Mode::filtered, counters)) << "a tie of whole numbers beside an edge";
  EXPECT_EQ(counters.interval, 3u);
  const Facet oblique{{Vector(0, 0, 0), Vector(4, -8, 0), Vector(8, -6, -5), Vector(4, 2, -5)}, false};
  EXPECT_FALSE(closer_than(oblique, {6, -2, -0.5}, 3, Mode::filtered, counters)) << "a tie above an oblique face";
  EXPECT_EQ(counters.exact, 1u);
  EXPECT_TRUE(closer_than(quad, {2, 2, 1}, 2, Mode::exact, counters));
  EXPECT_EQ(counters.exact, 2u);
  EXPECT_EQ(counters.triangulated, 0u);
}

TEST(DecideLine, AgreesWithTheReference) {
  Maker maker(47);
  DecisionCounters counters;
  for (int i = 0; i < 20000; ++i) {
    const double size = maker.power_of_ten(-6, 6);
    const Vector offset = (i % 3 == 0 ? maker.power_of_ten(3, 9) : 0.0) * maker.point(1);
    const Vector a = offset + size * maker.point(1), b = i % 11 == 0 ? a : Vector(offset + size * maker.point(1));
    const Vector query =
        offset + (i % 5 == 0 ? Vector(0.5 * (a - offset) + 0.5 * (b - offset)) : Vector(size * maker.point(2)));
    const mpq_class exact = squared_distance(a, b, query);
    const double distance = std::sqrt(exact.get_d());
    for (double bound : bounds_around(distance)) {
      const bool expected = bound > 0 && exact < mpq_class(bound) * mpq_class(bound);
      ASSERT_EQ(closer_than(a, b, query, bound, Mode::filtered, counters), expected) << bound;
      ASSERT_EQ(closer_than(a, b, query, bound, Mode::exact, counters), expected) << bound;
    }
  }
  EXPECT_GT(counters.filter, 100000u);
}

TEST(SideOfPlane, SignOfTheDeterminant) {
  Maker maker(53);
  for (int i = 0; i < 20000; ++i) {
    const Vector a = maker.point(1), b = maker.point(1), c = maker.point(1);
    const double l = maker.uniform(-1, 1), m = maker.uniform(-1, 1);
    const Vector query = i % 2 == 0 ? maker.point(1) : Vector(a + l * (b - a) + m * (c - a));
    std::array<std::array<mpq_class, 3>, 3> d;
    const Vector* const corners[] = {&a, &b, &c};
    for (std::size_t row = 0; row < 3; ++row) {
      for (int k = 0; k < 3; ++k) d[row][k] = mpq_class((*corners[row])[k]) - mpq_class(query[k]);
    }
    const mpq_class det = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                          d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                          d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    ASSERT_EQ(decide_side(a, b, c, query, Mode::filtered).sign, -sgn(det));
    ASSERT_EQ(decide_side(a, b, c, query, Mode::exact).sign, -sgn(det));
    ASSERT_EQ(decide_side(b, a, c, query, Mode::filtered).sign, sgn(det));
  }
  EXPECT_EQ(decide_side({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 1e-300}, Mode::filtered).sign, 1);
  EXPECT_EQ(decide_side({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}, Mode::filtered).sign, 0);
  EXPECT_EQ(decide_side({0, 0, 0}, {1, 0, 0}, {0, nan, 0}, {5, 5, 0}, Mode::filtered).sign, 0);
}

}  // namespace
}  // namespace gapcheck::geometry::test::decide_test
