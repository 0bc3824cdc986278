#include "contact/search/box_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace gapcheck::contact::box_pairs_test {
namespace {

using Boxes = std::vector<Bounds>;
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// Collects pairs and makes sure that none comes twice.
class Collector {
 public:
  [[nodiscard]] BoxPairVisit visit() {
    return [this](std::uint32_t a, std::uint32_t b) {
      const std::lock_guard lock(mutex_);
      EXPECT_TRUE(pairs_.emplace(a, b).second) << a << ' ' << b << " came twice";
    };
  }
  [[nodiscard]] const Pairs& pairs() const { return pairs_; }

 private:
  std::mutex mutex_;
  Pairs pairs_;
};

Pairs pairs(const Boxes& a, const Boxes& b, BoxSearch search = BoxSearch::tree) {
  Collector found;
  for_each_box_pair(a, b, found.visit(), search);
  return found.pairs();
}
Pairs pairs(const Boxes& boxes, BoxSearch search = BoxSearch::tree) {
  Collector found;
  for_each_box_pair(boxes, found.visit(), search);
  for (const auto& [a, b] : found.pairs()) EXPECT_LT(a, b);
  return found.pairs();
}

void expect_same(const Boxes& a, const Boxes& b) {
  EXPECT_EQ(pairs(a, b), pairs(a, b, BoxSearch::brute_force));
  EXPECT_EQ(pairs(a), pairs(a, BoxSearch::brute_force));
}

Bounds around(const Vector& centre, double half) {
  return {centre - Vector::Constant(half), centre + Vector::Constant(half)};
}

/// Boxes of sizes over several decades in a cloud, a slab or clusters; far from the origin in every third scene.
Boxes random_boxes(std::mt19937_64& random, int scene, int count) {
  std::uniform_real_distribution<double> unit(-1, 1), decade(-4, 0);
  const double spread = std::pow(10, 3 * decade(random) + 6);
  const Vector offset = scene % 3 == 0 ? Vector(1e6 * spread, -3e5 * spread, 1e7 * spread) : Vector::Zero();
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    const double cluster = i % 3 == 0 ? 1e-3 : 1;
    const Vector centre(unit(random), unit(random), scene % 4 == 0 ? 0 : unit(random));
    boxes.push_back(around(offset + spread * cluster * centre, spread * std::pow(10, decade(random) - 0.5)));
  }
  return boxes;
}

TEST(BoxPairs, TreeAgreesWithBruteForceOnRandomScenes) {
  std::mt19937_64 random(5);
  for (int scene = 0; scene < 48; ++scene) {
    const Boxes a = random_boxes(random, scene, 1 + 9 * scene), b = random_boxes(random, scene, 300 - 6 * scene);
    expect_same(a, b);
  }
}

TEST(BoxPairs, TouchingBoxesMeetAndOthersDoNot) {
  const Bounds box{{0, 0, 0}, {1, 1, 1}};
  const double beyond = std::nextafter(1.0, 2.0);
  EXPECT_EQ(pairs({box}, {Bounds{{1, 1, 1}, {2, 2, 2}}}).size(), 1U);
  EXPECT_EQ(pairs({box}, {Bounds{{beyond, 0, 0}, {2, 1, 1}}}).size(), 0U);
  EXPECT_EQ(pairs({box, box, box}).size(), 3U);
}

/// A plate of n x n flat boxes: every box meets its eight neighbours.
TEST(BoxPairs, NeighboursOfAPlate) {
  constexpr std::size_t n = 40;
  Boxes boxes;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const Vector low(static_cast<double>(i), static_cast<double>(j), 0);
      boxes.push_back({low, low + Vector(1, 1, 0)});
    }
  EXPECT_EQ(pairs(boxes).size(), 2 * n * (n - 1) + 2 * (n - 1) * (n - 1));
}

TEST(BoxPairs, EmptyBoxesAndStrangeNumbersMeetNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Boxes strange{Bounds{}, Bounds{{nan, 0, 0}, {1, 1, 1}}, Bounds{{0, 0, 0}, {1, nan, 1}}};
  const Boxes huge{Bounds{{-infinity, -1e300, -1e300}, {infinity, 1e300, 1e300}}, around({1e300, 1e300, 1e300}, 1e290),
                   around({0, 0, 0}, 1e-300)};
  EXPECT_TRUE(pairs(strange).empty());
  EXPECT_TRUE(pairs(strange, huge).empty());
  EXPECT_TRUE(pairs({}, huge).empty());
  EXPECT_TRUE(pairs(Boxes{}).empty());
  expect_same(huge, huge);
}

TEST(BoxPairs, StrayBoxesAndEqualBoxes) {
  std::mt19937_64 random(11);
  Boxes boxes = random_boxes(random, 1, 500);
  for (const double far : {1e12, -1e20, 1e29}) boxes.push_back(around({far, far / 2, -far}, 1));
  expect_same(boxes, boxes);
  expect_same(Boxes(100, around({3, 3, 3}, 1)), Boxes(70, around({4, 4, 4}, 0)));
}

}  // namespace
}  // namespace gapcheck::contact::box_pairs_test
