#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::crossed_edges_test {
namespace {

/// Two beams at right angles, the second one at a height, its middle `along` the first.
RuleDeck beams(double height, double along = 5) {
  RuleDeck deck;
  deck.beam_part(1, 2).beam_part(2, 2).node(1, {0, 0, 0}).node(2, {10, 0, 0});
  deck.node(3, {along, -5, height}).node(4, {along, 5, height}).beam(11, 1, 1, 2).beam(12, 2, 3, 4);
  return deck;
}

std::size_t found(RuleDeck deck, const std::string& keyword, const std::string& card,
                  const std::string& cards = "0.\n1.,1.\n") {
  return listed(run_rule("GC104", deck.contact(1, keyword, card, cards)));
}

TEST(CrossedEdges, BeamsThatCross) {
  RuleDeck deck = beams(0);
  const Report report = run_rule("GC104", deck.contact(1, "AUTOMATIC_GENERAL", "0,0,5,0"));
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.element, 11);
  EXPECT_EQ(f.element_part, 1);
  EXPECT_EQ(f.part, 2);
  EXPECT_LT((*f.point - Vector(5, 0, 0)).norm(), 1e-12);
  EXPECT_NE(f.message.find("beam 11 (part 1) and beam 12 (part 2)"), std::string::npos) << f.message;
}

TEST(CrossedEdges, ApartTouchingOrInAnotherContactTheyDoNot) {
  EXPECT_EQ(found(beams(0.1), "AUTOMATIC_GENERAL", "0,0,5,0"), 0U);
  EXPECT_EQ(found(beams(0, 0), "AUTOMATIC_GENERAL", "0,0,5,0"), 0U) << "at the end of the other";
  EXPECT_EQ(found(beams(0), "AUTOMATIC_GENERAL", "1,0,3,0"), 0U);
  EXPECT_EQ(found(beams(0), "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0"), 0U);
  EXPECT_EQ(found(beams(0).raw("CONTACT_EXCLUDE_INTERACTION", "1\n1,2,3,3\n"), "AUTOMATIC_GENERAL", "0,0,5,0"), 0U);
}

/// Two plates of 2 x 2 elements of 10, the second one 15 and 5 farther, at a height.
RuleDeck plates(double height) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  return deck.plate(101, 2, 2, 2, Vector(15, 5, height), 10, 10);
}

TEST(CrossedEdges, PlatesThatOverlapInOnePlane) {
  // Corner over corner: the rim at x = 20 crosses the one at y = 5, and y = 20 the one at x = 15.
  EXPECT_EQ(found(plates(0), "AUTOMATIC_GENERAL", "0,0,5,0"), 2U);
  EXPECT_EQ(found(plates(0.01), "AUTOMATIC_GENERAL", "0,0,5,0"), 0U);
  // Type i26 also takes the edges between shells: x = 20 crosses y = 5 and y = 15 (20 and 10 long), y = 20 and y = 10
  // cross x = 15.
  EXPECT_EQ(found(plates(0), "AUTOMATIC_GENERAL_INTERIOR", "0,0,5,0"), 4U);
}

TEST(CrossedEdges, SegmentBasedContactsByTheirDepth) {
  const auto with = [](int soft, int depth) {
    return found(plates(0), "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3",
                 "0.\n1.,1.\n" + std::to_string(soft) + ",,,,," + std::to_string(depth) + "\n");
  };
  EXPECT_EQ(with(2, 5), 2U);
  EXPECT_EQ(with(2, 35), 2U);
  EXPECT_EQ(with(2, 3), 0U);
  EXPECT_EQ(with(2, 2), 0U);
  EXPECT_EQ(with(1, 5), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::crossed_edges_test
