#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::overlapping_contacts_test {
namespace {

/// Three plates one above the other, part sets 12 = {1, 2}, 23 = {2, 3}, 30 = {3}.
RuleDeck plates() {
  RuleDeck deck;
  for (int p = 1; p <= 3; ++p) deck.shell_part(p, 1).plate(100 * p + 1, p, 2, 2, Vector(0, 0, 9 * p), 5, 5);
  return deck.raw("SET_PART_LIST", "12\n1,2\n").raw("SET_PART_LIST", "23\n2,3\n").raw("SET_PART_LIST", "30\n3\n");
}

TEST(OverlappingContacts, SurfaceToSurfaceInsideTheGlobalContact) {
  RuleDeck deck = plates();
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5").contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "1,23,3,2");
  const Report report = run_rule("GC422", deck);
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.contact, 2);
  EXPECT_EQ(f.part, 1);
  EXPECT_EQ(f.element_part, 2);
  EXPECT_EQ(f.count, 2U);
  EXPECT_NE(f.message.find("parts 1 and 2 and 1 more pairs are in contact 1 already"), std::string::npos) << f.message;
  deck.raw("CONTACT_EXCLUDE_INTERACTION", "9,1\n1,23,3,2\n");
  EXPECT_EQ(listed(run_rule("GC422", deck)), 0U);
}

TEST(OverlappingContacts, TwoSingleSurfaces) {
  RuleDeck both = plates();
  both.contact(1, "AUTOMATIC_SINGLE_SURFACE", "12,0,2").contact(2, "AUTOMATIC_SINGLE_SURFACE", "12,0,2");
  const Report report = run_rule("GC422", both);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].count, 3U);  // 1-1, 1-2, 2-2
  RuleDeck apart = plates();
  apart.contact(1, "AUTOMATIC_SINGLE_SURFACE", "12,0,2").contact(2, "AUTOMATIC_SINGLE_SURFACE", "30,0,2");
  EXPECT_EQ(listed(run_rule("GC422", apart)), 0U);
}

TEST(OverlappingContacts, ExchangedSidesTiesAndTimes) {
  RuleDeck exchanged = plates();
  exchanged.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3").contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3");
  EXPECT_EQ(listed(run_rule("GC422", exchanged)), 1U);
  RuleDeck chain = plates();
  chain.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3").contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "2,3,3,3");
  EXPECT_EQ(listed(run_rule("GC422", chain)), 0U);
  RuleDeck tied = plates();
  tied.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5").contact(2, "TIED_SURFACE_TO_SURFACE", "1,2,3,3");
  tied.contact(3, "FORCE_TRANSDUCER_PENALTY", "1,2,3,3");
  EXPECT_EQ(listed(run_rule("GC422", tied)), 0U);
  RuleDeck later = plates();
  later.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", ",,,,,,0.,0.1\n1.,1.\n");
  later.contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", ",,,,,,0.1,0.2\n1.,1.\n");
  EXPECT_EQ(listed(run_rule("GC422", later)), 0U);
}

// Two segment sets of the same parts: only where they have segments in common.
TEST(OverlappingContacts, PiecesOfParts) {
  for (const bool same : {true, false}) {
    RuleDeck deck = plates();
    deck.raw("SET_SEGMENT", "1\n101,102,105,104\n").raw("SET_SEGMENT", "2\n201,202,205,204\n");
    deck.raw("SET_SEGMENT", same ? "3\n101,102,105,104\n" : "3\n102,103,106,105\n")
        .raw("SET_SEGMENT", "4\n201,202,205,204\n");
    deck.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,0,0").contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "3,4,0,0");
    EXPECT_EQ(listed(run_rule("GC422", deck)), same ? 1U : 0U);
  }
}

}  // namespace
}  // namespace gapcheck::audit_test::overlapping_contacts_test
