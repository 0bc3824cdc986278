#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::ignore_recommended_test {
namespace {

/// Two plates of thickness 1 at a distance: 18 penetrating nodes where it is below 1.
RuleDeck plates(double gap, const std::string& keyword = "AUTOMATIC_SINGLE_SURFACE",
                const std::string& card1 = "0,0,5,0") {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  return deck.plate(101, 2, 2, 2, Vector(0, 0, gap), 5, 5).contact(1, keyword, card1);
}

TEST(IgnoreRecommended, OnlyWithPenetrations) {
  const Report report = run_rule("GC421", plates(0.7));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_TRUE(report.findings[0].message.starts_with("IGNORE = 0 and 18 initial penetrations: "));
  EXPECT_EQ(report.findings[0].contact, 1);
  EXPECT_EQ(report.findings[0].severity, Severity::note);
  EXPECT_EQ(run_rule("GC421", plates(1)).findings.size(), 0U);
}

TEST(IgnoreRecommended, NotWithIgnoreNorForOtherTypes) {
  RuleDeck global = plates(0.7), off = plates(0.7);
  EXPECT_EQ(run_rule("GC421", global.raw("CONTROL_CONTACT", "\n\n\n1\n")).findings.size(), 0U);
  const Report at_control = run_rule("GC421", off.raw("CONTROL_CONTACT", "\n\n\n0\n"));
  ASSERT_EQ(at_control.findings.size(), 1U);
  EXPECT_EQ(at_control.findings[0].contact, 0);
  EXPECT_TRUE(at_control.findings[0].message.starts_with("1 contact with IGNORE = 0 has 18 initial penetrations: "));
  EXPECT_EQ(run_rule("GC421", plates(0.7, "SURFACE_TO_SURFACE", "1,2,3,3")).findings.size(), 0U);
  EXPECT_EQ(run_rule("GC421", plates(0.7, "SINGLE_SURFACE")).findings.size(), 0U);
}

TEST(IgnoreRecommended, OneNoteForAllContacts) {
  RuleDeck deck = plates(0.7);
  deck.contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", "0.\n1.,1.,2.,2.\n");
  const Report report = run_rule("GC421", deck);
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_TRUE(report.findings[0].message.starts_with("2 contacts with IGNORE = 0 have ")) << report.findings[0].message;
  EXPECT_EQ(report.findings[0].contact, 0);
}

}  // namespace
}  // namespace gapcheck::audit_test::ignore_recommended_test
