#include "audit/rules/rule_deck.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit_test::tie_moved_test {
namespace {

// Shells of 10 x 10: visible from 0.01 * 14.142 = 0.1414.
Report nodes_above(double height, const std::string& type) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  deck.node(50, Vector(3, 4, 0.3)).node(51, Vector(13, 4, height)).node(52, Vector(3, 14, 5));
  deck.raw("SET_NODE_LIST", "7\n50,51,52\n").contact(1, type, "7,1,4,3");
  return run_rule("GC204", deck);
}

TEST(TieMoved, VisibleMovesAreListed) {
  const Report report = nodes_above(-0.5, "TIED_NODES_TO_SURFACE");
  ASSERT_EQ(listed(report), 2U);  // node 52 is too far
  ASSERT_EQ(report.tie_failures.size(), 2U);
  for (const TieFailure& moved : report.tie_failures) EXPECT_EQ(moved.reason, TieReason::sep);
  EXPECT_EQ(report.tie_failures[0].node, 50);
  EXPECT_NEAR(report.tie_failures[0].distance, 0.3, 1e-12);
  EXPECT_EQ(report.tie_failures[1].node, 51);
  EXPECT_NEAR(report.tie_failures[1].distance, 0.5, 1e-12);
  EXPECT_EQ(listed(nodes_above(-0.14, "TIED_NODES_TO_SURFACE")), 1U);
}

// Coarse shells tie within 0.05 · 14.142 = 0.707, also where that is more than both parts are thick.
TEST(TieMoved, BeyondBothThicknessesIsAWarning) {
  for (const auto& [gap, severity] : {std::pair(0.5, Severity::warning), std::pair(0.39, Severity::note)}) {
    RuleDeck deck;
    deck.shell_part(1, 0.3).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
    deck.shell_part(2, 0.1).plate(101, 2, 1, 1, Vector(2, 2, gap), 10, 10);
    deck.contact(1, "TIED_SURFACE_TO_SURFACE", "2,1,3,3");
    const Report report = run_rule("GC204", deck);
    ASSERT_EQ(report.tie_failures.size(), 4U);
    for (const TieFailure& moved : report.tie_failures) {
      EXPECT_DOUBLE_EQ(moved.thickness, 0.4);
      EXPECT_EQ(rule_of(moved).severity, severity) << gap;
    }
  }
}

TEST(TieMoved, OffsetFormsMoveNothing) {
  for (const char* form : {"_OFFSET", "_CONSTRAINED_OFFSET"})
    EXPECT_EQ(listed(nodes_above(-0.5, std::string("TIED_NODES_TO_SURFACE") + form)), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::tie_moved_test
