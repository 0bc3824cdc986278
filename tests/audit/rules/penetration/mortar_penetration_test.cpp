#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::mortar_penetration_test {
namespace {

const std::string part_1_on_2 = "1,2,3,3", everything = "0,0,5,0";

/// Two plates of thickness 2 with 9 nodes each.
RuleDeck two_plates(double gap) {
  RuleDeck deck;
  deck.shell_part(1, 2).shell_part(2, 2).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  return deck.plate(101, 2, 2, 2, Vector(0, 0, gap), 5, 5);
}

TEST(MortarPenetration, BothSidesWithTheirShareOfTheContactDistance) {
  const Report report =
      run_rule("GC108", two_plates(1.2).contact(1, "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", part_1_on_2));
  ASSERT_EQ(report.penetrations.size(), 18U);
  EXPECT_EQ(listed(report), 18U);
  for (const Penetration& p : report.penetrations) {
    EXPECT_EQ(p.kind, PenetrationKind::mortar);
    EXPECT_EQ(p.outcome, Outcome::kept);
    EXPECT_NEAR(p.depth, 0.8, 1e-12);
    EXPECT_DOUBLE_EQ(p.contact_distance, 2);
  }
  EXPECT_EQ(report.contacts[0].mortar_penetrations, 18U);
  EXPECT_EQ(report.contacts[0].penetrations, 0U);
  EXPECT_EQ(listed(run_rule("GC108", two_plates(2).contact(1, "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", part_1_on_2))),
            0U);
}

TEST(MortarPenetration, IsNeitherAnInitialNorASegmentPenetration) {
  const RuleDeck deck = two_plates(1.2).contact(1, "AUTOMATIC_SINGLE_SURFACE_MORTAR", everything, "0.\n1.,1.\n2\n");
  EXPECT_EQ(run_rule("GC108", deck).penetrations.size(), 18U);
  for (const char* other : {"GC101", "GC107"}) {
    const Report report = run_rule(other, deck);
    EXPECT_EQ(listed(report), 0U) << other;
    EXPECT_NE(report.contacts[0].not_checked.find("mortar"), std::string::npos) << other;
  }
}

TEST(MortarPenetration, NegativeIgnoreLeavesOutSegmentsOfOnePart) {
  const auto one_part = [](int ignore) {
    RuleDeck deck;
    deck.shell_part(1, 2).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 1, 2, 2, Vector(0, 0, 1.2), 5, 5);
    return run_rule("GC108", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE_MORTAR", everything,
                                          fmt::format("0.\n1.,1.\n0\n0\n,{}\n", ignore)));
  };
  EXPECT_EQ(listed(one_part(2)), 18U);
  EXPECT_EQ(listed(one_part(-2)), 0U);
}

TEST(MortarPenetration, NothingLiesBesideAFreeEdge) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 1, 1, Vector(0, 0, 0), 5, 5);
  deck.node(101, Vector(5.8, 2.5, 0))
      .node(102, Vector(9, 0, 3))
      .node(103, Vector(9, 5, 3))
      .shell(101, 2, {101, 102, 103});
  EXPECT_EQ(listed(run_rule("GC108", deck.contact(1, "AUTOMATIC_SINGLE_SURFACE_MORTAR", everything))), 0U);
}

TEST(MortarPenetration, SolidsMeetAtTheirFacets) {
  const auto bricks = [](double bottom) {
    RuleDeck deck;
    deck.solid_part(1).solid_part(2).block(1, 1, 1, 1, 1, Vector(0, 0, 0), Vector(10, 10, 2));
    deck.block(101, 2, 1, 1, 1, Vector(4, 4, bottom), Vector(2, 2, 2));
    return run_rule("GC108", deck.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR", part_1_on_2));
  };
  const Report report = bricks(1.9);
  ASSERT_EQ(report.penetrations.size(), 4U);
  for (const Penetration& p : report.penetrations) {
    EXPECT_NEAR(p.depth, 0.1, 1e-12);
    EXPECT_EQ(p.contact_distance, 0);
  }
  EXPECT_EQ(listed(bricks(2)), 0U);
}

TEST(MortarPenetration, FormingToolsHaveNoThicknessUnlessAskedFor) {
  // Part 2 rigid: h is half of the blank's thickness alone, so that 1.2 apart they do not meet.
  const auto forming = [](const std::string& cards) {
    RuleDeck deck;
    deck.shell_part(1, 2).shell_part(2, 2, 2).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
    deck.plate(101, 2, 2, 2, Vector(0, 0, 1.2), 5, 5);
    return run_rule("GC108", deck.contact(1, "FORMING_SURFACE_TO_SURFACE_MORTAR", part_1_on_2, cards));
  };
  EXPECT_EQ(listed(forming("0.\n1.,1.\n")), 0U);
  EXPECT_EQ(listed(forming("0.\n1.,1.\n0\n,,2\n")), 0U);    // SHLTHK on card B without THKOPT = 1
  EXPECT_EQ(listed(forming("0.\n1.,1.\n0\n,1,2\n")), 18U);  // with it
}

TEST(MortarPenetration, TiesAreNone) {
  for (const char* keyword : {"AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_TIED"}) {
    const Report report = run_rule("GC108", two_plates(1.2).contact(1, keyword, part_1_on_2));
    EXPECT_EQ(listed(report), 0U) << keyword;
    EXPECT_NE(report.contacts[0].not_checked, "") << keyword;
  }
}

}  // namespace
}  // namespace gapcheck::audit_test::mortar_penetration_test
