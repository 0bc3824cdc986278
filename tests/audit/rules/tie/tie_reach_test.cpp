#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tie_reach_test {
namespace {

/// Nodes 3, 2 and 0.65 above shells of 10 x 10 and thickness 1; the last one ties by 0.05 * 14.142.
RuleDeck nodes_above(const std::string& cards) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  deck.node(50, Vector(3, 4, 3)).node(51, Vector(13, 4, -2)).node(52, Vector(3, 14, 0.65));
  return deck.raw("SET_NODE_LIST", "7\n50,51,52\n").contact(1, "TIED_NODES_TO_SURFACE", "7,1,4,3", cards);
}

TEST(TieReach, NamesTheThicknessThatTies) {
  const Report report = run_rule("GC208", nodes_above("0.\n1.,1.\n"));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].node, 50);
  EXPECT_EQ(report.findings[0].count, 2U);
  // 3 = 0.6 (4 + 1)
  EXPECT_NE(report.findings[0].message.find("SST = -4 would"), std::string::npos) << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC208", nodes_above("0.\n1.,1.,-4.\n"))), 0U);
  EXPECT_EQ(listed(run_rule("GC201", nodes_above("0.\n1.,1.,-4.\n"))), 0U);
  EXPECT_EQ(listed(run_rule("GC201", nodes_above("0.\n1.,1.,-3.999\n"))), 1U);
}

TEST(TieReach, LessThanOne) {
  // 0.9 = 0.6 (0.5 + 1), where the diagonal of 7.07 ties up to 0.35 and the shell up to 0.6.
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).node(50, Vector(2, 2, 0.9));
  deck.raw("SET_NODE_LIST", "7\n50\n").contact(1, "TIED_NODES_TO_SURFACE", "7,1,4,3");
  const Report report = run_rule("GC208", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].message,
            "1 node is too far to tie, node 50 by most: 0.9 from its segment, tie distance 0.6; SST = -0.5 would tie "
            "it and all that tie now");
}

TEST(TieReach, CountsWithTheReferenceThickness) {
  const Report report = run_rule("GC208", nodes_above("0.\n1.,1.,0.,-2.\n"));  // 3 = 0.6 (3 + 2)
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("SST = -3 would"), std::string::npos) << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC201", nodes_above("0.\n1.,1.,-3.,-2.\n"))), 0U);
}

TEST(TieReach, KeepsWhatTiesByTheDiagonal) {
  // Node 50 alone asks for 0.9 = 0.6 (0.5 + 1), but node 51 ties over 3 by 0.05 of its diagonal of 141.
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 1, 1, Vector(0, 0, 0), 10, 10).plate(11, 1, 1, 1, Vector(200, 0, 0), 100, 100);
  deck.node(50, Vector(3, 4, 0.9)).node(51, Vector(250, 50, 3)).raw("SET_NODE_LIST", "7\n50,51\n");
  const Report report = run_rule("GC208", deck.contact(1, "TIED_NODES_TO_SURFACE", "7,1,4,3"));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].count, 1U);
  EXPECT_NE(report.findings[0].message.find("SST = -4 would"), std::string::npos) << report.findings[0].message;
}

}  // namespace
}  // namespace gapcheck::audit_test::tie_reach_test
