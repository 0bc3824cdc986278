#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tie_offset_test {
namespace {

// Shells of 10 x 10, thickness 1: tie distance max(0.6, 0.05 * 14.142) = 0.7071, visible from 0.01 * 14.142 = 0.1414.
RuleDeck node_above(double height, const std::string& type, const std::string& control = "") {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10).node(50, Vector(3, 4, height));
  deck.raw("SET_NODE_LIST", "7\n50\n").contact(1, type, "7,1,4,3");
  if (!control.empty()) deck.raw("CONTROL_CONTACT", control);
  return deck;
}

std::size_t found(double height, const std::string& type, const std::string& control = "") {
  return listed(run_rule("GC202", node_above(height, type, control)));
}

TEST(TieOffset, VisibleOffsetsOfPenaltyTies) {
  for (const char* type :
       {"TIED_NODES_TO_SURFACE_OFFSET", "TIED_SURFACE_TO_SURFACE_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_OFFSET"}) {
    const RuleDeck deck = node_above(0.5, type);
    const Report report = run_rule("GC202", deck);
    ASSERT_EQ(listed(report), 1U) << type;
    ASSERT_EQ(report.tie_failures.size(), 1U);
    const TieFailure& offset = report.tie_failures[0];
    EXPECT_EQ(offset.reason, TieReason::offset);
    EXPECT_EQ(offset.node, 50);
    EXPECT_NEAR(offset.distance, 0.5, 1e-12);
    EXPECT_NEAR(offset.allowed, 0.05 * std::sqrt(200.0), 1e-12);
    EXPECT_EQ(offset.line, line_of(deck, "50,3,4,0.5"));
    EXPECT_EQ(report.contacts[0].untied, 0U);
    EXPECT_EQ(found(0.142, type), 1U);
    EXPECT_EQ(found(0.141, type), 0U);
  }
}

TEST(TieOffset, NotWhereMomentsAreCarriedOrNodesAreMoved) {
  EXPECT_EQ(found(0.5, "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET"), 0U);
  EXPECT_EQ(found(0.5, "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET"), 0U);
  EXPECT_EQ(found(0.5, "TIED_NODES_TO_SURFACE"), 0U);
  EXPECT_EQ(found(0.5, "TIED_NODES_TO_SURFACE", "\n,,,,,,,1\n"), 1U);  // TIEDPRJ
}

}  // namespace
}  // namespace gapcheck::audit_test::tie_offset_test
