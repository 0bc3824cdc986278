#include "contact/mesh/node_slots.hpp"

#include <gtest/gtest.h>

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

TEST(NodeSlots, FewIsASixteenthOfTheMesh) {
  EXPECT_TRUE(NodeSlots::few(9, 160));
  EXPECT_FALSE(NodeSlots::few(10, 160));
}

}  // namespace
}  // namespace gapcheck::contact::node_slots_test
