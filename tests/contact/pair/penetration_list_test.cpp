#include "contact/pair/penetration_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

namespace gapcheck::contact::penetration_list_test {
namespace {

/// Nodes 0 to 2 with ids 10, 20 and 30, all tracked.
const std::vector<std::int64_t> ids{10, 20, 30};
TrackedNodes three_nodes() {
  TrackedNodes nodes;
  nodes.node = {NodeIndex{0}, NodeIndex{1}, NodeIndex{2}};
  return nodes;
}

Penetration record(std::int64_t node, double depth, PenetrationKind kind = PenetrationKind::initial) {
  Penetration p;
  p.node = node;
  p.depth = depth;
  p.kind = kind;
  return p;
}

/// A hit of each of the three nodes.
std::vector<Hit> hits(bool in_band) {
  std::vector<Hit> list(3);
  for (std::size_t i = 0; i < list.size(); ++i) {
    list[i].slot = to_index<SlotIndex>(i);
    list[i].in_band = in_band;
  }
  return list;
}

std::vector<std::int64_t> nodes_of(std::span<const Penetration> records) {
  std::vector<std::int64_t> list;
  for (const Penetration& p : records) list.push_back(p.node);
  return list;
}

TEST(PenetrationList, ListsANodeOnce) {
  std::vector<Penetration> all{record(10, 1)};  // of an earlier contact
  PenetrationList list(all);
  std::vector<Hit> first = hits(true);
  list.keep_one_per_node(first, three_nodes(), ids);
  EXPECT_EQ(first.size(), 3U);
  const std::span<Penetration> added = list.add(2);
  added[0] = record(20, 1);
  added[1] = record(30, 1, PenetrationKind::edge_zone);
  std::vector<Hit> again = hits(true);
  list.keep_one_per_node(again, three_nodes(), ids);
  // The penetration of node 30 replaces the note on it.
  ASSERT_EQ(again.size(), 2U);
  EXPECT_EQ(nodes_of(list.records()), std::vector<std::int64_t>{20});
  EXPECT_EQ(nodes_of(all), (std::vector<std::int64_t>{10, 20}));
}

TEST(PenetrationList, ANoteReplacesNothing) {
  std::vector<Penetration> all;
  PenetrationList list(all);
  list.add(std::vector{record(20, 1), record(30, 1, PenetrationKind::edge_zone)});
  std::vector<Hit> again = hits(false);
  list.keep_one_per_node(again, three_nodes(), ids);
  EXPECT_EQ(again.size(), 1U);
  EXPECT_EQ(list.records().size(), 2U);
}

TEST(PenetrationList, SortsItsOwnRecordsOnly) {
  std::vector<Penetration> all{record(90, 0.1)};
  PenetrationList list(all);
  list.add(std::vector{record(30, 1), record(20, 2), record(10, 1)});
  list.sort_deepest_first();
  EXPECT_EQ(nodes_of(all), (std::vector<std::int64_t>{90, 20, 10, 30}));
}

TEST(PenetrationList, SortsAsAStableSortOfWholeRecordsDoes) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 200; ++round) {
    std::vector<Penetration> all{record(90, 0.1)};
    PenetrationList list(all);
    std::vector<Penetration> added;
    // Few depths and nodes, so that many are equal.
    const std::uint64_t count = round < 190 ? random() % 40 : 5000;
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto node = static_cast<std::int64_t>(round % 4 == 0 ? i / 2 : random() % 5) - 2;
      added.push_back(record(node, 0.25 * static_cast<double>(random() % 400 / 100) - 0.25));
      added.back().element = static_cast<std::int64_t>(i);
    }
    list.add(added);
    list.sort_deepest_first();
    std::stable_sort(added.begin(), added.end(), [](const Penetration& l, const Penetration& r) {
      return std::tuple(-l.depth, l.node) < std::tuple(-r.depth, r.node);
    });
    ASSERT_EQ(list.records().size(), added.size());
    EXPECT_EQ(all.front().node, 90);
    for (std::size_t i = 0; i < added.size(); ++i) EXPECT_EQ(list.records()[i].element, added[i].element) << round;
  }
}

}  // namespace
}  // namespace gapcheck::contact::penetration_list_test
