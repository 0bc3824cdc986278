#include "contact/mesh/node_slots.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

namespace gapcheck::contact::node_slots_test {
namespace {

TEST(NodeSlots, OfAllNodesTheSlotIsThePosition) {
  const NodeSlots slots(std::size_t{5});
  EXPECT_EQ(slots.size(), 5U);
  EXPECT_EQ(slots.slot(NodeIndex{3}), 3U);
  EXPECT_EQ(slots.node(4), NodeIndex{4});
  EXPECT_EQ(slots.slot(NodeIndex{5}), no_position);
}

TEST(NodeSlots, OfFewNodesTheyAscendWithoutRepeats) {
  const NodeSlots slots(std::vector<NodeIndex>{NodeIndex{90}, NodeIndex{7}, NodeIndex{90}, NodeIndex{40}});
  EXPECT_EQ(slots.size(), 3U);
  EXPECT_EQ(slots.slot(NodeIndex{7}), 0U);
  EXPECT_EQ(slots.slot(NodeIndex{90}), 2U);
  EXPECT_EQ(slots.node(1), NodeIndex{40});
  for (const std::uint32_t absent : {0U, 8U, 91U}) EXPECT_EQ(slots.slot(NodeIndex{absent}), no_position);
}

// Nodes that follow one another are numbered in a table, others by sorting: the numbers are the same.
TEST(NodeSlots, AreThePositionsInASortedList) {
  std::mt19937_64 random(3);
  for (const std::uint32_t range : {20U, 300U, 399U, 401U, 500U, 4000000U}) {
    for (const std::uint32_t first : {0U, 7U, 4000000000U}) {
      std::vector<NodeIndex> nodes(100);
      for (NodeIndex& node : nodes) node = NodeIndex{first + static_cast<std::uint32_t>(random() % range)};
      nodes[17] = NodeIndex{first};
      nodes[71] = NodeIndex{first + range - 1};
      std::set<std::uint32_t> sorted;
      for (const NodeIndex node : nodes) sorted.insert(node.value);
      const NodeSlots slots(nodes);
      ASSERT_EQ(slots.size(), sorted.size());
      std::uint32_t expected = 0;
      for (const std::uint32_t node : sorted) {
        EXPECT_EQ(slots.node(expected), NodeIndex{node});
        EXPECT_EQ(slots.slot(NodeIndex{node}), expected++);
      }
      for (int i = 0; i < 100; ++i) {
        const std::uint32_t node = first + static_cast<std::uint32_t>(random() % range);
        EXPECT_EQ(slots.slot(NodeIndex{node}) == no_position, !sorted.contains(node));
      }
      EXPECT_EQ(slots.slot(NodeIndex{first - 1}), no_position);
      EXPECT_EQ(slots.slot(NodeIndex{first + range}), no_position);
    }
  }
  EXPECT_EQ(NodeSlots(std::vector<NodeIndex>{}).size(), 0U);
}

TEST(NodeSlots, FewIsASixteenthOfTheMesh) {
  EXPECT_TRUE(NodeSlots::few(9, 160));
  EXPECT_FALSE(NodeSlots::few(10, 160));
}

}  // namespace
}  // namespace gapcheck::contact::node_slots_test
