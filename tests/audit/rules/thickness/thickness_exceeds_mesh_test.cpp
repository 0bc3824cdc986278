#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::thickness_exceeds_mesh_test {
namespace {

// Elements of 5 x 2 in one contact with SSTHK = 1.
Report plate(double thickness, const std::string& type = "AUTOMATIC_SINGLE_SURFACE", int ssthk = 1,
             const std::string& card3 = "1.,1.") {
  RuleDeck deck;
  deck.shell_part(1, thickness).plate(1, 1, 3, 2, Vector(0, 0, 0), 5, 2);
  deck.shell_part(2, 1).plate(101, 2, 1, 1, Vector(0, 0, 50), 5, 2);
  deck.raw("CONTROL_CONTACT", fmt::format("0.1,0.0,2,0,1,0,1,0\n0,0,10,0,4.0,{},0,0\n", ssthk));
  deck.contact(1, type, type == "AUTOMATIC_SINGLE_SURFACE" ? "0,0,5,0" : "1,2,3,3", "0.\n" + card3 + "\n");
  return run_rule("GC304", deck);
}

TEST(ThicknessExceedsMesh, ThickerThanTheShortestEdge) {
  const Report report = plate(2.01);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].part, 1);
  EXPECT_EQ(report.findings[0].count, 6U);
  EXPECT_NE(report.findings[0].message.find("2.01 (element thickness) and an edge of 2;"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(plate(2)), 0U);
}

TEST(ThicknessExceedsMesh, OnlyWhereASurfaceMeetsItselfAndIsNotLimited) {
  EXPECT_EQ(listed(plate(3, "AUTOMATIC_SURFACE_TO_SURFACE")), 0U);
  EXPECT_EQ(listed(plate(3, "AUTOMATIC_SINGLE_SURFACE", 0)), 0U);
  EXPECT_EQ(listed(plate(1, "AUTOMATIC_SINGLE_SURFACE", 0, "1.,1.,2.5,0.")), 2U);  // SST is not limited; both parts
}

TEST(ThicknessExceedsMesh, ShellsWithoutAnySizeAreAnotherRules) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).shell_part(2, 1);
  for (int i = 0; i < 4; ++i) deck.node(101 + i, {20, 20, 3});
  deck.shell(101, 2, {101, 102, 103, 104});
  EXPECT_EQ(listed(run_rule("GC304", deck.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3"))), 0U);
}

// Fifty times the longest edge is a thickness in another unit: an error, and also where two surfaces meet.
TEST(ThicknessExceedsMesh, ManyTimesTheMeshIsAnErrorInEveryContact) {
  const Report above = plate(251, "AUTOMATIC_SURFACE_TO_SURFACE");
  ASSERT_EQ(listed(above), 1U);
  EXPECT_EQ(above.findings[0].severity, Severity::error);
  EXPECT_EQ(above.findings[0].part, 1);
  EXPECT_NE(above.findings[0].message.find("correct the thickness or its unit"), std::string::npos)
      << above.findings[0].message;
  EXPECT_EQ(listed(plate(249, "AUTOMATIC_SURFACE_TO_SURFACE")), 0U);
  // A trapezoid with edges of 5, 2.06, 4 and 2.06: the first one is the longest.
  const auto trapezoid = [](double thickness) {
    RuleDeck deck;
    deck.shell_part(1, thickness).node(1, {0, 0, 0}).node(2, {5, 0, 0}).node(3, {4.5, 2, 0}).node(4, {0.5, 2, 0});
    deck.shell(1, 1, {1, 2, 3, 4}).shell_part(2, 1).plate(101, 2, 1, 1, Vector(0, 0, 400), 5, 2);
    return listed(run_rule("GC304", deck.contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3")));
  };
  EXPECT_EQ(trapezoid(251), 1U);
  EXPECT_EQ(trapezoid(249), 0U);
  EXPECT_EQ(plate(251).findings.at(0).severity, Severity::error);
  EXPECT_EQ(plate(249).findings.at(0).severity, Severity::warning);
}

}  // namespace
}  // namespace gapcheck::audit_test::thickness_exceeds_mesh_test
