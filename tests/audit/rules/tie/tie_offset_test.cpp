#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tie_offset_test {
namespace {

// Shells of 10 x 10, thickness 1: tie distance max(0.6, 0.05 * 14.142) = 0.7071, visible from 0.01 * 14.142 = 0.1414.
Report node_above(double height, const std::string& type, const std::string& control = "") {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10).node(50, Vector(3, 4, height));
  deck.raw("SET_NODE_LIST", "7\n50\n").contact(1, type, "7,1,4,3");
  if (!control.empty()) deck.raw("CONTROL_CONTACT", control);
  return run_rule("GC202", deck);
}

TEST(TieOffset, VisibleOffsetsOfPenaltyTies) {
  for (const char* type :
       {"TIED_NODES_TO_SURFACE_OFFSET", "TIED_SURFACE_TO_SURFACE_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_OFFSET"}) {
    const Report report = node_above(0.5, type);
    ASSERT_EQ(listed(report), 1U) << type;
    ASSERT_EQ(report.tie_failures.size(), 1U);
    const TieFailure& offset = report.tie_failures[0];
    EXPECT_EQ(offset.reason, TieReason::offset);
    EXPECT_EQ(offset.node, 50);
    EXPECT_NEAR(offset.distance, 0.5, 1e-12);
    EXPECT_NEAR(offset.allowed, 0.05 * std::sqrt(200.0), 1e-12);
    EXPECT_GT(offset.line, 0U);
    EXPECT_EQ(report.contacts[0].untied, 0U);
    EXPECT_EQ(listed(node_above(0.14, type)), 0U);
  }
}

TEST(TieOffset, NotWhereMomentsAreCarriedOrNodesAreMoved) {
  EXPECT_EQ(listed(node_above(0.5, "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET")), 0U);
  EXPECT_EQ(listed(node_above(0.5, "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET")), 0U);
  EXPECT_EQ(listed(node_above(0.5, "TIED_NODES_TO_SURFACE")), 0U);
  EXPECT_EQ(listed(node_above(0.5, "TIED_NODES_TO_SURFACE", "\n,,,,,,,1\n")), 1U);  // TIEDPRJ
}

}  // namespace
}  // namespace gapcheck::audit_test::tie_offset_test
