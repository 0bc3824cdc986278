#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::untied_node_test {
namespace {

// d2 = 0.05 * 7.07 = 0.35, d1 = 0.6 (0 + 1).
Report node_above(double height) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).node(50, Vector(2, 2, height));
  deck.raw("SET_NODE_LIST", "7\n50\n").contact(1, "TIED_NODES_TO_SURFACE", "7,1,4,3");
  return run_rule("GC201", deck);
}

TEST(UntiedNode, BeyondTheTieDistanceOnly) {
  const Report far = node_above(0.7);
  ASSERT_EQ(listed(far), 1U);
  ASSERT_EQ(far.tie_failures.size(), 1U);
  EXPECT_EQ(far.tie_failures[0].reason, TieReason::too_far);
  EXPECT_EQ(far.tie_failures[0].node, 50);
  EXPECT_NEAR(far.tie_failures[0].distance, 0.7, 1e-12);
  EXPECT_NEAR(far.tie_failures[0].allowed, 0.6, 1e-12);
  EXPECT_EQ(listed(node_above(0.601)), 1U);
  EXPECT_EQ(listed(node_above(0.599)), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::untied_node_test
