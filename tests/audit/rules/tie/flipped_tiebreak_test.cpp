#include <algorithm>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::flipped_tiebreak_test {
namespace {

/// Part 2 consists of 2 x 2 shells in z = 0 with normals up, shell set 9; segment set 8 is the same.
RuleDeck sheet() {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).solid_part(3).plate(101, 2, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.raw("SET_SHELL_LIST", "9\n101,102,103,104\n");
  return deck.raw("SET_SEGMENT", "8\n101,102,105,104\n102,103,106,105\n104,105,108,107\n105,106,109,108\n");
}

RuleDeck& tiebreak(RuleDeck& deck, const std::string& card1, const std::string& keyword = "TIEBREAK_SURFACE_TO_SURFACE",
                   const std::string& card4 = "1.,1.\n") {
  return deck.contact(6, keyword, card1, "0.\n1.,1.\n" + card4);
}

/// Part 1 at a height above the sheet or, if negative, below it.
Report plate_at(double height, const std::string& card1 = "1,9,3,1",
                const std::string& keyword = "TIEBREAK_SURFACE_TO_SURFACE", const std::string& control = "",
                const std::string& card4 = "1.,1.\n") {
  RuleDeck deck = sheet();
  deck.plate(1, 1, 2, 2, Vector(1, 1, height), 4, 4).raw("SET_NODE_LIST", "4\n1,2,3,5\n");
  if (!control.empty()) deck.raw("CONTROL_CONTACT", control);
  return run_rule("GC212", tiebreak(deck, card1, keyword, card4));
}

bool tells(const Report& report, const std::string& text) {
  return std::any_of(report.statistics.begin(), report.statistics.end(),
                     [&](const auto& s) { return s.second.find(text) != std::string::npos; });
}

TEST(FlippedTiebreak, NodesBehindTheSegments) {
  const Report report = plate_at(-1);
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.contact, 6);
  EXPECT_EQ(f.part, 2);
  EXPECT_EQ(f.count, 4U);
  EXPECT_EQ(f.element, 101);
  ASSERT_TRUE(f.point);
  EXPECT_EQ(*f.point, Vector(2.5, 2.5, 0));
  EXPECT_NE(f.message.find("part 2: all 4 connected segments look away from the 9 nodes tied there"), std::string::npos)
      << f.message;
  EXPECT_EQ(listed(plate_at(1)), 0U);
}

// Node 50 lies near the raised corner of a segment, below its surface and above the plane of the other corners.
TEST(FlippedTiebreak, WarpedSegments) {
  const auto node_at = [](double z) {
    RuleDeck deck;
    deck.shell_part(2, 1).node(1, {0, 0, 0}).node(2, {5, 0, 0}).node(3, {5, 5, 2}).node(4, {0, 5, 0});
    deck.shell(101, 2, {1, 2, 3, 4}).node(50, {4.5, 4.5, z}).raw("SET_SHELL_LIST", "9\n101\n");
    return listed(
        run_rule("GC212", tiebreak(deck.raw("SET_NODE_LIST", "4\n50\n"), "4,9,4,1", "TIEBREAK_NODES_TO_SURFACE")));
  };
  EXPECT_EQ(node_at(1.4), 1U);  // 2 x 0.9 x 0.9 = 1.62
  EXPECT_EQ(node_at(1.8), 0U);
}

TEST(FlippedTiebreak, SegmentSetsAndNodeSets) {
  EXPECT_EQ(listed(plate_at(-1, "1,8,3,0")), 1U);
  EXPECT_EQ(listed(plate_at(1, "1,8,3,0")), 0U);
  EXPECT_EQ(listed(plate_at(-1, "4,9,4,1", "TIEBREAK_NODES_TO_SURFACE")), 1U);
  EXPECT_EQ(listed(plate_at(-1, "4,9,4,1", "TIEBREAK_NODES_ONLY")), 1U);
  EXPECT_EQ(listed(plate_at(1, "4,9,4,1", "TIEBREAK_NODES_TO_SURFACE")), 0U);
}

TEST(FlippedTiebreak, TheSolverTurnsSomeSurfaces) {
  const Report by_part = plate_at(-1, "1,2,3,3");
  EXPECT_EQ(listed(by_part), 0U);
  EXPECT_TRUE(tells(by_part, "1 tiebreaks whose segments the solver turns"));
  const std::string orien_0 = "0.1,0.,0,0,1,0,0\n", orien_2 = "0.1,0.,0,0,1,0,2\n";
  // A blank or zero ORIEN is the default, 1.
  EXPECT_EQ(listed(plate_at(-1, "1,9,3,1", "TIEBREAK_SURFACE_TO_SURFACE", orien_0)), 1U);
  EXPECT_EQ(listed(plate_at(-1, "1,9,3,1", "TIEBREAK_SURFACE_TO_SURFACE", orien_2)), 0U);
}

TEST(FlippedTiebreak, OldTypesOnly) {
  EXPECT_EQ(listed(plate_at(-1, "1,9,3,1", "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "", "2,1.,1.\n")), 0U);
  // PARAM = 1 takes the orientation; THKOFF = 1 leaves it out.
  EXPECT_EQ(listed(plate_at(-1, "1,9,3,1", "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "", "2,1.,1.,1.\n")), 1U);
  EXPECT_EQ(listed(plate_at(-1, "1,9,3,1", "TIEBREAK_SURFACE_TO_SURFACE", "", "1.,1.,0,1\n")), 0U);
  EXPECT_EQ(listed(plate_at(-1, "1,9,3,1", "TIED_SURFACE_TO_SURFACE", "", "")), 0U);
  EXPECT_EQ(listed(plate_at(-1, "1,9,3,1", "SURFACE_TO_SURFACE", "", "")), 0U);
}

TEST(FlippedTiebreak, TouchingBodiesDecideByTheirFaces) {
  const auto block = [](double z) {
    RuleDeck deck = sheet();
    return run_rule("GC212", tiebreak(deck.block(201, 3, 2, 2, 1, Vector(1, 1, z), Vector(4, 4, 3)), "3,9,3,1"));
  };
  EXPECT_EQ(listed(block(0)), 0U);   // the block stands on the sheet
  EXPECT_EQ(listed(block(-3)), 1U);  // it hangs below
  EXPECT_EQ(block(-3).findings[0].count, 4U);
}

TEST(FlippedTiebreak, CoincidentShellsCannotBeJudged) {
  const Report report = plate_at(0);
  EXPECT_EQ(listed(report), 0U);
  EXPECT_TRUE(tells(report, "1 reference surfaces of tiebreaks that coincide"));
}

TEST(FlippedTiebreak, NodesOnBothSides) {
  RuleDeck deck = sheet();
  deck.plate(1, 1, 2, 2, Vector(1, 1, 1), 4, 4).plate(51, 1, 2, 2, Vector(1, 1, -1), 4, 4);
  const Report report = run_rule("GC212", tiebreak(deck, "1,9,3,1"));
  EXPECT_EQ(listed(report), 0U);
  EXPECT_TRUE(tells(report, "1 reference surfaces of tiebreaks with tied nodes on both sides"));
}

TEST(FlippedTiebreak, EachConnectedSurfaceAlone) {
  // The second sheet is 100 away, its normals point down, and its plate lies above it.
  RuleDeck deck = sheet();
  deck.node(301, Vector(100, 0, 0)).node(302, Vector(105, 0, 0)).node(303, Vector(105, 5, 0));
  deck.node(304, Vector(100, 5, 0))
      .shell(301, 2, {301, 304, 303, 302})
      .raw("SET_SHELL_LIST", "10\n101,102,103,104,301\n");
  deck.plate(1, 1, 2, 2, Vector(1, 1, 1), 4, 4).plate(51, 1, 1, 1, Vector(101, 1, 1), 3, 3);
  const Report report = run_rule("GC212", tiebreak(deck, "1,10,3,1"));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].count, 1U);
  EXPECT_EQ(report.findings[0].element, 301);
  EXPECT_NE(report.findings[0].message.find("the segment looks away from the 4 nodes tied there"), std::string::npos)
      << report.findings[0].message;
}

TEST(FlippedTiebreak, NamesTheFirstSegmentWithNodesBehindIt) {
  // A strip of shells 101, 103, 102; nodes hang below the last two.
  RuleDeck deck;
  deck.shell_part(2, 1);
  for (int i = 0; i < 4; ++i) deck.node(1 + i, {5.0 * i, 0, 0}).node(11 + i, {5.0 * i, 5, 0});
  deck.shell(101, 2, {1, 2, 12, 11}).shell(102, 2, {3, 4, 14, 13}).shell(103, 2, {2, 3, 13, 12});
  deck.node(50, {7, 2, -0.3}).node(51, {12, 2, -0.3}).raw("SET_NODE_LIST", "4\n50,51\n");
  deck.raw("SET_SHELL_LIST", "9\n101,102,103\n");
  const Report report = run_rule("GC212", tiebreak(deck, "4,9,4,1", "TIEBREAK_NODES_TO_SURFACE"));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].element, 102);
  EXPECT_EQ(report.findings[0].count, 3U);
  EXPECT_NE(report.findings[0].message.find("away from the 2 nodes tied there"), std::string::npos)
      << report.findings[0].message;
}

TEST(FlippedTiebreak, MixedSurfacesAreLeftToTheOtherRule) {
  RuleDeck deck = sheet();
  deck.raw("SET_SEGMENT", "11\n101,104,105,102\n102,103,106,105\n104,105,108,107\n105,106,109,108\n");
  deck.plate(1, 1, 2, 2, Vector(1, 1, -1), 4, 4);
  const Report report = run_rule("GC212", tiebreak(deck, "1,11,3,0"));
  EXPECT_EQ(listed(report), 0U);
  EXPECT_TRUE(tells(report, "1 reference surfaces of tiebreaks whose segments disagree"));
}

TEST(FlippedTiebreak, FacesOfSolidsLookOutward) {
  RuleDeck deck = sheet();
  deck.block(201, 3, 2, 2, 1, Vector(0, 0, 20), Vector(5, 5, 3));
  // The lower faces of the block, with their nodes in the order that looks into it.
  deck.raw("SET_SEGMENT", "12\n201,202,205,204\n202,203,206,205\n204,205,208,207\n205,206,209,208\n");
  deck.plate(1, 1, 2, 2, Vector(1, 1, 19.8), 4, 4);
  EXPECT_EQ(listed(run_rule("GC212", tiebreak(deck, "1,12,3,0"))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::flipped_tiebreak_test
