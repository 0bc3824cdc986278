#include <cmath>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::edge_zone_penetration_test {
namespace {

// A node beside the edge of a plate with elements of 1: the band ends a quarter of an element beyond, h = 2.
Report node_beside(double beyond) {
  RuleDeck deck;
  deck.shell_part(1, 4).plate(1, 1, 2, 2, Vector(0, 0, 0), 1, 1).node(50, Vector(2 + beyond, 1.5, 0.1));
  deck.raw("SET_NODE_LIST", "7\n50\n").contact(1, "AUTOMATIC_NODES_TO_SURFACE", "7,1,4,3");
  return run_rule("GC106", deck);
}

TEST(EdgeZonePenetration, BeyondTheBandOnly) {
  const Report report = node_beside(0.6);
  ASSERT_EQ(report.penetrations.size(), 1U);
  const Penetration& p = report.penetrations[0];
  EXPECT_EQ(p.kind, PenetrationKind::edge_zone);
  EXPECT_EQ(p.outcome, Outcome::reported);
  EXPECT_EQ(p.node, 50);
  EXPECT_DOUBLE_EQ(p.contact_distance, 2);
  EXPECT_NEAR(p.depth, 2 - std::sqrt(0.6 * 0.6 + 0.1 * 0.1), 1e-12);
  EXPECT_EQ(report.contacts[0].edge_zone, 1U);
  EXPECT_EQ(listed(node_beside(0.251)), 1U);
  EXPECT_EQ(listed(node_beside(0.249)), 0U);
  EXPECT_EQ(listed(node_beside(1.997)), 1U) << "1.9995 away";
  EXPECT_EQ(listed(node_beside(1.998)), 0U) << "2.0005 away";
}

}  // namespace
}  // namespace gapcheck::audit_test::edge_zone_penetration_test
