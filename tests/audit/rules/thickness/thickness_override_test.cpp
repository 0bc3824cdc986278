#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::thickness_override_test {
namespace {

// Two plates of nine nodes each with this thickness and gap; card 3 of the contact from SST on.
RuleDeck plates(double thickness, double gap, const std::string& card3,
                const std::string& type = "AUTOMATIC_SINGLE_SURFACE") {
  RuleDeck deck;
  deck.shell_part(1, thickness).shell_part(2, thickness).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 2, 2, Vector(0, 0, gap), 5, 5);
  const bool single = type == "AUTOMATIC_SINGLE_SURFACE";
  return deck.contact(1, type, single ? "0,0,5,0" : "1,2,3,3", "0.\n1.,1.," + card3 + "\n");
}

TEST(ThicknessOverride, SstThatMakesThePenetrations) {
  const Report report = run_rule("GC301", plates(0.25, 0.5, "1.,1."));
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.count, 18U);
  EXPECT_DOUBLE_EQ(f.contact_distance, 1);
  EXPECT_DOUBLE_EQ(f.penetration, 0.5);
  EXPECT_NE(f.message.find("SST = 1 where the elements have 0.25: 18 of 18 penetrations exist only by it"),
            std::string::npos)
      << f.message;
}

TEST(ThicknessOverride, NotWhereTheElementsWouldPenetrateAsWell) {
  EXPECT_EQ(listed(run_rule("GC301", plates(0.25, 0.24, "1.,1."))), 0U);
  EXPECT_EQ(listed(run_rule("GC301", plates(0.25, 0.25, "1.,1."))), 1U);  // touching is not a penetration
}

TEST(ThicknessOverride, NotNearTheRealThicknessAndNotWithoutPenetrations) {
  EXPECT_EQ(listed(run_rule("GC301", plates(0.5, 0.75, "1.,1."))), 0U);  // twice is not more than twice
  EXPECT_EQ(listed(run_rule("GC301", plates(0.49, 0.75, "1.,1."))), 1U);
  EXPECT_EQ(listed(run_rule("GC301", plates(0.25, 1.5, "1.,1."))), 0U);
}

TEST(ThicknessOverride, SstThatHidesPenetrations) {
  const Report report = run_rule("GC301", plates(1, 0.7, "0.1,0.1"));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].count, 18U);
  EXPECT_NEAR(report.findings[0].penetration, 0.3, 1e-12);
  EXPECT_NE(report.findings[0].message.find("SST = 0.1 where the elements have 1: it hides 18 penetrations"),
            std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC301", plates(1, 1, "0.1,0.1"))), 0U);
}

TEST(ThicknessOverride, WhatPenetratesAnywayIsNotHidden) {
  RuleDeck deck = plates(1, 0.7, "0.1,0.1");
  deck.node(200, Vector(2.5, 2.5, 0.02)).node(201, Vector(3.5, 2.5, 0.02)).node(202, Vector(2.5, 3.5, 0.02));
  deck.shell_part(3, 1).shell(200, 3, {200, 201, 202});
  const Report report = run_rule("GC301", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].count, 18U);  // not the triangle's nodes: 0.02 < 0.1 as well
}

TEST(ThicknessOverride, MstOfTheOtherSideAlone) {
  // Side A keeps 0.25: h = 0.125 + 1.
  const Report report = run_rule("GC301", plates(0.25, 1, "0.,2.", "AUTOMATIC_SURFACE_TO_SURFACE"));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("MST = 2 where the elements have 0.25"), std::string::npos)
      << report.findings[0].message;
}

/// Nodes 1 to 3 of a shell of 0.25 alone are tracked, with this SST; 0.4 above a plate of 0.25.
Report three_nodes(double sst) {
  RuleDeck deck;
  deck.shell_part(1, 0.25).shell_part(2, 0.25).plate(101, 2, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(1, 1, 2, 1, Vector(1, 1, 0.4), 2, 2).raw("SET_NODE_LIST", "7\n1,2,3\n");
  return run_rule("GC301",
                  deck.contact(1, "AUTOMATIC_NODES_TO_SURFACE", "7,2,4,3", fmt::format("0.\n1.,1.,{},0.\n", sst)));
}

TEST(ThicknessOverride, SstOfNodesAlone) {
  const Report report = three_nodes(0.8);  // h = 0.4 + 0.125
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.count, 3U);
  EXPECT_NEAR(f.penetration, 0.125, 1e-12);
  EXPECT_NE(f.message.find("SST = 0.8 where the elements have 0.25: 3 of 3 penetrations exist only by it"),
            std::string::npos)
      << f.message;
  EXPECT_EQ(listed(three_nodes(0.54)), 0U);  // h = 0.395
}

TEST(ThicknessOverride, OpttOfOnePart) {
  RuleDeck deck;
  deck.shell_part(1, 0.25).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 3, 2, 2, Vector(0, 0, 0.5), 5, 5);
  deck.raw("SECTION_SHELL", "3,2,0.833,5\n0.25\n").raw("PART_CONTACT", "part 3\n3,3,1\n0.,0.,0.,0.,1.\n");
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  const Report report = run_rule("GC301", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].part, 3);
  EXPECT_NE(report.findings[0].message.find("OPTT = 1 of part 3"), std::string::npos);
}

TEST(ThicknessOverride, GlobalThickness) {
  RuleDeck deck = plates(0.25, 0.5, "0.,0.");
  EXPECT_EQ(listed(run_rule("GC301", deck)), 0U);
  deck.raw("CONTROL_CONTACT", "0.1,0.0,2,0,1,0,1,0\n0,0,10,0,4.0,1,0,0\n0.,0.,0.,0.,1.,0.,0.\n");
  const Report report = run_rule("GC301", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("TH of *CONTROL_CONTACT = 1"), std::string::npos)
      << report.findings[0].message;
}

}  // namespace
}  // namespace gapcheck::audit_test::thickness_override_test
