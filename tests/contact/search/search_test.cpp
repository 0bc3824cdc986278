#include "contact/search/search.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <random>
#include <set>

namespace gapcheck::contact::search_test {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Pairs pairs(const CandidateSearch& search, const std::vector<Vector>& points, const std::vector<Bounds>& boxes) {
  Pairs found;
  std::mutex mutex;
  search.run(points, boxes, [&](std::uint32_t box, std::span<const std::uint32_t> inside) {
    const std::lock_guard lock(mutex);
    for (const std::uint32_t p : inside) EXPECT_TRUE(found.emplace(box, p).second) << "pair reported twice";
  });
  return found;
}

Bounds around(const Vector& centre, double half) {
  return {centre - Vector::Constant(half), centre + Vector::Constant(half)};
}

void expect_same(const std::vector<Vector>& points, const std::vector<Bounds>& boxes) {
  const Pairs expected = pairs(*make_brute_force(), points, boxes);
  for (const SearchKind kind : {SearchKind::bucket_grid, SearchKind::sorted_sweep, SearchKind::box_tree}) {
    const auto search = make_search(kind);
    EXPECT_EQ(pairs(*search, points, boxes), expected) << search->name();
  }
}

TEST(Search, AgreesWithBruteForceOnRandomScenes) {
  std::mt19937_64 random(7);
  for (int scene = 0; scene < 60; ++scene) {
    // Positions and sizes over several decades: mixed meshes, thin slabs, clusters.
    std::uniform_real_distribution<double> unit(-1, 1), decade(-4, 3);
    const double spread = std::pow(10, decade(random));
    std::vector<Vector> points;
    for (int i = 0; i < 400; ++i) {
      const double cluster = i % 3 == 0 ? 1e-3 : 1;
      points.push_back(spread * cluster * Vector(unit(random), unit(random), scene % 4 == 0 ? 0 : unit(random)));
    }
    std::vector<Bounds> boxes;
    for (int i = 0; i < 200; ++i) {
      const Vector centre = spread * Vector(unit(random), unit(random), unit(random));
      boxes.push_back(
          around(i % 2 == 0 ? centre : points[static_cast<std::size_t>(i)], spread * std::pow(10, decade(random) - 2)));
    }
    expect_same(points, boxes);
  }
}

TEST(Search, NextAboveIsThatOfTheStandard) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const auto expect_next = [](double x) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(next_above(x)), std::bit_cast<std::uint64_t>(std::nextafter(x, inf))) << x;
  };
  using Limits = std::numeric_limits<double>;
  for (const double x : {0.0, 1.0, Limits::denorm_min(), Limits::min(), Limits::max(), inf}) {
    expect_next(x);
    expect_next(-x);
  }
  EXPECT_TRUE(std::isnan(next_above(Limits::quiet_NaN())));
  std::mt19937_64 random(3);
  for (int i = 0; i < 100'000; ++i)
    if (const auto x = std::bit_cast<double>(random()); !std::isnan(x)) expect_next(x);
  const Bounds box = grown({{-1, 0, 5}, {1, 0, 5}}, 2);
  EXPECT_TRUE(box.low == Vector(std::nextafter(-3, -inf), std::nextafter(-2, -inf), std::nextafter(3, -inf)));
  EXPECT_TRUE(box.high == Vector(std::nextafter(3, inf), std::nextafter(2, inf), std::nextafter(7, inf)));
}

TEST(Search, CornersOfBoxesCount) {
  const std::vector<Vector> points{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  expect_same(points, {Bounds{{1, 1, 1}, {2, 2, 2}}, Bounds{{2, 2, 2}, {2, 2, 2}}});
  for (const SearchKind kind : all_searches)
    EXPECT_EQ(pairs(*make_search(kind), points, {Bounds{{1, 1, 1}, {2, 2, 2}}}).size(), 2U);
}

TEST(Search, HandlesOnePointManyEqualPointsAndNothing) {
  expect_same({{5, 5, 5}}, {around({5, 5, 5}, 1), around({9, 9, 9}, 1)});
  expect_same(std::vector<Vector>(300, Vector(1, 2, 3)), {around({1, 2, 3}, 0), around({1, 2, 3.5}, 0.4)});
  for (const SearchKind kind : all_searches) {
    EXPECT_TRUE(pairs(*make_search(kind), {}, {around({0, 0, 0}, 1)}).empty());
    EXPECT_TRUE(pairs(*make_search(kind), {{0, 0, 0}}, {}).empty());
    EXPECT_TRUE(pairs(*make_search(kind), {{0, 0, 0}}, {Bounds{}}).empty());
  }
}

TEST(Search, StrayPointAndHugeBox) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(0, 100);
  std::vector<Vector> points{{150000, 0, 0}};
  for (int i = 0; i < 2000; ++i) points.emplace_back(unit(random), unit(random), 0.01 * unit(random));
  std::vector<Bounds> boxes{around({50, 50, 0}, 1000), around({150000, 0, 0}, 1), around({0, 0, 0}, 1e9)};
  for (int i = 0; i < 300; ++i) boxes.push_back(around({unit(random), unit(random), 0}, 2));
  expect_same(points, boxes);
}

TEST(Search, PointsAtAbsurdDistancesOnlyFillTheRim) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> unit(0, 100);
  std::vector<Vector> points;
  for (int i = 0; i < 3000; ++i) points.emplace_back(unit(random), unit(random), 0);
  for (const double far : {1e12, -1e20, 1e29}) points.emplace_back(far, far / 2, -far);
  std::vector<Bounds> boxes{around(points[3000], 1), around({50, 50, 0}, 1e13), around({-300, 50, 0}, 10),
                            Bounds{{-1e30, 0, -1e30}, {1e30, 100, 1e30}}};
  for (int i = 0; i < 300; ++i) boxes.push_back(around({unit(random), unit(random), 0}, 2));
  expect_same(points, boxes);
}

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

/// A cloud of points, with as many of every hostile kind put among them.
std::vector<Vector> hostile_points(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 100);
  std::vector<Vector> points;
  for (int i = 0; i < 2500; ++i) {
    points.emplace_back(unit(random), unit(random), 0.01 * unit(random));
    if (i % 50 != 0) continue;
    for (const double strange : {nan, infinity, -infinity, 1e300, -1e300, 1e-300, -0.0, 1e38, 1e39}) {
      Vector x(unit(random), unit(random), unit(random));
      x[i / 50 % 3] = strange;
      points.push_back(x);
    }
    points.emplace_back(50, 50, 0.5);
  }
  return points;
}

TEST(Search, StrangeNumbersAreLeftOutOrWhereTheySay) {
  std::mt19937_64 random(17);
  const std::vector<Vector> points = hostile_points(random);
  std::uniform_real_distribution<double> unit(0, 100);
  std::vector<Bounds> boxes{Bounds{},
                            Bounds{Vector::Constant(nan), Vector::Constant(nan)},
                            Bounds{{0, 0, nan}, {100, 100, 1}},
                            Bounds{{0, 0, 0}, {nan, 100, 1}},
                            Bounds{{5, 0, 0}, {4, 100, 100}},
                            Bounds{Vector::Constant(-infinity), Vector::Constant(infinity)},
                            Bounds{{-infinity, 10, 0}, {30, 40, infinity}},
                            Bounds{Vector::Constant(-1e300), Vector::Constant(1e300)},
                            Bounds{{1e299, 0, 0}, {infinity, 100, 100}},
                            Bounds{{50, 50, 0.5}, {50, 50, 0.5}},
                            Bounds{Vector::Constant(-1e39), Vector::Constant(1e39)}};
  for (int i = 0; i < 200; ++i) boxes.push_back(around({unit(random), unit(random), 0.5}, 2));
  expect_same(points, boxes);
  expect_same(std::vector<Vector>(2000, Vector::Constant(nan)), boxes);
  expect_same(std::vector<Vector>(2000, Vector::Constant(infinity)), boxes);
}

/// Nearly all points in one cell of any even grid, and denser spots in the spot.
TEST(Search, DenseSpotsInAWideModel) {
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Vector> points;
  std::vector<Bounds> boxes;
  for (int i = 0; i < 3000; ++i) {
    const double spread = i % 10 == 0 ? 1e10 : i % 3 == 0 ? 1e-6 : 1;
    points.push_back(spread * Vector(unit(random), unit(random), unit(random)));
    if (i % 10 == 5) boxes.push_back(around(points.back(), 0.1 * spread));
  }
  expect_same(points, boxes);
}

}  // namespace
}  // namespace gapcheck::contact::search_test
