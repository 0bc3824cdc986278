#include "geometry/edge_distance.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "families.hpp"
#include "reference.hpp"

namespace gapcheck::geometry::test::edge_distance_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Exact {
  mpq_class x, y, z;
};
Exact difference(const Vector& a, const Vector& b) {
  return {mpq_class(a.x()) - b.x(), mpq_class(a.y()) - b.y(), mpq_class(a.z()) - b.z()};
}
mpq_class dot(const Exact& a, const Exact& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Squared distance in rational numbers: the quadratic function of the two places is least at its stationary point, or
/// at an end of one of the edges.
mpq_class reference(const Edge& e, const Edge& f) {
  mpq_class best = squared_distance(f[0], f[1], e[0]);
  best = std::min(best, squared_distance(f[0], f[1], e[1]));
  best = std::min(best, squared_distance(e[0], e[1], f[0]));
  best = std::min(best, squared_distance(e[0], e[1], f[1]));
  const Exact u = difference(e[1], e[0]), v = difference(f[1], f[0]), w = difference(f[0], e[0]);
  const mpq_class uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const mpq_class det = uu * vv - uv * uv;
  if (det == 0) return best;
  const mpq_class a = (vv * uw - uv * vw) / det, b = (uv * uw - uu * vw) / det;
  if (a <= 0 || a >= 1 || b <= 0 || b >= 1) return best;
  const mpq_class inside = dot(w, w) + a * a * uu + b * b * vv - 2 * a * uw + 2 * b * vw - 2 * a * b * uv;
  return std::min(best, inside);
}

using Edges = std::pair<Edge, Edge>;

/// Small integers: parallel, crossing, touching and shrunk edges.
Edges lattice(Maker& maker) {
  const auto point = [&] { return Vector(maker.integer(-2, 2), maker.integer(-2, 2), maker.integer(-2, 2)); };
  return {{point(), point()}, {point(), point()}};
}
Edges any(Maker& maker) { return {{maker.point(1), maker.point(1)}, {maker.point(1), maker.point(1)}}; }
/// Crossing at a right angle, more or less, a little apart.
Edges crossing(Maker& maker) {
  const double h = maker.power_of_ten(-12, 0);
  return {{Vector(-1, maker.uniform(-0.5, 0.5), 0), Vector(1, 0, 0)},
          {Vector(0, -1, h), Vector(maker.uniform(-0.5, 0.5), 1, h)}};
}
Edges nearly_parallel(Maker& maker) {
  const Vector a = maker.point(1), b = maker.point(1), shift = maker.point(maker.power_of_ten(-9, 0));
  const double tilt = maker.power_of_ten(-17, -3);
  return {{a, b}, {a + shift + maker.point(tilt), b + shift + maker.point(tilt)}};
}
Edges collinear(Maker& maker) {
  const Vector a = maker.point(1), d = maker.point(1);
  const auto at = [&](int n) { return Vector(a + n * d); };
  return {{at(0), at(maker.integer(0, 4))}, {at(maker.integer(-4, 8)), at(maker.integer(-4, 8))}};
}
Edges far_away(Maker& maker) {
  auto [e, f] = any(maker);
  const Vector shift = maker.point(maker.power_of_ten(3, 9));
  for (Edge* edge : {&e, &f})
    for (Vector& x : *edge) x += shift;
  return {e, f};
}
Edges any_size(Maker& maker) {
  auto [e, f] = any(maker);
  const double factor = maker.power_of_ten(-40, 40);
  for (Edge* edge : {&e, &f})
    for (Vector& x : *edge) x *= factor;
  return {e, f};
}

class EdgeFamilies : public testing::TestWithParam<Edges (*)(Maker&)> {};
INSTANTIATE_TEST_SUITE_P(Geometry, EdgeFamilies,
                         testing::Values(lattice, any, crossing, nearly_parallel, collinear, far_away, any_size));

std::vector<double> bounds_around(double d) {
  const double up = std::nextafter(d, infinity), down = std::nextafter(d, 0.0);
  return {0.5 * d, d * (1 - 1e-9), std::nextafter(down, 0.0), down, d, up, std::nextafter(up, infinity), d * (1 + 1e-9),
          2 * d,   1e-12};
}

TEST_P(EdgeFamilies, EveryDecisionAgreesWithTheReference) {
  Maker maker(5);
  std::size_t by_filter = 0, compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto [e, f] = GetParam()(maker);
    const mpq_class square = reference(e, f);
    for (const double bound : bounds_around(mpf_class(sqrt(mpf_class(square, 600))).get_d())) {
      const bool expected = bound > 0 && mpq_class(bound) * bound > square;
      const Decision fast = decide_edges(e, f, bound, Mode::filtered), slow = decide_edges(e, f, bound, Mode::exact);
      ASSERT_EQ(fast.closer, expected) << e[0] << ' ' << e[1] << ' ' << f[0] << ' ' << f[1] << " bound " << bound;
      ASSERT_EQ(slow.closer, expected);
      ASSERT_EQ(decide_edges(f, e, bound, Mode::filtered).closer, expected);
      by_filter += fast.stage == Stage::filter;
      ++compared;
    }
  }
  // Bounds in the last bits need exact numbers; the others must not.
  if (GetParam() == any) {
    EXPECT_GT(by_filter, compared * 4 / 10);
  }
}

TEST_P(EdgeFamilies, ClosestPointsAreOnTheEdgesAndAsNearAsTheReferenceSays) {
  Maker maker(6);
  for (int i = 0; i < 2000; ++i) {
    const auto [e, f] = GetParam()(maker);
    const EdgesClosest c = closest_points(e, f);
    double size = 0;
    for (const Edge& edge : {e, f})
      for (const Vector& x : edge) size = std::max(size, x.cwiseAbs().maxCoeff());
    const double distance = std::sqrt(reference(e, f).get_d());
    EXPECT_NEAR(std::sqrt(c.squared_distance), distance, 1e-7 * size);
    EXPECT_LE(std::abs(c.s), 1);
    EXPECT_LE(std::abs(c.t), 1);
    EXPECT_LE((c.first - ((1 - c.s) / 2 * e[0] + (1 + c.s) / 2 * e[1])).norm(), 1e-14 * size);
    EXPECT_LE((c.second - ((1 - c.t) / 2 * f[0] + (1 + c.t) / 2 * f[1])).norm(), 1e-14 * size);
    EXPECT_LE(c.squared_distance, c.squared_end_distance);
    if (c.interior) {
      EXPECT_TRUE(std::abs(c.s) < 1 && std::abs(c.t) < 1);
    } else {
      EXPECT_EQ(c.squared_distance, c.squared_end_distance);
    }
  }
}

TEST(EdgeDistance, CrossingEdgesByHand) {
  const Edge e{Vector(0, 0, 0), Vector(4, 0, 0)}, f{Vector(1, -3, 2), Vector(1, 1, 2)};
  const EdgesClosest c = closest_points(e, f);
  EXPECT_TRUE(c.interior);
  EXPECT_DOUBLE_EQ(c.squared_distance, 4);
  EXPECT_DOUBLE_EQ(c.s, -0.5);
  EXPECT_DOUBLE_EQ(c.t, 0.5);
  EXPECT_FALSE(decide_edges(e, f, 2, Mode::filtered).closer);
  EXPECT_TRUE(decide_edges(e, f, std::nextafter(2, 3), Mode::filtered).closer);
}

TEST(EdgeDistance, EndsAndParallelEdgesAreNotInterior) {
  const Edge e{Vector(0, 0, 0), Vector(4, 0, 0)};
  EXPECT_FALSE(closest_points(e, {Vector(4, -1, 1), Vector(4, 1, 1)}).interior);  // over an end
  EXPECT_FALSE(closest_points(e, {Vector(2, 1, 1), Vector(2, 5, 1)}).interior);   // its own end is nearest
  EXPECT_FALSE(closest_points(e, {Vector(1, 0, 1), Vector(3, 0, 1)}).interior);   // parallel
  EXPECT_FALSE(closest_points(e, {Vector(2, 0, 1), Vector(2, 0, 1)}).interior);   // a point
  EXPECT_TRUE(closest_points(e, {Vector(2, -1, 0), Vector(2, 1, 0)}).interior);   // through each other
}

TEST(EdgeDistance, BoundsAndNumbersThatAreNone) {
  const Edge e{Vector(0, 0, 0), Vector(1, 0, 0)}, f{Vector(0, 1, 0), Vector(1, 1, 1)};
  for (const Mode mode : {Mode::filtered, Mode::exact}) {
    for (const double bound : {-1.0, 0.0, nan}) EXPECT_FALSE(decide_edges(e, f, bound, mode).closer);
    EXPECT_TRUE(decide_edges(e, f, infinity, mode).closer);
    for (const double bad : {nan, infinity, -infinity}) {
      EXPECT_FALSE(decide_edges({Vector(bad, 0, 0), Vector(1, 0, 0)}, f, 10, mode).closer);
      EXPECT_FALSE(decide_edges(e, {Vector(0, 1, 0), Vector(0, bad, 0)}, infinity, mode).closer);
      EXPECT_FALSE(closest_points(e, {Vector(0, 1, 0), Vector(0, bad, 0)}).interior);
    }
    EXPECT_TRUE(
        decide_edges({Vector(-1e300, 0, 0), Vector(1e300, 0, 0)}, {Vector(0, 1, 1), Vector(0, 2, 2)}, 2, mode).closer);
  }
}

}  // namespace
}  // namespace gapcheck::geometry::test::edge_distance_test
