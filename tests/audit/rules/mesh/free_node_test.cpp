#include <algorithm>
#include <utility>

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

// 8 x 8 shells have 81 nodes: 1 of 100 is listed, 1 of 101 is not.
TEST(FreeNode, AFewUnusedNodesDoNotMatter) {
  const auto with = [](int more) {
    RuleDeck deck;
    deck.shell_part(1, 1).plate(1, 1, 8, 8, Vector(0, 0, 0), 5, 5).node(500, {2, 2, 3});
    for (int i = 0; i < more; ++i) deck.node(600 + i, {1.0 * i, 0, 90});
    deck.raw("SET_NODE_LIST_GENERATE", "7\n600,699\n");
    return run_rule("GC508", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0"));
  };
  EXPECT_EQ(listed(with(18)), 1U);
  const Report few = with(19);
  EXPECT_EQ(listed(few), 0U);
  EXPECT_NE(std::find(few.statistics.begin(), few.statistics.end(),
                      std::pair<std::string, std::string>(
                          "not looked at", "GC508: 1 nodes belong to no element and no set: too few to matter")),
            few.statistics.end());
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

TEST(FreeNode, NotInADeckThatIsNotComplete) {
  audit::AuditOptions options;
  options.select = {"GC508"};
  options.read.skip_missing_includes = true;
  RuleDeck complete = plate_and("50,51"), incomplete = plate_and("50,51").raw("INCLUDE", "not_here.k");
  EXPECT_EQ(listed(run_text(complete.text(), options).report), 2U);
  const Report report = run_text(incomplete.text(), options).report;
  EXPECT_EQ(listed(report), 0U);
  EXPECT_NE(std::find(report.statistics.begin(), report.statistics.end(),
                      std::pair<std::string, std::string>(
                          "not looked at", "GC508: the deck is not complete, so elements may be missing")),
            report.statistics.end());
}

TEST(FreeNode, OnBothSidesAndManyAreCounted) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  std::string ids;
  for (int i = 0; i < 13; ++i) {
    deck.node(50 + i, {2, 0.1 * i, 3});
    ids += fmt::format("{}{}", 50 + i, i % 8 == 7 ? "\n" : ",");
  }
  deck.raw("SET_NODE_LIST", "7\n" + ids).contact(1, "TIED_NODES_TO_SURFACE", "7,1,4,3");
  const Report report = run_rule("GC508", deck);
  ASSERT_EQ(listed(report), 11U);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(report.findings[static_cast<std::size_t>(i)].node, 50 + i);
  EXPECT_EQ(report.findings[10].count, 3U);
  EXPECT_EQ(report.findings[10].message, "3 more tracked nodes of contact 1 belong to no element");
}

TEST(FreeNode, NeedsAContact) {
  RuleDeck deck;
  EXPECT_EQ(listed(run_rule("GC508", deck.node(1, {0, 0, 0}))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::free_node_test
