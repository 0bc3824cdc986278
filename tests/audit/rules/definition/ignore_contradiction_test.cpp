#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::ignore_contradiction_test {
namespace {

/// IGNORE on the MPP card, card C and *CONTROL_CONTACT.
Report with_values(int mpp, int card_c, int control, const std::string& keyword = "AUTOMATIC_SINGLE_SURFACE") {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.raw("CONTROL_CONTACT", fmt::format("\n\n\n{}\n", control));
  deck.raw("CONTACT_" + keyword + "_MPP_ID", fmt::format("1,one\n{}\n1,1,3,3\n0.\n1.,1.\n0\n\n,{}\n", mpp, card_c));
  return run_rule("GC409", deck);
}

TEST(IgnoreContradiction, TheFirstThatIsNotZeroWins) {
  const Report mpp = with_values(1, 2, 0);
  ASSERT_EQ(mpp.findings.size(), 1U);
  EXPECT_EQ(mpp.findings[0].severity, Severity::warning);
  EXPECT_TRUE(mpp.findings[0].message.starts_with("IGNORE = 1 on the MPP card and 2 on card C: 1 counts"));
  const Report control = with_values(0, 2, 1);
  ASSERT_EQ(control.findings.size(), 1U);
  EXPECT_EQ(control.findings[0].severity, Severity::note);
  EXPECT_TRUE(control.findings[0].message.starts_with("IGNORE = 2 on card C and 1 on *CONTROL_CONTACT: 2 counts"));
  EXPECT_EQ(listed(with_values(1, 1, 2)), 1U);
}

TEST(IgnoreContradiction, EqualValuesAndZerosAgree) {
  EXPECT_EQ(listed(with_values(1, 1, 1)), 0U);
  EXPECT_EQ(listed(with_values(0, 2, 0)), 0U);
  EXPECT_EQ(listed(with_values(0, 0, 2)), 0U);
  EXPECT_EQ(listed(with_values(1, 2, 0, "TIED_SURFACE_TO_SURFACE")), 0U);
}

TEST(IgnoreContradiction, OnlyTypesThatReadIt) {
  for (const char* type :
       {"SURFACE_TO_SURFACE", "SINGLE_SURFACE", "FORMING_ONE_WAY_SURFACE_TO_SURFACE", "CONSTRAINT_NODES_TO_SURFACE"})
    EXPECT_EQ(listed(with_values(1, 2, 0, type)), 0U) << type;
  for (const char* type : {"AUTOMATIC_SURFACE_TO_SURFACE", "AUTOMATIC_SINGLE_SURFACE_MORTAR"})
    EXPECT_EQ(listed(with_values(1, 2, 0, type)), 1U) << type;
}

}  // namespace
}  // namespace gapcheck::audit_test::ignore_contradiction_test
