#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::spotweld_option_test {
namespace {

Report with(const std::string& keyword, const std::string& mpp, const std::string& card_e) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 4, 4);
  // The MPP card comes first, after the card of the ID.
  const std::string cards = mpp.empty() ? "0,0,5" : mpp + "\n0,0,5";
  return run_rule("GC423", deck.contact(3, keyword, cards, "0.\n1.,1.\n0\n0.\n1\n0\n" + card_e + "\n"));
}

TEST(SpotweldOption, OnBothCardsOrNeither) {
  EXPECT_EQ(listed(with("AUTOMATIC_GENERAL", "", "0,0")), 0U);
  EXPECT_EQ(listed(with("AUTOMATIC_GENERAL_MPP", "0,0,0,0,0,0,0,2", "0,2")), 0U);
  EXPECT_EQ(listed(with("AUTOMATIC_SINGLE_SURFACE_MPP", "0,0,0,0,0,0,0,2", "0,0")), 0U);  // has no meaning there
}

TEST(SpotweldOption, OnOneCardOnly) {
  const Report mpp = with("AUTOMATIC_GENERAL_MPP", "0,0,0,0,0,0,0,2", "0,0");
  ASSERT_EQ(listed(mpp), 1U);
  EXPECT_EQ(mpp.findings[0].contact, 3);
  EXPECT_NE(mpp.findings[0].message.find("CPARM8 = 2 is on the MPP card, and not on card E: an SMP run leaves"),
            std::string::npos)
      << mpp.findings[0].message;
  const Report smp = with("AUTOMATIC_GENERAL", "", "0,2");
  ASSERT_EQ(listed(smp), 1U);
  EXPECT_NE(smp.findings[0].message.find("is on card E, and not on the MPP card"), std::string::npos);
}

}  // namespace
}  // namespace gapcheck::audit_test::spotweld_option_test
