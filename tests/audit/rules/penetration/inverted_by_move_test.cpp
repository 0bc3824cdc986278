#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::inverted_by_move_test {
namespace {

/// A plate of 10 x 10 shells, 1 thick, at z = 0; part 2 above it, of which the nodes in `tied` tie to the plate.
RuleDeck plate_with_tie(const std::string& tied, const std::string& type = "TIED_NODES_TO_SURFACE") {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  return deck.raw("SET_NODE_LIST", "7\n" + tied).contact(3, type, "7,1,4,3");
}

/// A brick of 2 x 2 x 0.2 whose lower nodes 101 to 104 are at z = 0.3.
RuleDeck with_brick(RuleDeck deck) {
  return deck.solid_part(2).block(101, 2, 1, 1, 1, Vector(3, 4, 0.3), Vector(2, 2, 0.2));
}

TEST(InvertedByMove, TheUpperNodesOfABrickTiedBelowItsLowerOnes) {
  const Report report = run_rule("GC114", with_brick(plate_with_tie("105,106,107,108")));
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.severity, Severity::error);
  EXPECT_EQ(f.element, 101);
  EXPECT_EQ(f.part, 2);
  EXPECT_EQ(f.contact, 3);
  EXPECT_EQ(f.message,
            "solid 101 is turned inside out: the tie moves its node 105 by 0.5; volume 0.8 before, -1.2 after: correct "
            "the geometry there, or tie with an offset");
}

TEST(InvertedByMove, AllNodesInOnePlane) {
  const Report report = run_rule("GC114", with_brick(plate_with_tie("101,102,103,104,105,106,107,108")));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("solid 101 is flattened"), std::string::npos) << report.findings[0].message;
  EXPECT_NE(report.findings[0].message.find("volume 0.8 before, 0 after"), std::string::npos);
}

TEST(InvertedByMove, NotWhatGrowsStaysOrIsTiedWithAnOffset) {
  EXPECT_EQ(listed(run_rule("GC114", with_brick(plate_with_tie("101,102,103,104")))), 0U);
  EXPECT_EQ(listed(run_rule("GC114", with_brick(plate_with_tie("105,106,107,108", "TIED_NODES_TO_SURFACE_OFFSET")))),
            0U);
}

TEST(InvertedByMove, AShellOnItsEdge) {
  RuleDeck deck = plate_with_tie("103,104");
  deck.shell_part(2, 0.1);
  deck.node(101, Vector(3, 4, 0.3)).node(102, Vector(5, 4, 0.3));
  deck.node(103, Vector(5, 4, 0.5)).node(104, Vector(3, 4, 0.5)).shell(201, 2, {101, 102, 103, 104});
  const Report report = run_rule("GC114", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("shell 201 is turned inside out"), std::string::npos);
  EXPECT_NE(report.findings[0].message.find("area 0.4 before, -0.6 after"), std::string::npos)
      << report.findings[0].message;
}

TEST(InvertedByMove, AShellThatBecomesALine) {
  RuleDeck deck = plate_with_tie("101,102,103,104");
  deck.shell_part(2, 0.1);
  deck.node(101, Vector(3, 4, 0.25)).node(102, Vector(5, 4, 0.25));
  deck.node(103, Vector(5, 4, 0.5)).node(104, Vector(3, 4, 0.5)).shell(201, 2, {101, 102, 103, 104});
  const Report report = run_rule("GC114", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("shell 201 is flattened: the tie moves its node 103 by 0.5; area 0.5 "
                                            "before, 0 after"),
            std::string::npos)
      << report.findings[0].message;
}

// Lower nodes at 0.3 and upper ones at 0.45 are all moved to the surface at 0.501 and beyond, by 1.002 times their
// depth.
TEST(InvertedByMove, AThinBrickWithinTheContactDistance) {
  const auto deck = [](const std::string& more) {
    RuleDeck d;
    d.shell_part(1, 1).solid_part(2).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
    d.block(101, 2, 1, 1, 1, Vector(3, 4, 0.3), Vector(2, 2, 0.15));
    return d.contact(5, "AUTOMATIC_NODES_TO_SURFACE", "2,1,3,3", "0.\n1.,1.\n0\n" + more);
  };
  const Report report = run_rule("GC114", deck(""));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].contact, 5);
  EXPECT_NE(report.findings[0].message.find("the contact moves its node"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC114", deck("0.,0,0,0\n1,1\n"))), 0U);  // IGNORE = 1 moves nothing
}

// The same nodes penetrate in a contact before the tie, which leaves them where they are.
TEST(InvertedByMove, ByTheTieAndNotByAContactThatKeepsItsNodes) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(4, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 10, 10);
  deck.plate(401, 4, 1, 1, Vector(2, 3, 0.9), 6, 6).raw("SET_NODE_LIST", "7\n105,106,107,108\n");
  deck.contact(1, "AUTOMATIC_NODES_TO_SURFACE", "7,4,4,3", "0.\n1.,1.\n0\n0.,0,0,0\n1,1\n");
  deck = with_brick(deck.contact(3, "TIED_NODES_TO_SURFACE", "7,1,4,3"));
  EXPECT_EQ(run_rule("GC101", deck).penetrations.size(), 4U);
  const Report report = run_rule("GC114", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].contact, 3);
  EXPECT_NE(report.findings[0].message.find("the tie moves its node 105 by 0.5"), std::string::npos)
      << report.findings[0].message;
}

TEST(InvertedByMove, AnElementThatWasInvertedBeforeIsNotTheMovesFault) {
  RuleDeck deck = plate_with_tie("105,106,107,108");
  deck.solid_part(2);
  const auto node = [&](std::int64_t id, double x, double y, double z) { deck.node(id, Vector(x, y, z)); };
  node(101, 3, 4, 0.5), node(102, 5, 4, 0.5), node(103, 5, 6, 0.5), node(104, 3, 6, 0.5);
  node(105, 3, 4, 0.3), node(106, 5, 4, 0.3), node(107, 5, 6, 0.3), node(108, 3, 6, 0.3);
  deck.solid(1, 2, {101, 102, 103, 104, 105, 106, 107, 108});
  EXPECT_EQ(listed(run_rule("GC114", deck)), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::inverted_by_move_test
