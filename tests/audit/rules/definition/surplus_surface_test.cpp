#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::surplus_surface_test {
namespace {

Report single_surface(const std::string& keyword, const std::string& card1) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).contact(1, keyword, card1);
  return run_rule("GC404", deck);
}

TEST(SurplusSurface, OnlyWhereThereIsOneSurface) {
  const Report report = single_surface("AUTOMATIC_SINGLE_SURFACE", "1,1,3,3");
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].contact, 1);
  EXPECT_NE(report.findings[0].message.find("SURFB"), std::string::npos) << report.findings[0].message;
  EXPECT_EQ(listed(single_surface("AUTOMATIC_GENERAL", "1,1,3,3")), 1U);
  EXPECT_EQ(listed(single_surface("AUTOMATIC_SINGLE_SURFACE", "1,0,3,3")), 0U);
  EXPECT_EQ(listed(single_surface("AUTOMATIC_SURFACE_TO_SURFACE", "1,1,3,3")), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::surplus_surface_test
