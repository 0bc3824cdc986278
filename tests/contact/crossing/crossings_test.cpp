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

// Pairs of elements whose boxes meet and that share no node are what the search leaves to decide.
TEST(Crossings, PairsWithBoxesThatMeetAreCounted) {
  const auto pairs = [](std::uint32_t n, bool second) {
    Scene scene;
    scene.plate(scene.part(1, 1), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, n, 1);
    if (second) scene.plate(scene.part(2, 1), {0.5, 0.5, -0.5}, {1, 0, 0}, {0, 0, 1}, n, 1);
    scene.contact("AUTOMATIC_SINGLE_SURFACE");
    SurfaceStore surfaces(scene.model);
    CrossingCounters counters;
    const auto found = find_crossings(scene.model, ContactIndex{0}, surfaces.at(ContactIndex{0}), {}, counters);
    EXPECT_LE(found.size(), counters.box_pairs);
    return counters.box_pairs.load();
  };
  EXPECT_EQ(pairs(1, true), 1U);
  EXPECT_EQ(pairs(3, false), 0U) << "neighbours share nodes, the others are apart";
  EXPECT_EQ(pairs(3, true), 3U + 2U) << "element i of the second is over i and i + 1 of the first";
}

// A sheet through a brick crosses four of its faces alike: one crossing, that with the lowest middle.
TEST(Crossings, OfEquallyLongOnesTheFirstByPosition) {
  std::array<std::size_t, 8> order{0, 1, 2, 3, 4, 5, 6, 7};
  for (int turn = 0; turn < 4; ++turn) {
    Scene scene;
    scene.brick(scene.part(1, 0), {0, 0, 0}, {1, 1, 1});
    auto& nodes = scene.model.mesh.solids.nodes[0];
    const auto before = nodes;
    for (std::size_t i = 0; i < 8; ++i) nodes[i] = before[order[i]];
    std::rotate(order.begin(), order.begin() + 1, order.begin() + 4);
    std::rotate(order.begin() + 4, order.begin() + 5, order.end());
    scene.plate(scene.part(2, 1), {-1, -1, 0.5}, {3, 0, 0}, {0, 3, 0}, 1, 1);
    scene.contact("AUTOMATIC_SINGLE_SURFACE");
    const std::vector<Crossing> found = crossings(scene);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].length(), 1, 1e-12);
    EXPECT_TRUE((0.5 * (found[0].from + found[0].to)).isApprox(Vector(0, 0.5, 0.5))) << turn;
  }
}

/// Meshes whose lines lie in each other: a flat sheet with a line of nodes in x = 0, an upright one with a line of
/// other nodes in z = 0, of one or two rows of elements on each side of that line; turned by an angle about y.
/// `turn`: every other flat element starts at that corner, and from 4 on runs the other way round.
std::size_t along_mesh_lines(int left, int right, int below, int above, double angle, int turn = 0) {
  Scene scene;
  const Vector u(std::cos(angle), 0, std::sin(angle)), w(-std::sin(angle), 0, std::cos(angle)), ey(0, 1, 0);
  const auto rows = [](int low, int high) { return static_cast<std::uint32_t>(low + high); };
  scene.plate(scene.part(1, 1), Vector(-left * u - ey), u, ey, rows(left, right), 2);
  auto& shells = scene.model.mesh.shells.nodes;
  for (std::size_t i = 1; i < shells.size(); i += 2) {
    std::rotate(shells[i].begin(), shells[i].begin() + turn % 4, shells[i].end());
    if (turn >= 4) std::reverse(shells[i].begin(), shells[i].end());
  }
  scene.plate(scene.part(2, 1), Vector(-below * w - ey), w, ey, rows(below, above), 2);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  return crossings(scene).size();
}

TEST(Crossings, AlongMeshLinesOnlyIfBothGoOnBehindThem) {
  for (const double angle : {0.0, 0.3, 2.0, -1.2}) {
    // Two of the flat and two of the upright one meet in each of the two pieces of the line.
    EXPECT_EQ(along_mesh_lines(1, 1, 1, 1, angle), 8U) << angle;
    EXPECT_EQ(along_mesh_lines(2, 2, 2, 2, angle), 8U) << angle;
    EXPECT_EQ(along_mesh_lines(1, 0, 0, 1, angle), 0U) << "an L, " << angle;
    EXPECT_EQ(along_mesh_lines(1, 1, 0, 1, angle), 0U) << "a T, " << angle;
    EXPECT_EQ(along_mesh_lines(0, 1, 1, 1, angle), 0U) << "a T, " << angle;
  }
  for (int turn = 0; turn < 8; ++turn) {
    EXPECT_EQ(along_mesh_lines(1, 1, 1, 1, 0, turn), 8U) << turn;
    EXPECT_EQ(along_mesh_lines(1, 1, 0, 1, 0, turn), 0U) << "a T, " << turn;
    EXPECT_EQ(along_mesh_lines(1, 1, 1, 0, 0, turn), 0U) << "a T, " << turn;
    EXPECT_EQ(along_mesh_lines(1, 0, 0, 1, 0, turn), 0U) << "an L, " << turn;
  }
}

/// Two bricks of 1 and of `size`, the second one at `low`; turned by an angle.
std::size_t two_bricks(const Vector& low, const Vector& size, double angle) {
  Scene scene;
  scene.brick(scene.part(1, 0), {0, 0, 0}, {1, 1, 1});
  scene.brick(scene.part(2, 0), low, size);
  const Eigen::AngleAxisd turn(angle, Vector(1, 2, 3).normalized());
  for (Vector& x : scene.model.mesh.nodes.x) x = turn * x;
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  return crossings(scene).size();
}

// Faces that lie on each other, also with edges in common, are not crossings: bricks that are set on, beside and
// against each other, of the same and of other sizes. A tenth deeper they are.
TEST(Crossings, BricksThatTouchDoNotCross) {
  const Vector same(1, 1, 1);
  for (const double angle : {0.0, 0.7, 2.0, -1.1}) {
    for (const Vector& size : {same, Vector(1, 0.5, 1), Vector(2, 2, 0.5), Vector(0.3, 0.4, 2)})
      for (const Vector& low : {Vector(0, 0, 1), Vector(0.3, 0, 1), Vector(0.3, 0.2, 1), Vector(1, 0, 1),
                                Vector(1, 1, 1), Vector(1, 0, 0), Vector(1, 0.25, -0.5), Vector(-0.5, -0.5, 1)}) {
        EXPECT_EQ(two_bricks(low, size, angle), 0U) << low.transpose() << " of " << size.transpose() << ", " << angle;
        EXPECT_EQ(two_bricks(-low.cwiseProduct(size), size, angle), 0U) << -low.transpose() << ", " << angle;
      }
    for (const Vector& low : {Vector(0.3, 0.2, 0.9), Vector(0.9, 0.3, 0.9), Vector(0.5, -0.5, 0.5)})
      EXPECT_EQ(two_bricks(low, same, angle), 1U) << low.transpose() << ", " << angle;
  }
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

TEST(Crossings, StrangeCoordinatesHurtNoOthers) {
  Scene scene = crumpled(31);
  scene.contact("AUTOMATIC_SINGLE_SURFACE");
  for (std::size_t i = 0; i < scene.model.mesh.nodes.size(); i += 3) {
    const double bad[] = {std::nan(""), 1e300, -std::numeric_limits<double>::infinity(), 0};
    scene.model.mesh.nodes.x[i] = Vector(bad[i % 4], bad[(i / 3) % 4], 1);
  }
  // What the other nodes span crosses as before.
  const auto& x = scene.model.mesh.nodes.x;
  const auto strange = [&](const CrossingSegment& s) {
    return std::any_of(s.nodes.begin(), s.nodes.end(), [&](NodeIndex n) { return n.value % 3 == 0; });
  };
  std::vector<Crossing> before, found = crossings(scene);
  Scene whole = crumpled(31);
  whole.contact("AUTOMATIC_SINGLE_SURFACE");
  before = crossings(whole);
  for (const Crossing& c : found)
    EXPECT_TRUE(c.from.allFinite() && c.to.allFinite()) << c.a.element << ' ' << c.b.element;
  std::erase_if(before, [&](const Crossing& c) { return strange(c.a) || strange(c.b); });
  std::erase_if(found, [&](const Crossing& c) { return strange(c.a) || strange(c.b); });
  EXPECT_TRUE(same(found, before));
  EXPECT_EQ(x.size(), 2U * 169);
}

}  // namespace
}  // namespace gapcheck::contact::crossings_test
