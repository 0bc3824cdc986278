#include <algorithm>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::thickness_limited_test {
namespace {

// Elements of 5 x 2: the contact takes at most 0.8.
RuleDeck plate(double thickness, int ssthk, const std::string& card3 = "1.,1.") {
  RuleDeck deck;
  deck.shell_part(1, thickness).plate(1, 1, 3, 2, Vector(0, 0, 0), 5, 2);
  deck.shell_part(2, 0.1).plate(101, 2, 1, 1, Vector(0, 0, 9), 5, 2);
  deck.raw("CONTROL_CONTACT", fmt::format("0.1,0.0,2,0,1,0,1,0\n0,0,10,0,4.0,{},0,0\n", ssthk));
  return deck.contact(4, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", "0.\n" + card3 + "\n");
}

TEST(ThicknessLimited, OneFindingPerPartWithTheElementThatLosesMost) {
  RuleDeck deck = plate(2, 0);
  // A triangle at the end of the plate with an edge of 1.
  deck.node(50, Vector(15, 5, 0)).shell(50, 1, {12, 50, 11});
  const Report report = run_rule("GC302", deck);
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.contact, 4);
  EXPECT_EQ(f.part, 1);
  EXPECT_EQ(f.count, 7U);
  EXPECT_EQ(f.element, 50);
  EXPECT_NE(f.message.find("0.4 of 2;"), std::string::npos) << f.message;
  EXPECT_EQ(f.line, line_of(deck, "50,1,12,50,11,11"));
}

// 0.8 of 1 is the largest share that is listed.
TEST(ThicknessLimited, NotWhereTheThicknessIsLittleMoreThanTheLimit) {
  EXPECT_EQ(listed(run_rule("GC302", plate(1.01, 0))), 1U);
  EXPECT_EQ(listed(run_rule("GC302", plate(0.99, 0))), 0U);
  EXPECT_EQ(listed(run_rule("GC302", plate(0.8, 0))), 0U);
  EXPECT_EQ(listed(run_rule("GC302", plate(2, 1))), 0U);
  EXPECT_EQ(listed(run_rule("GC302", plate(2, 0, "1.,1.,2.,2."))), 0U);  // SST is not limited
}

TEST(ThicknessLimited, ScaleFactorsBelongToTheThickness) {
  const Report report = run_rule("GC302", plate(2, 0, "1.,1.,0.,0.,0.5,1."));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("0.8 of 1;"), std::string::npos) << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC302", plate(2, 0, "1.,1.,0.,0.,0.45,1."))), 0U);
}

TEST(ThicknessLimited, TenPartsInFullAndOneLineForTheRest) {
  RuleDeck deck;
  for (int part = 1; part <= 12; ++part)
    deck.shell_part(part, 1 + part).plate(100 * part, part, 1, 1, Vector(0, 0, 50. * part), 2, 2);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  const Report report = run_rule("GC302", deck);
  ASSERT_EQ(report.findings.size(), 11U);
  EXPECT_EQ(
      std::count_if(report.findings.begin(), report.findings.end(), [](const Finding& f) { return f.part == 12; }), 1);
  const auto rest =
      std::find_if(report.findings.begin(), report.findings.end(), [](const Finding& f) { return f.part == 0; });
  ASSERT_NE(rest, report.findings.end());
  EXPECT_EQ(rest->count, 2U);
}

}  // namespace
}  // namespace gapcheck::audit_test::thickness_limited_test
