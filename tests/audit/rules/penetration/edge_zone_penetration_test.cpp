#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::edge_zone_penetration_test {
namespace {

// A node beside the edge of a plate with elements of 1: the band ends half an element beyond, h = 2.
Report node_beside(double beyond) {
  RuleDeck deck;
  deck.shell_part(1, 4).plate(1, 1, 2, 2, Vector(0, 0, 0), 1, 1).node(50, Vector(2 + beyond, 1.5, 0.1));
  deck.raw("SET_NODE_LIST", "7\n50\n").contact(1, "AUTOMATIC_NODES_TO_SURFACE", "7,1,4,3");
  return run_rule("GC106", deck);
}

TEST(EdgeZonePenetration, BeyondTheBandOnly) {
  EXPECT_EQ(node_beside(0.6).penetrations.size(), 1U);
  EXPECT_EQ(listed(node_beside(0.2)), 0U);
  EXPECT_EQ(listed(node_beside(2.1)), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::edge_zone_penetration_test
