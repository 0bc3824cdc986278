#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::surplus_card_test {
namespace {

Report contact_with(int lines_behind_card_3, const std::string& last) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  std::string lines = "0,0,5,0\n0.\n1.,1.\n";
  for (int i = 1; i < lines_behind_card_3; ++i) lines += "\n";
  return run_rule("GC402", deck.raw("CONTACT_AUTOMATIC_SINGLE_SURFACE", lines + last + "\n"));
}

TEST(SurplusCard, LinesBehindCardG) {
  const Report report = contact_with(8, "1");
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].contact, 1);
  EXPECT_NE(report.findings[0].message.find("has 1 line behind"), std::string::npos);
  EXPECT_EQ(listed(contact_with(7, ",1.")), 0U);
  EXPECT_EQ(listed(contact_with(9, "")), 0U);  // blank lines do no harm
}

TEST(SurplusCard, TheTypesOwnCardIsNone) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.raw("CONTACT_ERODING_SINGLE_SURFACE", "0,0,5,0\n0.\n1.,1.\n1,1,1\n\n\n\n\n\n\n,1.\n");
  EXPECT_EQ(listed(run_rule("GC402", deck)), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::surplus_card_test
