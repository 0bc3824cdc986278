#include "contact/crossing/heights_over.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>
#include <vector>

namespace gapcheck::contact::heights_over_test {
namespace {

using geometry::Triangle;

/// The slow twin: the heights of all points where a linear function may be extreme on the part of a triangle within a
/// prism. These are its corners, where its edges pass the prism's sides, and where the prism's edges pass it.
Heights slow_heights(const Triangle& base, const Triangle& t, double slack, const Vector& up) {
  Vector normal = (base[1] - base[0]).cross(base[2] - base[0]).normalized();
  std::array<Vector, 3> inward;
  for (std::size_t i = 0; i < 3; ++i) inward[i] = normal.cross(base[(i + 1) % 3] - base[i]).normalized();
  if (normal.dot(up) < 0) normal = -normal;
  const auto beside = [&](std::size_t i, const Vector& x) { return inward[i].dot(x - base[i]) + slack; };
  std::vector<Vector> points(t.begin(), t.end());
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector &p = t[k], &q = t[(k + 1) % 3];
      const double a = beside(i, p), b = beside(i, q);
      if ((a < 0) != (b < 0)) points.emplace_back(p + a / (a - b) * (q - p));
    }
  for (std::size_t i = 0; i < 3; ++i) {
    // The edge of the prism between the sides i and k, through the plane of t: a system of three planes.
    const std::size_t k = (i + 1) % 3;
    const Vector own = (t[1] - t[0]).cross(t[2] - t[0]);
    Eigen::Matrix3d rows;
    rows << inward[i].transpose(), inward[k].transpose(), own.transpose();
    const Vector x =
        rows.fullPivLu().solve(Vector(inward[i].dot(base[i]) - slack, inward[k].dot(base[k]) - slack, own.dot(t[0])));
    const bool in_t = own.dot((t[1] - t[0]).cross(x - t[0])) >= 0 && own.dot((t[2] - t[1]).cross(x - t[1])) >= 0 &&
                      own.dot((t[0] - t[2]).cross(x - t[2])) >= 0;
    if (in_t) points.push_back(x);
  }
  Heights heights;
  for (const Vector& x : points) {
    if (beside(0, x) < -1e-9 || beside(1, x) < -1e-9 || beside(2, x) < -1e-9) continue;
    heights.low = std::min(heights.low, normal.dot(x - base[0]));
    heights.high = std::max(heights.high, normal.dot(x - base[0]));
  }
  return heights;
}

TEST(HeightsOver, ByHand) {
  const Vector up = Vector::UnitZ();
  const Triangle base{Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 4, 0)};
  const auto expect = [&](const Triangle& t, double slack, const Vector& above, double low, double high) {
    const Heights heights = heights_over(base, t, slack, above);
    EXPECT_NEAR(heights.low, low, 1e-12);
    EXPECT_NEAR(heights.high, high, 1e-12);
  };
  const Triangle over{Vector(1, 1, 2), Vector(2, 1, 3), Vector(1, 2, -1)};
  expect(over, 0, up, -1, 3);
  expect(over, 0, -up, -3, 1);
  // A wall above y = 1 that rises by 1 along x from x = -2 on: over the base it starts at x = 0 and ends at x = 3.
  const Triangle wall{Vector(-2, 1, 0), Vector(8, 1, 10), Vector(8, 1, 0)};
  expect(wall, 0, up, 0, 5);
  expect(wall, 0.5, up, 0, 5 + 0.5 * std::sqrt(2.0));
  const Triangle beside{Vector(5, 5, 2), Vector(6, 5, 3), Vector(5, 6, 1)};
  expect(beside, 0, up, 0, 0);
  expect(beside, 6 / std::sqrt(2.0), up, 0, 2);
}

// Triangles one after the other, as a surface has them.
TEST(HeightsOver, AgreeWithTheExtremesOfAllCornersAndCuts) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vector(unit(random), unit(random), unit(random)); };
  std::vector<Triangle> bases, others;
  for (int i = 0; i < 60; ++i) {
    bases.push_back({vector(), vector(), vector()});
    others.push_back({vector(), vector(), vector()});
  }
  std::size_t met = 0;
  for (const Triangle& base : bases)
    for (const Triangle& t : others)
      for (const double slack : {0.0, 0.1}) {
        const Vector up = Vector::UnitX();
        const Heights heights = heights_over(base, t, slack, up), slow = slow_heights(base, t, slack, up);
        EXPECT_NEAR(heights.low, slow.low, 1e-9);
        EXPECT_NEAR(heights.high, slow.high, 1e-9);
        met += slow.low < slow.high ? 1 : 0;
      }
  EXPECT_GT(met, 3000u);
}

TEST(HeightsOver, TrianglesWithoutAnAreaHaveNone) {
  const Vector p(1, 2, 3);
  const Triangle point{p, p, p}, base{Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 4, 0)};
  const Heights over_point = heights_over(point, base, 0, Vector::UnitZ());
  EXPECT_EQ(over_point.low, 0);
  EXPECT_EQ(over_point.high, 0);
  EXPECT_EQ(heights_over(base, point, 0, Vector::UnitZ()).high, 3);
}

}  // namespace
}  // namespace gapcheck::contact::heights_over_test
