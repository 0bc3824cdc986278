#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::eroding_timestep_test {
namespace {

Report eroding(const std::string& keyword, int soft, const std::string& controls) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.contact(1, keyword, "0,0,5",
               fmt::format("0.\n1.,1.\n{}{}\n", keyword.starts_with("ERODING") ? "1,1\n" : "", soft));
  if (!controls.empty()) deck.raw("CONTROL_CONTACT", controls);
  return run_rule("GC419", deck);
}

TEST(ErodingTimestep, WithoutEcdtOnly) {
  const Report report = eroding("ERODING_SINGLE_SURFACE", 0, "");
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].severity, Severity::warning);
  EXPECT_EQ(report.findings[0].contact, 1);
  // √(ρ t d / (0.8 K)) = 6.297e-7 with the diagonal d = 5 √2; 0.9 · 5 √(ρ 0.91 / E) = 8.300e-7
  EXPECT_NE(report.findings[0].message.find("about 6.297E-07 instead of 8.300E-07"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(eroding("ERODING_SINGLE_SURFACE", 1, "\n")), 1U);
  EXPECT_EQ(listed(eroding("ERODING_SINGLE_SURFACE", 2, "")), 0U);
  EXPECT_EQ(listed(eroding("AUTOMATIC_SINGLE_SURFACE", 0, "")), 0U);
  EXPECT_EQ(listed(eroding("ERODING_SINGLE_SURFACE", 0, "\n,,,,,,1\n")), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::eroding_timestep_test
