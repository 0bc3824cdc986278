#include "audit/rules/rule_deck.hpp"
#include "base/parallel.hpp"

namespace gapcheck::audit_test::edge_penetration_test {
namespace {

const std::string everything = "0,0,5,0";

/// Two beams of diameter 2 and length 20 along x and y, the second one `height` above the first; `along`: where it
/// crosses; `material`: its own.
RuleDeck crossing_beams(double height, double along = 0, std::int64_t material = 1) {
  RuleDeck deck;
  deck.beam_part(1, 2).beam_part(2, 2, material);
  deck.node(1, Vector(-10, 0, 0)).node(2, Vector(10, 0, 0)).beam(1, 1, 1, 2);
  deck.node(101, Vector(along, -10, height)).node(102, Vector(along, 10, height)).beam(2, 2, 101, 102);
  return deck;
}

TEST(EdgePenetration, CrossingBeamsAndNoneWhenTheyTouch) {
  const Report report = run_rule("GC109", crossing_beams(1.5, 4).contact(1, "AUTOMATIC_GENERAL", everything));
  ASSERT_EQ(listed(report), 1U);
  const Penetration& p = report.penetrations.at(0);
  EXPECT_EQ(p.kind, PenetrationKind::edge);
  EXPECT_EQ(p.node, 2);  // the nearer end of beam 1
  EXPECT_EQ(p.part, 1);
  EXPECT_EQ(p.element, 2);
  EXPECT_EQ(p.element_part, 2);
  EXPECT_EQ(p.segment, (std::array<std::int64_t, 4>{101, 102, 102, 102}));
  EXPECT_DOUBLE_EQ(p.contact_distance, 2);
  EXPECT_NEAR(p.depth, 0.5, 1e-12);
  EXPECT_NEAR((p.original - Vector(4, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((p.point - Vector(4, 0, 1.5)).norm(), 0, 1e-12);
  EXPECT_NEAR(p.s, 0, 1e-12);
  EXPECT_NEAR(p.t, 0.4, 1e-12);
  EXPECT_EQ(report.contacts[0].edge_penetrations, 1U);
  EXPECT_EQ(report.contacts[0].penetrations, 0U);
  EXPECT_EQ(listed(run_rule("GC109", crossing_beams(2, 4).contact(1, "AUTOMATIC_GENERAL", everything))), 0U);
}

// Edges are forced while nodes are moved, and kept with IGNORE.
TEST(EdgePenetration, OutcomeIsThatOfTheRun) {
  for (const auto& [card_b_and_c, outcome] :
       {std::pair{"0.\n1,0\n", Outcome::forced}, std::pair{"0.,0,0,1\n1,0\n", Outcome::forced},
        std::pair{"0.\n1,1\n", Outcome::kept}}) {
    const Report report =
        run_rule("GC109", crossing_beams(1.5, 4).contact(1, "AUTOMATIC_GENERAL", everything,
                                                         std::string("0.\n1.,1.\n0\n") + card_b_and_c));
    ASSERT_EQ(report.penetrations.size(), 1U);
    EXPECT_EQ(report.penetrations[0].outcome, outcome) << card_b_and_c;
    EXPECT_EQ(report.penetrations[0].moved_to, report.penetrations[0].original);
  }
}

TEST(EdgePenetration, OnlyTypes26LookAtEdges) {
  EXPECT_EQ(listed(run_rule("GC109", crossing_beams(1.5).contact(1, "AUTOMATIC_SINGLE_SURFACE", everything))), 0U);
  EXPECT_EQ(listed(run_rule("GC109", crossing_beams(1.5).contact(1, "AUTOMATIC_GENERAL_INTERIOR", everything))), 1U);
}

// A spotweld beam counts with CPARM8 = 2 on card E, with the diameter of its section.
TEST(EdgePenetration, SpotweldBeamsCountWithCparm8) {
  const auto report = [](const std::string& cparm8) {
    RuleDeck deck = crossing_beams(1.5, 4, 9);
    deck.raw("MAT_SPOTWELD", "9,7.85e-9,210000.,0.3,300.,1000.\n\n");
    return run_rule("GC109",
                    deck.contact(1, "AUTOMATIC_GENERAL", everything, "0.\n1.,1.\n0\n0.\n0\n\n0," + cparm8 + "\n"));
  };
  EXPECT_EQ(listed(report("0")), 0U);
  const Report with = report("2");
  ASSERT_EQ(listed(with), 1U);
  EXPECT_DOUBLE_EQ(with.penetrations.at(0).contact_distance, 2);
  EXPECT_NEAR(with.penetrations.at(0).depth, 0.5, 1e-12);
}

TEST(EdgePenetration, EndsAreAMatterOfNodes) {
  // The second beam passes the end of the first one: the nearest point of beam 1 is its node 2.
  for (const double along : {10.0, 10.5})
    EXPECT_EQ(listed(run_rule("GC109", crossing_beams(1.5, along).contact(1, "AUTOMATIC_GENERAL", everything))), 0U);
  // At 9.9 it is 1.5033 away, which is as good as 1.5. At 9 it is 1.8 away: 0.15 of h = 2 less deep than the beams.
  EXPECT_EQ(listed(run_rule("GC109", crossing_beams(1.5, 9.9).contact(1, "AUTOMATIC_GENERAL", everything))), 0U);
  EXPECT_EQ(listed(run_rule("GC109", crossing_beams(1.5, 9).contact(1, "AUTOMATIC_GENERAL", everything))), 1U);
  // Where the node itself is clear the beams count however little they penetrate.
  EXPECT_EQ(listed(run_rule("GC109", crossing_beams(1.999, 9.9).contact(1, "AUTOMATIC_GENERAL", everything))), 1U);
}

TEST(EdgePenetration, BeamOverTheRimOfAPlate) {
  // h = 0.5 + 0.5, 0.6 apart; the beam is the tracked one although shells come first.
  const auto over_rim = [](double height) {
    RuleDeck deck;
    deck.shell_part(1, 1).beam_part(2, 1).plate(1, 1, 1, 1, Vector(0, 0, 0), 10, 10);
    deck.node(101, Vector(6, 5, height)).node(102, Vector(12, 5, height)).beam(101, 2, 101, 102);
    return run_rule("GC109", deck.contact(1, "AUTOMATIC_GENERAL", everything));
  };
  const Report report = over_rim(0.6);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.penetrations[0].node, 102);
  EXPECT_EQ(report.penetrations[0].element_part, 1);
  EXPECT_EQ(report.penetrations[0].segment, (std::array<std::int64_t, 4>{2, 4, 4, 4}));
  EXPECT_NEAR(report.penetrations[0].depth, 0.4, 1e-12);
  EXPECT_EQ(listed(over_rim(1)), 0U);
}

TEST(EdgePenetration, RimsOfTwoPlates) {
  // An upright plate crosses the rim of a flat one: its lower rim, at 0.5 above, from x = 8 to 12, over x = 10.
  const auto rims = [](double height) {
    RuleDeck deck;
    deck.shell_part(1, 1).shell_part(2, 0.4).plate(1, 1, 1, 1, Vector(0, 0, 0), 10, 10);
    deck.node(101, Vector(8, 5, height)).node(102, Vector(12, 5, height));
    deck.node(103, Vector(12, 5, height + 4)).node(104, Vector(8, 5, height + 4)).shell(101, 2, {101, 102, 103, 104});
    return run_rule("GC109", deck.contact(1, "AUTOMATIC_GENERAL", everything));
  };
  const Report report = rims(0.5);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NEAR(report.penetrations[0].depth, 0.2, 1e-12);
  EXPECT_NEAR(report.penetrations[0].contact_distance, 0.7, 1e-12);
  EXPECT_EQ(report.penetrations[0].part, 1);
  EXPECT_EQ(report.penetrations[0].element_part, 2);
  EXPECT_EQ(listed(rims(0.7)), 0U);
}

TEST(EdgePenetration, EdgesBetweenShellsOnlyWithInterior) {
  // A beam from the middle of one shell to the middle of the next.
  RuleDeck deck;
  deck.shell_part(1, 1).beam_part(2, 1).plate(1, 1, 2, 1, Vector(0, 0, 0), 10, 10);
  deck.node(101, Vector(5, 5, 0.8)).node(102, Vector(15, 5, 0.8)).beam(101, 2, 101, 102);
  RuleDeck interior = deck;
  EXPECT_EQ(listed(run_rule("GC109", deck.contact(1, "AUTOMATIC_GENERAL", everything))), 0U);
  const Report report = run_rule("GC109", interior.contact(1, "AUTOMATIC_GENERAL_INTERIOR", everything));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.penetrations[0].segment, (std::array<std::int64_t, 4>{2, 5, 5, 5}));
  EXPECT_NEAR(report.penetrations[0].depth, 0.2, 1e-12);
}

TEST(EdgePenetration, ParallelEdgesAreAMatterOfNodes) {
  RuleDeck deck;
  deck.beam_part(1, 2).beam_part(2, 2);
  deck.node(1, Vector(0, 0, 0)).node(2, Vector(10, 0, 0)).beam(1, 1, 1, 2);
  deck.node(101, Vector(3, 1, 1)).node(102, Vector(17, 1, 1)).beam(2, 2, 101, 102);
  RuleDeck nodes = deck;
  EXPECT_EQ(listed(run_rule("GC109", deck.contact(1, "AUTOMATIC_GENERAL", everything))), 0U);
  EXPECT_EQ(listed(run_rule("GC101", nodes.contact(1, "AUTOMATIC_GENERAL", everything))), 2U);
}

TEST(EdgePenetration, NeighboursDoNotPenetrateEachOther) {
  // A bent cable: beams 1 and 3 are 1 apart, but both hang on beam 2. Without beam 2 they penetrate.
  const auto cable = [](bool joined) {
    RuleDeck deck;
    deck.beam_part(1, 2);
    deck.node(1, Vector(-10, 0, 0)).node(2, Vector(1, 0, 0)).node(3, Vector(0, 1, 1)).node(4, Vector(0, -10, 1));
    deck.beam(1, 1, 1, 2).beam(3, 1, 3, 4);
    if (joined) deck.beam(2, 1, 2, 3);
    return run_rule("GC109", deck.contact(1, "AUTOMATIC_GENERAL", everything));
  };
  EXPECT_EQ(listed(cable(false)), 1U);
  EXPECT_EQ(listed(cable(true)), 0U);
}

TEST(EdgePenetration, ANodeIsNamedOnceWithItsDeepestPair) {
  RuleDeck deck = crossing_beams(1.5, 4);
  deck.node(201, Vector(6, -10, 1.2)).node(202, Vector(6, 10, 1.2)).beam(3, 2, 201, 202);
  const Report report = run_rule("GC109", deck.contact(1, "AUTOMATIC_GENERAL", everything));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.penetrations[0].element, 3);
  EXPECT_NEAR(report.penetrations[0].depth, 0.8, 1e-12);
}

TEST(EdgePenetration, ExcludedPartsAreLeftOut) {
  RuleDeck deck = crossing_beams(1.5).contact(1, "AUTOMATIC_GENERAL", everything);
  deck.raw("CONTACT_EXCLUDE_INTERACTION", "1,1\n1,2,3,3\n");
  EXPECT_EQ(listed(run_rule("GC109", deck)), 0U);
}

TEST(EdgePenetration, AnySearchAndAnyNumberOfThreadsGiveTheSame) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 5, 5, Vector(0, 0, 0), 5, 5);
  deck.plate(1001, 2, 7, 7, Vector(1.1, 2.3, 0.7), 3, 3).contact(1, "AUTOMATIC_GENERAL_INTERIOR", everything);
  const std::string fast = dump(run_rule("GC109", deck));
  audit::AuditOptions slow, exact;
  slow.brute_force = exact.exact = true;
  EXPECT_NE(fast.find("kind 5"), std::string::npos);
  EXPECT_EQ(dump(run_rule("GC109", deck, slow)), fast);
  EXPECT_EQ(dump(run_rule("GC109", deck, exact)), fast);
  const JobLimit one(1);
  EXPECT_EQ(dump(run_rule("GC109", deck)), fast);
}

}  // namespace
}  // namespace gapcheck::audit_test::edge_penetration_test
