#include "contact/crossing/crossings.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "base/parallel.hpp"
#include "contact/scene.hpp"

namespace gapcheck::contact::crossings_test {
namespace {

std::vector<Crossing> crossings(const Scene& scene, const CrossingOptions& options = {}) {
  SurfaceStore surfaces(scene.model);
  CrossingCounters counters;
  const std::vector<ContactIndex> contacts = positions<ContactIndex>(scene.model.contacts.size()).list();
  return find_crossings(scene.model, contacts, surfaces, options, counters);
}

/// A flat grid of elements: corner, two sides of an element, numbers of elements.
struct Grid {
  Vector corner, u, v;
  std::uint32_t n, m;
  /// The piece of the straight line x + s d, in the grid's plane, over element (i, j): an interval of s, or low > high.
  [[nodiscard]] std::pair<double, double> piece(const Vector& x, const Vector& d, std::uint32_t i,
                                                std::uint32_t j) const {
    double low = -1e300, high = 1e300;
    for (const auto& [side, place] : {std::pair(u, i), std::pair(v, j)}) {
      const double at = (x - corner).dot(side) / side.squaredNorm() - place, slope = d.dot(side) / side.squaredNorm();
      const double s0 = -at / slope, s1 = (1 - at) / slope;
      low = std::max(low, std::min(s0, s1));
      high = std::min(high, std::max(s0, s1));
    }
    return {low, high};
  }
};

/// Pairs of elements that cross: the planes' common line cut by both rectangles.
std::size_t expected(const Grid& a, const Grid& b, double& total) {
  const Vector na = a.u.cross(a.v).normalized(), nb = b.u.cross(b.v).normalized(), d = na.cross(nb).normalized();
  Eigen::Matrix3d rows;
  rows << na.transpose(), nb.transpose(), d.transpose();
  const Vector x = rows.fullPivLu().solve(Vector(na.dot(a.corner), nb.dot(b.corner), 0));
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < a.n * a.m; ++i)
    for (std::uint32_t j = 0; j < b.n * b.m; ++j) {
      const auto [low_a, high_a] = a.piece(x, d, i % a.n, i / a.n);
      const auto [low_b, high_b] = b.piece(x, d, j % b.n, j / b.n);
      const double length = std::min(high_a, high_b) - std::max(low_a, low_b);
      if (length <= 0) continue;
      ++count;
      total += length;
    }
  return count;
}

TEST(Crossings, FlatGridsInAnyPosition) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vector(unit(random), unit(random), unit(random)); };
  std::size_t all = 0;
  for (int trial = 0; trial < 60; ++trial) {
    std::array<Grid, 2> grids;
    Scene scene;
    for (Grid& g : grids) {
      g.u = vector().normalized();
      g.v = 0.7 * g.u.cross(vector()).normalized();
      g.n = 6;
      g.m = 9;
      g.corner = vector() - 0.5 * (g.n * g.u + g.m * g.v);
      scene.plate(scene.part(&g - grids.data() + 1, 1), g.corner, g.u, g.v, g.n, g.m);
    }
    scene.contact("AUTOMATIC_SINGLE_SURFACE");
    double length = 0, found_length = 0;
    const std::size_t count = expected(grids[0], grids[1], length);
    const std::vector<Crossing> found = crossings(scene, {.tolerance = 1e-12});
    for (const Crossing& c : found) found_length += c.length();
    EXPECT_EQ(found.size(), count) << trial;
    EXPECT_NEAR(found_length, length, 1e-9);
    all += count;
  }
  EXPECT_GT(all, 300U);
}

/// Crumpled sheets: warped quads, many crossings with themselves and each other.
Scene crumpled(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  Scene scene;
  for (int p = 0; p < 2; ++p) scene.plate(scene.part(p + 1, 1), {0, 0, 0.3 * p}, {1, 0, 0}, {0, 1, 0}, 12, 12);
  for (Vector& x : scene.model.mesh.nodes.x) x += Vector(0.6 * unit(random), 0.6 * unit(random), 0.9 * unit(random));
  return scene;
}

bool same(const std::vector<Crossing>& l, const std::vector<Crossing>& r) {
  return std::equal(l.begin(), l.end(), r.begin(), r.end(), [](const Crossing& a, const Crossing& b) {
    return a.contact == b.contact && a.a.element == b.a.element && a.b.element == b.b.element && a.from == b.from &&
           a.to == b.to && a.depth == b.depth;
  });
}

TEST(Crossings, SlowTwinsAndOneThreadSayTheSame) {
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    Scene scene = crumpled(seed);
    scene.contact("AUTOMATIC_SINGLE_SURFACE");
    const std::vector<Crossing> fast = crossings(scene);
    EXPECT_GT(fast.size(), 50U);
    EXPECT_TRUE(same(fast, crossings(scene, {geometry::Mode::exact, BoxSearch::tree})));
    EXPECT_TRUE(same(fast, crossings(scene, {geometry::Mode::filtered, BoxSearch::brute_force})));
    const JobLimit one(1);
    EXPECT_TRUE(same(fast, crossings(scene)));
  }
}

TEST(Crossings, TwoSidesSeeTheirPairsOfTheSingleSurface) {
  Scene both = crumpled(20);
  both.contact("AUTOMATIC_SURFACE_TO_SURFACE").a = {1, 3, 0, true};
  both.model.contacts[0].b = {2, 3, 0, true};
  Scene single = crumpled(20);
  single.contact("AUTOMATIC_SINGLE_SURFACE");
  std::vector<Crossing> of_single = crossings(single);
  std::erase_if(of_single, [](const Crossing& c) { return c.a.part == c.b.part; });
  EXPECT_GT(of_single.size(), 10U);
  EXPECT_TRUE(same(crossings(both), of_single));
}

TEST(Crossings, FarFromTheOriginAndInOtherUnits) {
  // Quarters survive the translation without rounding, a power of two the scaling.
  const auto at = [](double scale, const Vector& offset) {
    Scene scene;
    scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4, 4);
    scene.plate(scene.part(2, 1), {0.25, 0.5, -1.25}, {1, 0.25, 0}, {0.25, 0, 1}, 3, 3);
    for (Vector& x : scene.model.mesh.nodes.x) x = scale * x + offset;
    scene.contact("AUTOMATIC_SINGLE_SURFACE");
    return crossings(scene).size();
  };
  const std::size_t count = at(1, Vector::Zero());
  EXPECT_GT(count, 3U);
  EXPECT_EQ(at(1, {1e6, -3e7, 2e5}), count);
  EXPECT_EQ(at(0x1p-40, Vector::Zero()), count);
  EXPECT_EQ(at(0x1p60, Vector::Zero()), count);
}

TEST(Crossings, StrangeCoordinatesCrossNothing) {
  Scene scene = crumpled(31);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  for (std::size_t i = 0; i < scene.model.mesh.nodes.size(); i += 3) {
    const double bad[] = {std::nan(""), 1e300, -std::numeric_limits<double>::infinity(), 0};
    scene.model.mesh.nodes.x[i] = Vector(bad[i % 4], bad[(i / 3) % 4], 1);
  }
  const std::vector<Crossing> found = crossings(scene);
  for (const Crossing& c : found) EXPECT_TRUE(c.length() >= 0);
}

}  // namespace
}  // namespace gapcheck::contact::crossings_test
