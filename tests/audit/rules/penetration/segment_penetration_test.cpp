#include <set>

#include "audit/rules/rule_deck.hpp"
#include "base/parallel.hpp"

namespace gapcheck::audit_test::segment_penetration_test {
namespace {

/// Cards 2 and 3 empty, SOFT = 2 on card A.
const std::string soft_2 = "0.\n1.,1.\n2\n";

/// Two plates of thickness 1 with 9 nodes each, part 1 below part 2, all nodes over the other plate.
RuleDeck two_plates(double gap) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  return deck.plate(101, 2, 2, 2, Vector(0, 0, gap), 5, 5);
}

TEST(SegmentPenetration, EveryCornerOverTheOtherPlateAndNoneWhenApart) {
  const Report report = run_rule("GC107", two_plates(0.7).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", soft_2));
  ASSERT_EQ(report.penetrations.size(), 18U);
  EXPECT_EQ(listed(report), 18U);
  for (const Penetration& p : report.penetrations) {
    EXPECT_EQ(p.kind, PenetrationKind::segment);
    EXPECT_EQ(p.outcome, Outcome::kept);
    EXPECT_NEAR(p.depth, 0.3, 1e-12);
    EXPECT_DOUBLE_EQ(p.contact_distance, 1);
    EXPECT_EQ(p.moved_to, p.original);
  }
  EXPECT_EQ(report.contacts[0].segment_penetrations, 18U);
  EXPECT_EQ(report.contacts[0].penetrations, 0U);
  EXPECT_EQ(report.contacts[0].not_checked, "");
  const Report apart = run_rule("GC107", two_plates(1).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", soft_2));
  EXPECT_EQ(listed(apart), 0U);
  EXPECT_EQ(apart.contacts[0].not_checked, "");
}

TEST(SegmentPenetration, IsNeverAnInitialPenetration) {
  const Report report = run_rule("GC101", two_plates(0.7).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", soft_2));
  EXPECT_EQ(listed(report), 0U);
  EXPECT_NE(report.contacts[0].not_checked.find("SOFT = 2"), std::string::npos);
}

TEST(SegmentPenetration, OneWayTypesAreSearchedBothWays) {
  const std::string part_1_on_2 = "1,2,3,3";
  const Report report =
      run_rule("GC107", two_plates(0.7).contact(1, "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", part_1_on_2, soft_2));
  EXPECT_EQ(report.penetrations.size(), 18U);
  std::size_t of_part_2 = 0;
  for (const Penetration& p : report.penetrations) of_part_2 += p.part == 2 && p.element_part == 1;
  EXPECT_EQ(of_part_2, 9U);
}

TEST(SegmentPenetration, OldTypesAreTwoSidedToo) {
  // Part 1 as the reference side, with normals towards part 2; part 2 below it is behind them.
  const std::string soft_2_with_thickness = "0.\n1.,1.\n2\n,1,1\n";
  for (const double gap : {0.7, -0.7}) {
    const Report report =
        run_rule("GC107", two_plates(gap).contact(1, "SURFACE_TO_SURFACE", "2,1,3,3", soft_2_with_thickness));
    EXPECT_EQ(report.penetrations.size(), 18U) << gap;
    for (const Penetration& p : report.penetrations) EXPECT_NEAR(p.depth, 0.3, 1e-12);
  }
}

TEST(SegmentPenetration, TypesWithoutSoft2ListNodesAsUsual) {
  const RuleDeck deck = two_plates(0.7).contact(1, "AUTOMATIC_NODES_TO_SURFACE", "1,2,3,3", soft_2);
  EXPECT_EQ(listed(run_rule("GC107", deck)), 0U);
  EXPECT_EQ(listed(run_rule("GC101", deck)), 9U);
}

TEST(SegmentPenetration, CornersInsideASolidAreAsDeepAsTheyLieBelowItsFace) {
  // The upper brick's four lower corners are 0.2 inside the lower one, over the middle of its top face.
  const auto bricks = [](double bottom) {
    RuleDeck deck;
    deck.solid_part(1).solid_part(2).block(1, 1, 1, 1, 1, Vector(0, 0, 0), Vector(10, 10, 2));
    deck.block(101, 2, 1, 1, 1, Vector(4, 4, bottom), Vector(2, 2, 2));
    return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", soft_2);
  };
  const Report report = run_rule("GC107", bricks(1.8));
  ASSERT_EQ(report.penetrations.size(), 4U);
  std::set<std::int64_t> nodes;
  for (const Penetration& p : report.penetrations) {
    EXPECT_NEAR(p.depth, 0.2, 1e-12);
    EXPECT_EQ(p.part, 2);
    nodes.insert(p.node);
  }
  EXPECT_EQ(nodes, (std::set<std::int64_t>{101, 102, 103, 104}));
  EXPECT_EQ(listed(run_rule("GC107", bricks(2))), 0U);
}

TEST(SegmentPenetration, BeamsAreNoSegments) {
  RuleDeck deck;
  deck.shell_part(1, 1).beam_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.node(101, Vector(2, 2, 0.6)).node(102, Vector(8, 2, 0.6)).beam(101, 2, 101, 102);
  RuleDeck soft_1 = deck;
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", soft_2);
  soft_1.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  EXPECT_EQ(listed(run_rule("GC107", deck)), 0U);
  EXPECT_EQ(listed(run_rule("GC101", soft_1)), 2U);
}

TEST(SegmentPenetration, NodesWithoutSegmentsAreHeldAgainstTheOtherSide) {
  RuleDeck deck = two_plates(0.7).raw("SET_NODE_LIST", "5\n1,2,3\n");
  const Report report = run_rule("GC107", deck.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "5,2,4,3", soft_2));
  ASSERT_EQ(listed(report), 3U);
  EXPECT_NEAR(report.penetrations[0].depth, 0.3, 1e-12);
}

TEST(SegmentPenetration, FacetsThatTouchToTheDigitsOfTheDeckDoNotPenetrate) {
  // Bricks of size 2 whose faces overlap by 1e-8 and by 1e-4.
  const auto bricks = [](double bottom, double ptol = -1) {
    RuleDeck deck;
    deck.solid_part(1).solid_part(2).block(1, 1, 1, 1, 1, Vector(0, 0, 0), Vector(10, 10, 2));
    deck.block(101, 2, 1, 1, 1, Vector(4, 4, bottom), Vector(2, 2, 2));
    audit::AuditOptions options;
    options.ptol = ptol;
    return listed(run_rule("GC107", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", soft_2), options));
  };
  EXPECT_EQ(bricks(2 - 1e-8), 0U);
  EXPECT_EQ(bricks(2 - 1e-8, 0), 4U);
  EXPECT_EQ(bricks(2 - 1e-4), 4U);
}

TEST(SegmentPenetration, BesideAFreeEdgeCountsUnlessEdgesAreSquare) {
  // In the plane of the plate, 0.8 beyond its edge: within the band, h = 1.
  const auto beside = [](const std::string& cards) {
    RuleDeck deck;
    deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 1, 1, Vector(0, 0, 0), 5, 5);
    deck.node(101, Vector(5.8, 2.5, 0))
        .node(102, Vector(9, 0, 3))
        .node(103, Vector(9, 5, 3))
        .shell(101, 2, {101, 102, 103});
    return run_rule("GC107", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", cards));
  };
  const Report round = beside(soft_2);
  ASSERT_EQ(round.penetrations.size(), 1U);
  EXPECT_EQ(round.penetrations[0].node, 101);
  EXPECT_NEAR(round.penetrations[0].depth, 0.2, 1e-12);
  EXPECT_EQ(listed(beside(soft_2 + "0\n0\n,,,,,,,1\n")), 0U);  // SHLEDG on card D
}

TEST(SegmentPenetration, SeesWhereEarlierContactsHaveMovedTheNodes) {
  RuleDeck deck = two_plates(0.7);
  deck.contact(1, "AUTOMATIC_NODES_TO_SURFACE", "1,2,3,3");
  deck.contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", soft_2);
  EXPECT_EQ(listed(run_rule("GC107", deck)), 0U);
}

TEST(SegmentPenetration, AnySearchAndAnyNumberOfThreadsGiveTheSame) {
  const RuleDeck deck = two_plates(0.7).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", soft_2);
  const std::string fast = dump(run_rule("GC107", deck));
  EXPECT_NE(fast.find("node 101 part 2"), std::string::npos) << fast;
  audit::AuditOptions slow, exact;
  slow.brute_force = exact.exact = true;
  EXPECT_EQ(dump(run_rule("GC107", deck, slow)), fast);
  EXPECT_EQ(dump(run_rule("GC107", deck, exact)), fast);
  const JobLimit one(1);
  EXPECT_EQ(dump(run_rule("GC107", deck)), fast);
}

}  // namespace
}  // namespace gapcheck::audit_test::segment_penetration_test
