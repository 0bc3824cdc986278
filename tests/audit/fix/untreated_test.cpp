#include "audit/fix/run_fix.hpp"
#include "audit/rules/rule_deck.hpp"
#include "audit/run.hpp"

namespace gapcheck::audit_test::untreated_test {
namespace {

FixRun fix(const RuleDeck& deck) { return fix_text(deck.text()); }

/// Two square plates of 3 x 3 shells with thickness 1, `gap` apart, in one contact.
RuleDeck plates(double gap, const std::string& keyword, const std::string& card_a = "") {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1);
  deck.plate(1, 1, 3, 3, Vector(0, 0, 0), 5, 5).plate(101, 2, 3, 3, Vector(1, 1, gap), 5, 5);
  return deck.contact(1, keyword, "0,0,5,0", "0.\n1.,1.\n" + card_a);
}

// Each corner of a segment that the audit lists is counted, none is moved, and the deck is not called corrected.
TEST(Untreated, SegmentsInSegments) {
  const std::string soft_2 = "2\n";
  for (const auto& [keyword, cards, rule] : {std::tuple("AUTOMATIC_SINGLE_SURFACE", soft_2, "GC107"),
                                             std::tuple("AUTOMATIC_SINGLE_SURFACE_MORTAR", std::string(), "GC108")}) {
    const RuleDeck deck = plates(0.7, keyword, cards);
    const std::size_t listed_nodes = listed(run_rule(rule, deck));
    ASSERT_EQ(listed_nodes, 18U) << rule;  // nine corners of each plate lie over the other one
    const FixRun run = fix(deck);
    const FixContact& contact = run.report().contacts.at(0);
    EXPECT_TRUE(contact.by_segments);
    EXPECT_EQ(contact.before.penetrations, listed_nodes);
    EXPECT_EQ(contact.after.penetrations, listed_nodes);
    EXPECT_NEAR(contact.after.deepest, 0.3, 1e-12);
    EXPECT_EQ(contact.not_checked, "");
    EXPECT_NE(contact.why_untreated.find(
                  fmt::format("{} penetrations of segments are not corrected ({})", listed_nodes, rule)),
              std::string::npos)
        << contact.why_untreated;
    EXPECT_EQ(untreated(run.report()), listed_nodes);
    EXPECT_FALSE(complete(run.report()));
    EXPECT_TRUE(run.report().moved.empty());

    const FixRun free = fix(plates(1.1, keyword, cards));
    EXPECT_EQ(free.report().contacts.at(0).why_untreated, "");
    EXPECT_TRUE(complete(free.report())) << rule;
  }
}

TEST(Untreated, EdgesInEdges) {
  for (const auto& [height, edges] : {std::pair(1.5, 1U), std::pair(2.5, 0U)}) {
    RuleDeck deck;
    deck.beam_part(1, 2).beam_part(2, 2);
    deck.node(1, Vector(-10, 0, 0)).node(2, Vector(10, 0, 0)).beam(1, 1, 1, 2);
    deck.node(101, Vector(4, -10, height)).node(102, Vector(4, 10, height)).beam(2, 2, 101, 102);
    const FixRun run = fix(deck.contact(1, "AUTOMATIC_GENERAL", "0,0,5,0"));
    const FixContact& contact = run.report().contacts.at(0);
    EXPECT_EQ(contact.edges_before, edges);
    EXPECT_EQ(contact.edges_after, edges);
    EXPECT_EQ(contact.why_untreated.find("1 penetration of edges is not corrected (GC109)") == 0, edges > 0);
    EXPECT_EQ(complete(run.report()), edges == 0) << height;
  }
}

// A movement that another contact asks for can push segments into each other: counted where the nodes end.
TEST(Untreated, IsCountedBeforeAndAfter) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).shell_part(3, 1);
  deck.plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 2, 2, 2, Vector(1, 1, 0.7), 5, 5);
  deck.plate(201, 3, 2, 2, Vector(0, 0, 1.71), 5, 5);
  deck.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3");
  deck.contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "2,3,3,3", "0.\n1.,1.\n2\n");
  const FixRun run = fix(deck);
  EXPECT_EQ(run.report().contacts.at(0).before.penetrations, 8U);  // four corners of each plate lie over the other one
  EXPECT_EQ(run.report().contacts.at(0).after.penetrations, 0U);
  EXPECT_EQ(run.report().contacts.at(1).before.penetrations, 0U);
  EXPECT_GT(run.report().contacts.at(1).after.penetrations, 0U);
  EXPECT_FALSE(complete(run.report()));
}

}  // namespace
}  // namespace gapcheck::audit_test::untreated_test
