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
  const Report report = run_rule("GC102", plates(0.199));
  ASSERT_EQ(report.penetrations.size(), 18U);
  for (const Penetration& p : report.penetrations) {
    EXPECT_EQ(p.kind, PenetrationKind::released);
    EXPECT_EQ(p.outcome, Outcome::released);
    EXPECT_NEAR(p.depth, 0.801, 1e-12);
    EXPECT_EQ(p.moved_to, p.original);
  }
  EXPECT_EQ(report.contacts[0].released, 18U);
  EXPECT_EQ(report.contacts[0].penetrations, 0U);
  EXPECT_EQ(listed(run_rule("GC102", plates(0.201))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::released_node_test
