#include "audit/fix/moving_nodes.hpp"

#include <gtest/gtest.h>

#include "contact/scene.hpp"

namespace gapcheck::audit::moving_nodes_test {
namespace {

TEST(MovingNodes, EachMovesAlone) {
  MovingNodes moving(5);
  moving.set({0, 1, 0, 1, 1}, {});
  EXPECT_EQ(moving.nodes(), (std::vector{NodeIndex{1}, NodeIndex{3}, NodeIndex{4}}));
  EXPECT_EQ(moving.leaders(), moving.nodes());
  EXPECT_EQ(moving.slot(NodeIndex{1}), 0U);
  EXPECT_EQ(moving.slot(NodeIndex{4}), 2U);
}

TEST(MovingNodes, JoinedNodesShareASlot) {
  contact::Scene scene;
  for (int i = 0; i < 5; ++i) scene.node(Vector::Zero());
  model::NodeLink weld{};
  weld.kind = model::NodeLink::Kind::rivet;
  weld.nodes = {NodeIndex{1}, NodeIndex{3}};
  const JoinedNodes joined(scene.model, {weld});
  ASSERT_EQ(joined.leader(NodeIndex{3}), NodeIndex{1});
  MovingNodes moving(5);
  moving.set({0, 1, 1, 1, 0}, joined);
  EXPECT_EQ(moving.nodes().size(), 3U);
  EXPECT_EQ(moving.leaders(), (std::vector{NodeIndex{1}, NodeIndex{2}}));
  EXPECT_EQ(moving.slot(NodeIndex{3}), moving.slot(NodeIndex{1}));
  moving.set({1, 0, 0, 0, 0}, joined);
  EXPECT_EQ(moving.nodes(), std::vector{NodeIndex{0}});
}

}  // namespace
}  // namespace gapcheck::audit::moving_nodes_test
