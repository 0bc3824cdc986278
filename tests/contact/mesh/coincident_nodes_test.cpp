#include "contact/mesh/coincident_nodes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/parallel.hpp"

namespace gapcheck::contact::coincident_nodes_test {
namespace {

std::vector<NodeIndex> all(std::size_t count) {
  std::vector<NodeIndex> nodes;
  for (std::uint32_t i = 0; i < count; ++i) nodes.emplace_back(i);
  return nodes;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs(const std::vector<Vector>& x, double tolerance) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> list;
  for (const CoincidentNodes& pair : coincident_nodes(all(x.size()), x, tolerance))
    list.emplace_back(pair.first.value, pair.second.value);
  return list;
}

/// Every node with the first one near it.
std::vector<std::pair<std::uint32_t, std::uint32_t>> slow_pairs(const std::vector<Vector>& x, double tolerance) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> list;
  for (std::uint32_t i = 0; i < x.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j)
      if ((x[i] - x[j]).norm() <= tolerance) {
        list.emplace_back(j, i);
        break;
      }
  return list;
}

TEST(CoincidentNodes, AsTheSlowWay) {
  std::mt19937 random(7);
  for (const double span : {1.0, 1000.0, 1e7}) {
    std::uniform_real_distribution<double> place(-span, span), nudge(-1e-3, 1e-3);
    std::vector<Vector> x;
    for (int i = 0; i < 600; ++i) x.emplace_back(place(random), place(random), place(random));
    for (std::size_t i = 0; i < 200; ++i) x.emplace_back(x[i] + Vector(nudge(random), nudge(random), nudge(random)));
    EXPECT_EQ(pairs(x, 1e-3), slow_pairs(x, 1e-3)) << span;
    EXPECT_FALSE(pairs(x, 1e-3).empty());
  }
}

TEST(CoincidentNodes, OnRoundCoordinatesAndAcrossZero) {
  std::vector<Vector> x;
  for (int i = -6; i <= 6; ++i) x.emplace_back(0.064 * i, -0.064 * i, 0.0);
  const std::size_t count = x.size();
  for (std::size_t i = 0; i < count; ++i) x.emplace_back(x[i] + Vector(-1e-4, 1e-4, -1e-4));
  EXPECT_EQ(pairs(x, 1e-3), slow_pairs(x, 1e-3));
  EXPECT_EQ(pairs(x, 1e-3).size(), count);
  EXPECT_EQ(pairs({{0.0, 0, 0}, {-0.0, 0, 0}}, 0).size(), 1U);
}

TEST(CoincidentNodes, AnyNumbersAndCrowds) {
  std::vector<Vector> same(5000, Vector(1, 2, 3));
  EXPECT_EQ(pairs(same, 1e-3).size(), 4999U);
  EXPECT_EQ(pairs(same, 0).size(), 4999U);
  const std::vector<Vector> odd{{NAN, 0, 0},   {NAN, 0, 0},      {1e300, 0, 0},
                                {1e300, 0, 0}, {INFINITY, 0, 0}, {INFINITY, 0, 0}};
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> huge{{2, 3}};
  EXPECT_EQ(pairs(odd, 1e-6), huge);
  EXPECT_EQ(pairs(odd, NAN), huge);
  EXPECT_TRUE(pairs({}, 1).empty());
}

TEST(CoincidentNodes, SameForAnyNumberOfThreads) {
  std::vector<Vector> x;
  for (int i = 0; i < 100000; ++i) x.emplace_back(i % 300, i / 300 % 200, 0);
  const auto many = pairs(x, 1e-3);
  EXPECT_EQ(many.size(), 40000U);
  const JobLimit one(1);
  EXPECT_EQ(pairs(x, 1e-3), many);
}

}  // namespace
}  // namespace gapcheck::contact::coincident_nodes_test
