#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::free_node_test {
namespace {

RuleDeck plate_and(const std::string& set) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.node(50, {2, 2, 3}).node(51, {2, 3, 3}).raw("SET_NODE_LIST", "7\n" + set + "\n");
  return deck.contact(1, "TIED_NODES_TO_SURFACE", "7,1,4,3");
}

TEST(FreeNode, TrackedWithoutAnElement) {
  const Report report = run_rule("GC508", plate_and("50,51"));
  ASSERT_EQ(listed(report), 2U);
  EXPECT_EQ(report.findings[0].node, 50);
  EXPECT_EQ(report.findings[1].node, 51);
  EXPECT_EQ(report.findings[0].contact, 1);
  EXPECT_EQ(report.findings[0].severity, Severity::warning);
  EXPECT_EQ(listed(run_rule("GC508", plate_and("50,51").raw("ELEMENT_MASS", "60,50,0.1\n61,51,0.1\n"))), 0U);
}

TEST(FreeNode, UnusedNodesAreOneNote) {
  RuleDeck deck = plate_and("1,2");
  const Report report = run_rule("GC508", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].severity, Severity::note);
  EXPECT_EQ(report.findings[0].count, 2U);
  EXPECT_EQ(report.findings[0].node, 50);
}

TEST(FreeNode, NotWhatOtherKeywordsName) {
  RuleDeck beam = plate_and("1,2"), joint = plate_and("1,2"), spc = plate_and("1,2");
  beam.beam_part(2, 1).raw("ELEMENT_BEAM", "90,2,1,2,50\n91,2,2,3,51\n");
  EXPECT_EQ(listed(run_rule("GC508", beam)), 0U);
  EXPECT_EQ(listed(run_rule("GC508", joint.raw("CONSTRAINED_JOINT_SPHERICAL", "50,51\n"))), 0U);
  const Report one_left = run_rule("GC508", spc.raw("BOUNDARY_SPC_NODE", "51,0,1,1,1\n"));
  ASSERT_EQ(listed(one_left), 1U);
  EXPECT_EQ(one_left.findings[0].node, 50);
  EXPECT_EQ(one_left.findings[0].count, 1U);
}

TEST(FreeNode, NeedsAContact) {
  RuleDeck deck;
  EXPECT_EQ(listed(run_rule("GC508", deck.node(1, {0, 0, 0}))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::free_node_test
