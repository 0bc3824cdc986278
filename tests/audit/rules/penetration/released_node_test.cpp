#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::released_node_test {
namespace {

// Released beyond 0.4 (1 + 1) of 1: what is left of the distance is below 0.2.
RuleDeck plates(double gap) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 2, 2, Vector(0, 0, gap), 5, 5).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  return deck;
}

TEST(ReleasedNode, BelowAFifthOfTheDistanceOnly) {
  EXPECT_EQ(run_rule("GC102", plates(0.19)).penetrations.size(), 18U);
  EXPECT_EQ(listed(run_rule("GC102", plates(0.21))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::released_node_test
