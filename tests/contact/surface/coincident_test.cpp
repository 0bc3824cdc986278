#include "contact/surface/coincident.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace gapcheck::contact::coincident_test {
namespace {

TEST(Coincident, AsAMapOfSetsSays) {
  std::mt19937_64 random(9);
  for (const std::uint32_t nodes : {3U, 6U, 40U}) {
    std::uniform_int_distribution<std::uint32_t> node(0, nodes - 1);
    std::vector<model::SegmentNodes> segments(500);
    for (auto& s : segments)
      for (NodeIndex& n : s) n = NodeIndex{node(random)};
    std::map<std::set<std::uint32_t>, std::uint32_t> first;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> expected, found;
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      std::set<std::uint32_t> key;
      for (const NodeIndex n : segments[i]) key.insert(n.value);
      const auto [entry, is_new] = first.emplace(key, i);
      if (!is_new) expected.emplace_back(entry->second, i);
    }
    for (const Coincidence& c : coincident_segments(segments, nodes)) found.emplace_back(c.first, c.again);
    EXPECT_EQ(found, expected);
    EXPECT_FALSE(found.empty());
  }
}

TEST(Coincident, NodesThatTheMeshDoesNotHaveMatchNothing) {
  const NodeIndex x = none<NodeIndex>;
  EXPECT_TRUE(coincident_segments(std::vector<model::SegmentNodes>{{x, x, x, x}, {x, x, x, x}}, 5).empty());
  EXPECT_TRUE(coincident_segments({}, 0).empty());
}

}  // namespace
}  // namespace gapcheck::contact::coincident_test
