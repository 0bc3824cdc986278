#include "contact/mesh/node_sums.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <random>

namespace gapcheck::contact {
namespace {

using Quads = std::vector<std::array<NodeIndex, 4>>;

/// A plate of n x n quads, its nodes numbered along the rows.
Quads plate(std::uint32_t n, std::uint32_t first = 0) {
  Quads quads;
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = first + j * (n + 1) + i;
      quads.push_back({NodeIndex{a}, NodeIndex{a + 1}, NodeIndex{a + n + 2}, NodeIndex{a + n + 1}});
    }
  return quads;
}

std::size_t nodes_of(const Quads& quads) {
  std::uint32_t last = 0;
  for (const auto& quad : quads)
    for (const NodeIndex n : quad)
      if (n != none<NodeIndex>) last = std::max(last, n.value);
  return last + 1;
}

/// A value of each item's corner; those of a node add up to other bits in another order.
double value_of(std::size_t item, std::size_t corner) {
  return 1 / (1.0 + static_cast<double>((item * 7919 + corner * 31) % 1000003));
}

std::vector<double> sums_of(const Quads& quads) {
  std::vector<double> sums(nodes_of(quads), 0.0);
  sum_at_nodes(sums, quads, [&](std::size_t i, const auto& add) {
    for (std::size_t c = 0; c < 4; ++c)
      if (quads[i][c] != none<NodeIndex>) add(quads[i][c], value_of(i, c));
  });
  return sums;
}

std::vector<double> one_by_one(const Quads& quads) {
  std::vector<double> sums(nodes_of(quads), 0.0);
  for (std::size_t i = 0; i < quads.size(); ++i)
    for (std::size_t c = 0; c < 4; ++c)
      if (quads[i][c] != none<NodeIndex>) sums[quads[i][c].value] += value_of(i, c);
  return sums;
}

void expect_the_same_bits(const Quads& quads) {
  const std::vector<double> expected = one_by_one(quads);
  for (const std::size_t jobs : {1, 2, 7}) {
    const JobLimit limit(jobs);
    EXPECT_EQ(sums_of(quads), expected) << jobs << " jobs";
  }
}

TEST(NodeSums, OfNumberedMeshes) {
  expect_the_same_bits({});
  expect_the_same_bits(plate(3));
  expect_the_same_bits(plate(300));
  Quads two = plate(250), second = plate(250, 251 * 251);
  two.insert(two.end(), second.begin(), second.end());
  expect_the_same_bits(two);
  std::reverse(two.begin(), two.end());
  expect_the_same_bits(two);
}

TEST(NodeSums, OfMeshesWithLittleOrder) {
  std::mt19937 random(1);
  Quads quads = plate(300);
  // Every tenth anywhere: pieces add to nodes of earlier ones in between.
  for (std::size_t i = 0; i < quads.size(); i += 10) std::swap(quads[i], quads[random() % quads.size()]);
  expect_the_same_bits(quads);
  std::shuffle(quads.begin(), quads.end(), random);
  expect_the_same_bits(quads);
}

TEST(NodeSums, OfOneNode) {
  expect_the_same_bits(Quads(100'000, {NodeIndex{0}, NodeIndex{0}, NodeIndex{0}, none<NodeIndex>}));
}

TEST(NodeSums, OrderIsSeenInNumberedMeshesOnly) {
  const auto disordered = [](const Quads& quads) {
    return node_sums::disordered(quads, node_sums::nodes_before(quads));
  };
  Quads quads = plate(300);
  EXPECT_FALSE(disordered(quads));
  std::shuffle(quads.begin(), quads.end(), std::mt19937(1));
  EXPECT_TRUE(disordered(quads));
}

TEST(NodeSums, SeveralThreadsVisitEachItemOnce) {
  const Quads quads = plate(600);
  std::vector<double> sums(nodes_of(quads), 0.0);
  std::vector<std::atomic<int>> visits(quads.size());
  const JobLimit limit(2);
  sum_at_nodes(sums, quads, [&](std::size_t i, const auto&) { ++visits[i]; });
  EXPECT_TRUE(std::all_of(visits.begin(), visits.end(), [](const auto& count) { return count == 1; }));
}

}  // namespace
}  // namespace gapcheck::contact
