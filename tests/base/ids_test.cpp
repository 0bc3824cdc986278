#include "base/ids.hpp"

#include <gtest/gtest.h>

#include <type_traits>
#include <unordered_set>
#include <vector>

namespace gapcheck::ids_test {
namespace {

template <class A, class B>
concept Comparable = requires(A a, B b) {
  a == b;
};

TEST(Ids, KindsDoNotMix) {
  static_assert(Comparable<NodeId, NodeId>);
  static_assert(!Comparable<NodeId, ElementId>);
  static_assert(!Comparable<NodeId, std::int64_t>);
  static_assert(!std::is_convertible_v<std::int64_t, NodeId>);
  static_assert(!std::is_convertible_v<NodeIndex, PartIndex>);
  static_assert(sizeof(NodeIndex) == 4 && sizeof(NodeId) == 8);
}

TEST(Ids, OrderAndHash) {
  EXPECT_LT(NodeId(1), NodeId(2));
  std::unordered_set<PartId> set{PartId(1), PartId(2), PartId(1)};
  EXPECT_EQ(set.size(), 2u);
}

TEST(Ids, PositionsCountUp) {
  std::vector<std::uint32_t> seen;
  for (const SegmentIndex s : positions<SegmentIndex>(3)) seen.push_back(s.value);
  for (const SegmentIndex s : positions<SegmentIndex>(7, 9)) seen.push_back(s.value);
  EXPECT_EQ(seen, (std::vector<std::uint32_t>{0, 1, 2, 7, 8}));
  for (const SlotIndex none_at_all : positions<SlotIndex>(0)) ADD_FAILURE() << none_at_all.value;
  for (const SlotIndex none_at_all : positions<SlotIndex>(4, 4)) ADD_FAILURE() << none_at_all.value;
  EXPECT_EQ(positions<PartIndex>(2).list(), (std::vector{PartIndex{0}, PartIndex{1}}));
  static_assert(!std::is_convertible_v<SegmentIndex, SlotIndex>);
  static_assert(to_index<ContactIndex>(std::size_t{5}) == ContactIndex{5});
}

TEST(Ids, NoneIsNoOrdinaryIndex) {
  EXPECT_EQ(none<NodeIndex>.value, 0xffffffffu);
  EXPECT_NE(none<PartIndex>, PartIndex(0));
}

}  // namespace
}  // namespace gapcheck::ids_test
