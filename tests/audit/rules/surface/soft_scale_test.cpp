#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::soft_scale_test {
namespace {

Report with_card_a(const std::string& card_a, const std::string& scale_factors = "1.,1.") {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.contact(4, "AUTOMATIC_SINGLE_SURFACE", "0,0,5", "0.\n" + scale_factors + "\n" + card_a + "\n");
  return run_rule("GC411", deck);
}

TEST(SoftScale, OutsideTheRecommendedRangeOnly) {
  for (const char* bad : {"1,0.2", "2,1.0", "1,0.039"}) {
    const Report report = with_card_a(bad);
    ASSERT_EQ(listed(report), 1U) << bad;
    EXPECT_EQ(report.findings[0].contact, 4);
    EXPECT_EQ(report.findings[0].severity, Severity::note);
    EXPECT_NE(report.findings[0].message.find(std::string("SOFSCL = ") + (bad[2] == '1' ? "1 " : bad + 2)),
              std::string::npos)
        << report.findings[0].message;
  }
  for (const char* good : {"1,0.1", "1,0.04", "2,0.07", "1,0.0", "0,0.2"})
    EXPECT_EQ(listed(with_card_a(good)), 0U) << good;
}

// SFS = SFM = 1e-12 leave SOFSCL alone to set the springs; 0.4 to 0.5 is advised then.
TEST(SoftScale, WithoutSpringsOfTheMaterialMoreIsAdvised) {
  for (const char* good : {"1,0.4", "1,0.5"}) EXPECT_EQ(listed(with_card_a(good, "1.e-12,1.e-12")), 0U) << good;
  EXPECT_EQ(listed(with_card_a("1,0.4", "1.e-12,1.")), 1U) << "one side still has its springs";
  EXPECT_EQ(listed(with_card_a("2,0.4", "1.e-12,1.e-12")), 1U) << "SOFT = 2 scales with SFS";
  const Report report = with_card_a("1,0.6", "1.e-12,1.e-12");
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("above 0.5"), std::string::npos) << report.findings[0].message;
}

}  // namespace
}  // namespace gapcheck::audit_test::soft_scale_test
