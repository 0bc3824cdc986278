// Penetrations that are not of nodes in segments: SOFT = 2, mortar, edges, rigid walls, bodies in bodies.
#include "audit/fix/run_fix.hpp"
#include "audit/rules/rule_deck.hpp"
#include "audit/run.hpp"

namespace gapcheck::audit_test::other_penetrations_test {
namespace {

FixRun fix(const RuleDeck& deck) { return fix_text(deck.text()); }

/// Two square plates of 3 x 3 shells with thickness 1, `gap` apart, in one contact.
RuleDeck plates(double gap, const std::string& keyword, const std::string& card_a = "") {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1);
  deck.plate(1, 1, 3, 3, Vector(0, 0, 0), 5, 5).plate(101, 2, 3, 3, Vector(1, 1, gap), 5, 5);
  return deck.contact(1, keyword, "0,0,5,0", "0.\n1.,1.\n" + card_a);
}

std::size_t left(const std::string& rule, const std::string& text) { return listed(run_rule(rule, text)); }

// The plates have 0.3 to go. Were the side of a single node wrong, the plates would cross, and the move would be
// larger.
TEST(FixOtherPenetrations, SegmentsInSegments) {
  for (const auto& [keyword, cards, rule] :
       {std::tuple("AUTOMATIC_SINGLE_SURFACE", "2\n", "GC107"), std::tuple("SURFACE_TO_SURFACE", "2\n", "GC107"),
        std::tuple("AUTOMATIC_SINGLE_SURFACE_MORTAR", "", "GC108")}) {
    RuleDeck deck = plates(0.7, keyword, cards);
    if (std::string(keyword) == "SURFACE_TO_SURFACE") {
      deck = RuleDeck();
      deck.shell_part(1, 1).shell_part(2, 1);
      deck.plate(1, 1, 3, 3, Vector(0, 0, 0), 5, 5).plate(101, 2, 3, 3, Vector(1, 1, 0.7), 5, 5);
      deck.contact(1, keyword, "1,2,3,3", "0.\n1.,1.\n2\n").raw("CONTROL_CONTACT", "0,0,0,1,2\n");
    }
    ASSERT_EQ(left(rule, deck.text()), 18U) << keyword;  // nine corners of each plate lie over the other one
    const FixRun run = fix(deck);
    const FixContact& contact = run.report().contacts.at(0);
    EXPECT_TRUE(contact.by_segments);
    EXPECT_EQ(contact.before.penetrations, 18U);
    EXPECT_NEAR(contact.before.deepest, 0.3, 1e-12);
    EXPECT_EQ(contact.after.penetrations, 0U) << keyword;
    EXPECT_TRUE(complete(run.report())) << keyword;
    EXPECT_EQ(left(rule, run.text), 0U) << keyword;
    EXPECT_GT(run.report().largest_move, 0.1);
    EXPECT_LT(run.report().largest_move, 0.3);
    EXPECT_EQ(run.report().crossings_after, 0U);
    EXPECT_TRUE(complete(fix(plates(1.1, "AUTOMATIC_SINGLE_SURFACE", "2\n")).report()));
  }
}

// Mid-surfaces in one plane: neither plate knows a side, but all nodes of one must take the same.
TEST(FixOtherPenetrations, PlatesInOnePlanePart) {
  for (const char* cards : {"2\n", "1\n"}) {
    const RuleDeck deck = plates(0, "AUTOMATIC_SINGLE_SURFACE", cards);
    const FixRun run = fix(deck);
    EXPECT_TRUE(complete(run.report())) << cards;
    for (const MovedNode& node : run.report().moved) {
      const double up = node.to.z() - node.from.z();
      if (std::abs(up) < 0.2) continue;
      EXPECT_EQ(up > 0, node.node > 100) << cards << node.node;
    }
  }
}

TEST(FixOtherPenetrations, PressFitsOfMortarContactStay) {
  // Card C: IGAP, IGNORE.
  const RuleDeck deck = plates(0.7, "AUTOMATIC_SINGLE_SURFACE_MORTAR", "\n\n1,3\n");
  const FixRun run = fix(deck);
  EXPECT_TRUE(run.report().moved.empty());
  EXPECT_TRUE(complete(run.report()));
  EXPECT_NE(run.report().contacts.at(0).not_checked.find("IGNORE = 3"), std::string::npos);
}

/// Two beams of diameter 2 that cross at right angles, 0.2 and 0.1 of their length from the middle.
RuleDeck beams(double height, bool turned = false) {
  RuleDeck deck;
  deck.beam_part(1, 2).beam_part(2, 2);
  deck.node(1, Vector(-10, 0, 0)).node(2, Vector(10, 0, 0)).beam(1, 1, 1, 2);
  deck.node(101, Vector(4, -8, height)).node(102, Vector(4, 12, height));
  if (turned)
    deck.beam(2, 2, 102, 101);
  else
    deck.beam(2, 2, 101, 102);
  return deck.contact(1, "AUTOMATIC_GENERAL", "0,0,5,0");
}

// The closed form: with u = a beam's moves at its ends, w the weights, the gap grows by Σ s u = p. The least Σ w u²
// gives each end p s / (w Σ s²/w); here all four ends weigh the same.
TEST(FixOtherPenetrations, CrossedBeamsPartByTheLeastMovement) {
  for (const bool turned : {false, true}) {
    const RuleDeck deck = beams(1.5, turned);
    ASSERT_EQ(left("GC109", deck.text()), 1U);
    const FixRun run = fix(deck);
    EXPECT_EQ(run.report().contacts.at(0).edges_before, 1U);
    EXPECT_EQ(run.report().contacts.at(0).edges_after, 0U);
    EXPECT_TRUE(complete(run.report()));
    EXPECT_EQ(left("GC109", run.text), 0U);
    const double p = 0.5 * 1.002;
    const std::map<std::int64_t, double> share{{1, -0.3}, {2, -0.7}, {101, 0.6}, {102, 0.4}};
    double sum = 0;
    for (const auto& [node, s] : share) sum += s * s;
    for (const auto& [node, s] : share) EXPECT_NEAR(run.move(node).z(), p * s / sum, 2e-4) << node << turned;
  }
  EXPECT_TRUE(fix(beams(2.5)).report().moved.empty());
}

TEST(FixOtherPenetrations, TheSideOfEdgesIsKept) {
  const FixRun below = fix(beams(-1.5));
  EXPECT_TRUE(complete(below.report()));
  EXPECT_LT(below.move(101).z(), 0);
  EXPECT_GT(below.move(2).z(), 0);
  // Exactly in each other (GC104): the part with the higher id goes up.
  ASSERT_EQ(left("GC104", beams(0).text()), 1U);
  const FixRun crossed = fix(beams(0));
  EXPECT_TRUE(complete(crossed.report()));
  EXPECT_GT(crossed.move(101).z(), 0);
  EXPECT_EQ(left("GC104", crossed.text), 0U);
}

// Two strips that cross in one plane, with no node in the other: only their edges do (SOFT = 2, DEPTH = 5). The contact
// distance is 0.4 of their shortest edge.
TEST(FixOtherPenetrations, StripsThatCrossInOnePlane) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1);
  deck.plate(1, 1, 1, 1, Vector(-10, -1, 0), 20, 2).plate(101, 2, 1, 1, Vector(-1, -10, 0), 2, 20);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", "0.\n1.,1.\n2,0,0,0,0,5\n");
  ASSERT_EQ(left("GC104", deck.text()), 4U);
  const FixRun run = fix(deck);
  EXPECT_GT(run.report().contacts.at(0).edges_before, 0U);
  EXPECT_TRUE(complete(run.report()));
  EXPECT_EQ(left("GC104", run.text), 0U);
  for (const std::int64_t node : {101, 102, 103, 104}) EXPECT_NEAR(run.move(node).z(), 0.4008, 1e-6) << node;
  for (const std::int64_t node : {1, 2, 3, 4}) EXPECT_NEAR(run.move(node).z(), -0.4008, 1e-6) << node;
}

TEST(FixOtherPenetrations, NodesLeaveRigidWalls) {
  const std::string plane = "0,0,0,0\n0.,0.,0.,0.,0.,1.\n", off = "0,0,0,0\n0.,0.,-1.,0.,0.,1.\n";
  const auto deck = [](double z, const std::string& wall) {
    RuleDeck d;
    d.shell_part(1, 0.5);
    d.plate(1, 1, 3, 3, Vector(0, 0, z), 5, 5);
    return d.raw("RIGIDWALL_PLANAR", wall);
  };
  ASSERT_EQ(left("GC110", deck(-0.2, plane).text()), 11U);  // ten, and one for the others
  const FixRun run = fix(deck(-0.2, plane));
  ASSERT_EQ(run.report().walls.size(), 1U);
  EXPECT_EQ(run.report().walls[0].before.penetrations, 16U);
  EXPECT_NEAR(run.report().walls[0].before.deepest, 0.2, 1e-12);
  EXPECT_EQ(run.report().walls[0].after.penetrations, 0U);
  EXPECT_TRUE(complete(run.report()));
  for (const MovedNode& node : run.report().moved) EXPECT_NEAR(node.to.z(), 0, 1e-3);
  EXPECT_EQ(run.report().moved.size(), 16U);
  EXPECT_EQ(left("GC110", run.text), 0U);
  EXPECT_TRUE(fix(deck(-0.2, off)).report().walls.empty());

  audit::FixOptions locked;
  locked.locks = {{true, 6, 6}};
  const FixRun held = fix_text(deck(-0.2, plane).text(), locked);
  ASSERT_EQ(held.report().walls.at(0).unfixed.size(), 1U);
  EXPECT_EQ(held.report().walls[0].unfixed[0].node, 6);
  EXPECT_EQ(held.report().walls[0].unfixed[0].reason, HoldReason::locked);
  EXPECT_FALSE(complete(held.report()));
}

// A cylinder of radius 4 along y, with its axis 3.9 below a sheet: each node moves radially, and rests on the mantle.
TEST(FixOtherPenetrations, NodesLeaveRoundWalls) {
  RuleDeck deck;
  deck.shell_part(1, 0.5);
  deck.plate(1, 1, 8, 2, Vector(-4, 0, 0), 1, 3);
  deck.raw("RIGIDWALL_GEOMETRIC_CYLINDER", "0,0,0,0\n0.,-5.,-3.9,0.,1.,-3.9\n4.,0.\n");
  ASSERT_GT(left("GC110", deck.text()), 0U);
  const FixRun run = fix(deck);
  EXPECT_TRUE(complete(run.report()));
  EXPECT_EQ(left("GC110", run.text), 0U);
  for (const MovedNode& node : run.report().moved) EXPECT_GE(std::hypot(node.to.x(), node.to.z() + 3.9), 4 - 1e-8);
  EXPECT_LT(run.report().largest_move, 0.11);
}

// A wall below and a sheet above, both too near: the sheet between them goes up, and the upper one too.
TEST(FixOtherPenetrations, WallsAndContactsAtOnce) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1);
  deck.plate(1, 1, 3, 3, Vector(0, 0, -0.1), 5, 5).plate(101, 2, 3, 3, Vector(1, 1, 0.7), 5, 5);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0").raw("RIGIDWALL_PLANAR", "0,0,0,0\n0.,0.,0.,0.,0.,1.\n");
  const FixRun run = fix(deck);
  EXPECT_TRUE(complete(run.report()));
  for (const MovedNode& node : run.report().moved) EXPECT_GE(node.to.z(), -1e-8);
  EXPECT_EQ(left("GC110", run.text) + left("GC101", run.text), 0U);
}

TEST(FixOtherPenetrations, BodiesInBodiesAreNamed) {
  RuleDeck deck;
  deck.solid_part(1).solid_part(2);
  deck.block(1, 1, 2, 2, 2, Vector(0, 0, 0), Vector(5, 5, 5)).block(101, 2, 1, 1, 1, Vector(4, 4, 4), Vector(2, 2, 2));
  deck.contact(7, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  const FixReport report = fix(deck).report();
  ASSERT_EQ(report.enclosed.size(), 1U);
  EXPECT_EQ(report.enclosed[0].part, 2);
  EXPECT_EQ(report.enclosed[0].outer_part, 1);
  EXPECT_EQ(report.enclosed[0].solids, 1U);
  EXPECT_EQ(report.enclosed[0].element, 101);
  EXPECT_FALSE(complete(report));
}

// Two contacts of different kinds at once: both are clear at the end.
TEST(FixOtherPenetrations, SeveralContactsAtOnce) {
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
  EXPECT_EQ(run.report().contacts.at(1).after.penetrations, 0U);
  EXPECT_TRUE(complete(run.report()));
}

}  // namespace
}  // namespace gapcheck::audit_test::other_penetrations_test
