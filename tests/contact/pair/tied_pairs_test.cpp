#include "contact/pair/tied_pairs.hpp"

#include <gtest/gtest.h>

#include <set>

#include "contact/scene.hpp"

namespace gapcheck::contact::tied_pairs_test {
namespace {

TEST(TiedPairs, BeamsByEachOfTheirEnds) {
  Scene scene;
  for (int i = 0; i < 5; ++i) scene.node(Vector(i, 0, 0));
  scene.model.mesh.beams.nodes = {{NodeIndex{3}, NodeIndex{0}},
                                  {NodeIndex{4}, NodeIndex{3}},
                                  {NodeIndex{3}, none<NodeIndex>},
                                  {NodeIndex{1}, NodeIndex{4}}};
  TiedPairs ties(scene.model);
  const auto others = [&](std::uint32_t node) {
    std::set<std::uint32_t> ends;
    for (const auto& [own, other] : ties.beams_at(NodeIndex{node})) {
      EXPECT_EQ(own, NodeIndex{node});
      ends.insert(other.value);
    }
    return ends;
  };
  EXPECT_EQ(others(0), (std::set<std::uint32_t>{3}));
  EXPECT_EQ(others(1), (std::set<std::uint32_t>{4}));
  EXPECT_EQ(others(2), (std::set<std::uint32_t>{}));
  EXPECT_EQ(others(3), (std::set<std::uint32_t>{0, 4}));
  EXPECT_EQ(others(4), (std::set<std::uint32_t>{1, 3}));
}

TEST(TiedPairs, TheFirstConstraintHoldsANode) {
  Scene scene;
  for (int i = 0; i < 3; ++i) scene.node(Vector(i, 0, 0));
  TiedPairs ties(scene.model);
  EXPECT_EQ(ties.constrained_by(NodeIndex{1}), std::nullopt);
  ties.constrain(NodeIndex{1}, ContactIndex{6});
  ties.constrain(NodeIndex{1}, ContactIndex{2});
  EXPECT_EQ(ties.constrained_by(NodeIndex{1}), ContactIndex{6});
  EXPECT_EQ(ties.constrained_by(NodeIndex{0}), std::nullopt);
}

}  // namespace
}  // namespace gapcheck::contact::tied_pairs_test
