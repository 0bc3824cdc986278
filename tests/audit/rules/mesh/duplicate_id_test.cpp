#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::duplicate_id_test {
namespace {

TEST(DuplicateId, TwoContactsWithOneId) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  EXPECT_EQ(listed(run_rule("GC501", deck)), 0U);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  const Report report = run_rule("GC501", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].severity, Severity::error);
  EXPECT_NE(report.findings[0].message.find("contact 1 is defined again"), std::string::npos)
      << report.findings[0].message;
}

// A run has one case, and what is outside of all.
TEST(DuplicateId, NotInDifferentCases) {
  const std::string curve = "1\n0.,0.\n1.,1.\n";
  const auto cases = [&](const std::string& second) {
    RuleDeck deck;
    deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
    deck.raw("CASE_BEGIN_1").raw("DEFINE_CURVE", curve).raw("CASE_END_1").raw("CASE_BEGIN_" + second);
    return deck.raw("DEFINE_CURVE", curve).raw("CASE_END_" + second);
  };
  audit::AuditOptions options;
  options.select = {"GC501"};
  EXPECT_EQ(listed(run_text(cases("2").text(), options).report), 0U);
  EXPECT_EQ(listed(run_text(cases("1").text(), options).report), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::duplicate_id_test
