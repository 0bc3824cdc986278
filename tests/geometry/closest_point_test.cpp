#include "geometry/closest_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "families.hpp"
#include "geometry/exact.hpp"
#include "reference.hpp"

namespace gapcheck::geometry::test::closest_point_test {
namespace {

const Facet square{{Vector(-1, -1, 0), Vector(1, -1, 0), Vector(1, 1, 0), Vector(-1, 1, 0)}, false};
const Facet triangle{{Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 4, 0), Vector(0, 4, 0)}, true};

double size_of(const Pair& pair) {
  double size = 0;
  for (const Vector& x : pair.facet.x) size = std::max(size, (x - pair.query).norm());
  return size;
}

Vector at(const Facet& facet, double s, double t) {
  const auto& x = facet.x;
  return 0.25 *
         ((1 - s) * (1 - t) * x[0] + (1 + s) * (1 - t) * x[1] + (1 + s) * (1 + t) * x[2] + (1 - s) * (1 + t) * x[3]);
}

class ClosestPointFamilies : public testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Geometry, ClosestPointFamilies, testing::ValuesIn(all_families),
                         [](const auto& test) { return std::string(name(test.param)); });

TEST_P(ClosestPointFamilies, DistanceAgreesWithTheReference) {
  Maker maker(101);
  for (int i = 0; i < 12000; ++i) {
    const Pair pair = maker.make(GetParam());
    if (GetParam() == Family::degenerate && !pair.facet.triangle && !exact::flat_and_convex(pair.facet)) continue;
    const double expected = mpf_class(sqrt(squared_distance(pair.facet, pair.query))).get_d();
    const double found = std::sqrt(closest_point(pair.facet, pair.query).squared_distance);
    ASSERT_NEAR(found, expected, 1e-9 * expected + 1e-14 * size_of(pair)) << describe(pair);
  }
}

TEST(ClosestPoint, FoldedQuadsAgreeWithTheBracket) {
  Maker maker(103);
  for (int i = 0; i < 300; ++i) {
    const Pair pair = maker.make(i % 2 == 0 ? Family::degenerate : Family::skew);
    const Bracket bracket = distance_bracket(pair.facet, pair.query, 2e-3);
    const double found = std::sqrt(closest_point(pair.facet, pair.query).squared_distance);
    EXPECT_GE(found, bracket.low - 1e-12) << describe(pair);
    EXPECT_LE(found, bracket.high + 1e-9) << describe(pair);
  }
}

TEST_P(ClosestPointFamilies, TheFieldsBelongTogether) {
  Maker maker(107);
  for (int i = 0; i < 5000; ++i) {
    const Pair pair = maker.make(GetParam());
    const ClosestPoint c = closest_point(pair.facet, pair.query);
    double reach = pair.query.norm();
    for (const Vector& x : pair.facet.x) reach = std::max(reach, x.norm());
    const double slack = 1e-14 * reach;
    ASSERT_LE(std::abs(c.s), 1);
    ASSERT_LE(std::abs(c.t), 1);
    ASSERT_LE((at(pair.facet, c.s, c.t) - c.point).norm(), slack) << describe(pair);
    ASSERT_NEAR((pair.query - c.point).norm(), std::sqrt(c.squared_distance), slack) << describe(pair);
    ASSERT_NEAR(c.gap, c.normal.dot(pair.query - c.point), slack) << describe(pair);
    ASSERT_TRUE(c.normal.isZero(0) || std::abs(c.normal.norm() - 1) < 1e-12) << describe(pair);
    ASSERT_TRUE(std::isfinite(c.free_s) && std::isfinite(c.free_t)) << describe(pair);
    if (c.feature == Feature::face) {
      ASSERT_TRUE(c.s == c.free_s && c.t == c.free_t && c.in_band) << describe(pair);
    } else if (c.feature == Feature::corner) {
      ASSERT_EQ(c.point, pair.facet.x[c.feature_index]);
    } else {
      const auto& x = pair.facet.x;
      const double line =
          closest_point_on_line(x[c.feature_index], x[(c.feature_index + 1u) % 4], pair.query).squared_distance;
      ASSERT_NEAR(std::sqrt(line), std::sqrt(c.squared_distance), slack) << describe(pair);
    }
  }
}

TEST_P(ClosestPointFamilies, CornerOrderTurnsOnlyWhatItMust) {
  Maker maker(109);
  for (int i = 0; i < 3000; ++i) {
    const Pair pair = maker.make(GetParam());
    const double slack = 1e-9 * size_of(pair);
    const ClosestPoint c = closest_point(pair.facet, pair.query);
    const ClosestPoint turned = closest_point(rotated(pair.facet, 1), pair.query);
    const ClosestPoint back = closest_point(reversed(pair.facet), pair.query);
    ASSERT_NEAR(std::sqrt(turned.squared_distance), std::sqrt(c.squared_distance), slack) << describe(pair);
    ASSERT_NEAR(std::sqrt(back.squared_distance), std::sqrt(c.squared_distance), slack) << describe(pair);
    // Points and normals jump where two points are equally near, so only the plain families can ask for them.
    if (GetParam() != Family::flat && GetParam() != Family::lattice && GetParam() != Family::any_size) continue;
    ASSERT_NEAR(turned.gap, c.gap, slack) << describe(pair);
    ASSERT_NEAR(back.gap, -c.gap, slack) << describe(pair);
    ASSERT_EQ(turned.in_band, c.in_band) << describe(pair);
  }
}

TEST(ClosestPoint, FeaturesOfASquare) {
  struct Case {
    Vector query, point;
    Feature feature;
    int index;
    double free_s, free_t;
  };
  const Case cases[] = {{{0.25, -0.5, 3}, {0.25, -0.5, 0}, Feature::face, 0, 0.25, -0.5},
                        {{0.5, -3, 1}, {0.5, -1, 0}, Feature::edge, 0, 0.5, -3},
                        {{3, 0.5, -1}, {1, 0.5, 0}, Feature::edge, 1, 3, 0.5},
                        {{0.5, 3, 1}, {0.5, 1, 0}, Feature::edge, 2, 0.5, 3},
                        {{-3, 0.5, 1}, {-1, 0.5, 0}, Feature::edge, 3, -3, 0.5},
                        {{-2, -3, 1}, {-1, -1, 0}, Feature::corner, 0, -2, -3},
                        {{2, -3, 1}, {1, -1, 0}, Feature::corner, 1, 2, -3},
                        {{2, 3, 1}, {1, 1, 0}, Feature::corner, 2, 2, 3},
                        {{-2, 3, 1}, {-1, 1, 0}, Feature::corner, 3, -2, 3},
                        {{1, 0, 2}, {1, 0, 0}, Feature::edge, 1, 1, 0}};
  for (const Case& c : cases) {
    const ClosestPoint found = closest_point(square, c.query);
    EXPECT_EQ(found.point, c.point);
    EXPECT_EQ(found.feature, c.feature);
    if (c.feature != Feature::face) {
      EXPECT_EQ(int{found.feature_index}, c.index);
    }
    EXPECT_EQ(found.free_s, c.free_s);
    EXPECT_EQ(found.free_t, c.free_t);
    EXPECT_EQ(found.normal, Vector::UnitZ());
    EXPECT_EQ(found.gap, c.query.z());
    EXPECT_EQ(found.squared_distance, (c.query - c.point).squaredNorm());
  }
}

TEST(ClosestPoint, FeaturesOfATriangle) {
  struct Case {
    Vector query, point;
    Feature feature;
    int index;
  };
  const Case cases[] = {{{1, 1, 2}, {1, 1, 0}, Feature::face, 0},     {{1, -1, 2}, {1, 0, 0}, Feature::edge, 0},
                        {{3, 3, -1}, {2, 2, 0}, Feature::edge, 1},    {{-1, 1, 2}, {0, 1, 0}, Feature::edge, 3},
                        {{-1, -1, 2}, {0, 0, 0}, Feature::corner, 0}, {{9, -1, 2}, {4, 0, 0}, Feature::corner, 1},
                        {{-1, 9, 2}, {0, 4, 0}, Feature::corner, 2}};
  for (const Case& c : cases) {
    const ClosestPoint found = closest_point(triangle, c.query);
    EXPECT_EQ(found.point, c.point);
    EXPECT_EQ(found.feature, c.feature);
    if (c.feature != Feature::face) {
      EXPECT_EQ(int{found.feature_index}, c.index);
    }
    EXPECT_EQ(found.gap, c.query.z());
    EXPECT_LT((at(triangle, found.s, found.t) - c.point).norm(), 1e-15);
  }
  const ClosestPoint centre = closest_point(triangle, {1, 1, 5});  // barycentric 1/2, 1/4, 1/4
  EXPECT_DOUBLE_EQ(centre.t, -0.5);
  EXPECT_DOUBLE_EQ(centre.s, -1.0 / 3);
}

TEST(ClosestPoint, TheBandIsInclusive) {
  EXPECT_TRUE(closest_point(square, {1.5, 0, 1}).in_band);
  EXPECT_TRUE(closest_point(square, {-1.5, 1.5, 1}).in_band);
  EXPECT_FALSE(closest_point(square, {1.5 + 1e-6, 0, 1}).in_band);
  EXPECT_FALSE(closest_point(square, {0, -1.51, 1}).in_band);
  EXPECT_TRUE(closest_point(square, {1, 1, 1}, 0).in_band);
  EXPECT_FALSE(closest_point(square, {1.001, 1, 1}, 0).in_band);
  EXPECT_TRUE(closest_point(square, {2, 0, 1}, 1).in_band);
  EXPECT_TRUE(closest_point(triangle, {-1, 1, 2}).in_band);
  EXPECT_FALSE(closest_point(triangle, {-1.0001, 1, 2}).in_band);
  EXPECT_TRUE(closest_point(triangle, {1, -1, 2}).in_band);
  EXPECT_TRUE(closest_point(triangle, {2.5, 2.5, 2}).in_band);
  EXPECT_FALSE(closest_point(triangle, {2.501, 2.501, 2}).in_band);
}

/// Far beyond the edges of strongly warped quads there may be no stationary point; then the mean plane stands in.
TEST(ClosestPoint, TheFreeProjectionIsStationary) {
  Maker maker(113);
  int outside = 0, stationary = 0;
  for (int i = 0; i < 10000; ++i) {
    const Pair pair = maker.make(Family::warped);
    const ClosestPoint c = closest_point(pair.facet, pair.query);
    if (std::max(std::abs(c.free_s), std::abs(c.free_t)) > 1.6) continue;
    const double step = 1e-4;
    const auto value = [&](double s, double t) { return (at(pair.facet, s, t) - pair.query).squaredNorm(); };
    const double slope_s = (value(c.free_s + step, c.free_t) - value(c.free_s - step, c.free_t)) / (2 * step);
    const double slope_t = (value(c.free_s, c.free_t + step) - value(c.free_s, c.free_t - step)) / (2 * step);
    const bool flat = std::abs(slope_s) + std::abs(slope_t) < 1e-6;
    EXPECT_TRUE(flat || c.feature != Feature::face) << describe(pair);
    outside += c.feature != Feature::face ? 1 : 0;
    stationary += c.feature != Feature::face && flat ? 1 : 0;
  }
  EXPECT_GT(outside, 1000);
  EXPECT_GT(stationary, 0.97 * outside);
}

TEST(ClosestPoint, BeyondTheFoldOfATrapezoid) {
  // The sides meet at t = 11/9: a node far beyond is out of the band, although no parameters lead to it.
  const Facet trapezoid{{Vector(-1, -1, 0), Vector(1, -1, 0), Vector(0.1, 1, 0), Vector(-0.1, 1, 0)}, false};
  EXPECT_TRUE(closest_point(trapezoid, {0, 1.1, 0.2}).in_band);
  EXPECT_FALSE(closest_point(trapezoid, {0, 5, 0.2}).in_band);
  EXPECT_FALSE(closest_point(trapezoid, {3, 5, 0.2}).in_band);
  EXPECT_EQ(closest_point(trapezoid, {0, 5, 0}).squared_distance, 16);
}

TEST(ClosestPoint, FacetsWithoutAreaGiveTheNearestEdge) {
  const Vector a(1, 2, 3), b(4, 6, 3);
  const Facet line{{a, b, b, a}, false}, dot{{a, a, a, a}, false},
      flat_triangle{{a, b, 0.5 * (a + b), 0.5 * (a + b)}, true};
  for (const Facet& facet : {line, flat_triangle}) {
    const ClosestPoint c = closest_point(facet, a + 0.25 * (b - a) + Vector(0, 0, 2));
    EXPECT_NEAR(c.squared_distance, 4, 1e-14);
    EXPECT_EQ(c.feature, Feature::edge);
    EXPECT_EQ(c.normal, Vector::Zero());
    EXPECT_EQ(c.gap, 0);
    EXPECT_TRUE(c.in_band);
  }
  EXPECT_EQ(closest_point(dot, a + Vector(0, 3, 4)).squared_distance, 25);
  EXPECT_EQ(closest_point(dot, a).squared_distance, 0);
}

TEST(ClosestPoint, ACollapsedEdgeTakesTheMeanNormal) {
  const Facet facet{{Vector(0, 0, 0), Vector(1, 0, 0), Vector(0.5, 1, 0), Vector(0.5, 1, 0)}, false};
  const ClosestPoint c = closest_point(facet, {0.5, 3, 1});
  EXPECT_EQ(c.point, Vector(0.5, 1, 0));
  EXPECT_LT((c.normal - Vector::UnitZ()).norm(), 1e-15);
}

TEST(ClosestPoint, FiniteNumbersGiveFiniteResults) {
  const double values[] = {0, 1, -1, 1e-320, 5e-324, -1e-160, 1e-31, 1e31, -1e150};
  Maker maker(127);
  const auto any = [&] { return values[maker.integer(0, std::size(values) - 1)]; };
  for (int i = 0; i < 20000; ++i) {
    Pair pair;
    for (Vector& x : pair.facet.x) x = Vector(any(), any(), any());
    pair.query = Vector(any(), any(), any());
    pair.facet.triangle = i % 2 == 0;
    if (pair.facet.triangle) pair.facet.x[3] = pair.facet.x[2];
    const ClosestPoint c = closest_point(pair.facet, pair.query);
    EXPECT_TRUE(c.point.allFinite() && c.normal.allFinite() && std::isfinite(c.squared_distance) &&
                std::isfinite(c.gap))
        << describe(pair);
    EXPECT_TRUE(std::abs(c.s) <= 1 && std::abs(c.t) <= 1 && std::isfinite(c.free_s) && std::isfinite(c.free_t))
        << describe(pair);
  }
}

TEST(ClosestPoint, NumbersThatAreNotFiniteAreFarAway) {
  const double bad[] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
  for (double value : bad) {
    Facet facet = square;
    facet.x[2].y() = value;
    for (const ClosestPoint& c : {closest_point(facet, {0, 0, 0}), closest_point(square, {0, value, 0})}) {
      EXPECT_TRUE(std::isinf(c.squared_distance));
      EXPECT_FALSE(c.in_band);
    }
  }
}

TEST(ClosestPointOnLine, ClosedForms) {
  const Vector a(0, 0, 0), b(4, 0, 0);
  const LineClosest inside = closest_point_on_line(a, b, {1, 3, 0});
  EXPECT_EQ(inside.point, Vector(1, 0, 0));
  EXPECT_EQ(inside.squared_distance, 9);
  EXPECT_EQ(inside.s, -0.5);
  EXPECT_EQ(inside.free_s, -0.5);
  const LineClosest beyond = closest_point_on_line(a, b, {6, 0, 1});
  EXPECT_EQ(beyond.point, b);
  EXPECT_EQ(beyond.squared_distance, 5);
  EXPECT_EQ(beyond.s, 1);
  EXPECT_EQ(beyond.free_s, 2);
  const LineClosest dot = closest_point_on_line(a, a, {0, 2, 0});
  EXPECT_EQ(dot.point, a);
  EXPECT_EQ(dot.squared_distance, 4);
}

}  // namespace
}  // namespace gapcheck::geometry::test::closest_point_test
