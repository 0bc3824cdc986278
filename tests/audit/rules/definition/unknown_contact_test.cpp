#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::unknown_contact_test {
namespace {

std::string message(const std::string& keyword) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).raw("CONTACT_" + keyword, "0,0,5,0\n\n\n");
  const Report report = run_rule("GC403", deck);
  EXPECT_LE(report.findings.size(), 1U);
  return report.findings.empty() ? "" : report.findings[0].message;
}

TEST(UnknownContact, NamesTheNearestKnownOne) {
  EXPECT_NE(message("AUTOMATIC_SINGEL_SURFACE").find("mean *CONTACT_AUTOMATIC_SINGLE_SURFACE?"), std::string::npos);
  EXPECT_EQ(message("AUTOMATIC_SINGLE_SURFACE"), "");
  EXPECT_EQ(message("ENTITY"), "");
  EXPECT_EQ(message("AUTOMATIC_SINGLE_SURFACE_MORTAR_MPP"), "");
}

TEST(UnknownContact, OffersNothingWhereNothingIsNear) {
  EXPECT_NE(message("WHATEVER_THIS_IS").find("correct the name"), std::string::npos);
}

TEST(UnknownContact, EndlessNamesAndManyContacts) {
  const std::string text = message(std::string(9000, 'A'));
  EXPECT_LT(text.size(), 300U);
  EXPECT_NE(text.find("correct the name"), std::string::npos);
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  for (int i = 0; i < 12; ++i) deck.raw("CONTACT_AUTOMATIC_SINGLE", "0,0,5,0\n\n\n");
  const Report report = run_rule("GC403", deck);
  ASSERT_EQ(report.findings.size(), 11U);
  EXPECT_EQ(report.findings[10].count, 2U);
}

}  // namespace
}  // namespace gapcheck::audit_test::unknown_contact_test
