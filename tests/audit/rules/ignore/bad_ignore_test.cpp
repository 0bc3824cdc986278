#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::bad_ignore_test {
namespace {

Report with_comment(const std::string& comment) {
  return run_rule("GC515", "*KEYWORD\n" + comment + "\n*NODE\n1,0.,0.,0.\n*END\n");
}

TEST(BadIgnore, CommentsThatAreNotUnderstood) {
  const Report report = with_comment("$ gapcheck: ignore GC109999");
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].line, 2U);
  EXPECT_EQ(report.findings[0].severity, Severity::warning);
  EXPECT_NE(report.findings[0].message.find("\"GC109999\" is not a rule"), std::string::npos);
  EXPECT_EQ(listed(with_comment("$ gapcheck: GC101")), 1U);
  EXPECT_EQ(listed(with_comment("$ gapcheck: ignore GC101 node")), 1U);
  EXPECT_EQ(listed(with_comment("$ gapcheck: ignore GC101 x\n$ gapcheck: ignore GC101 y")), 2U);
}

TEST(BadIgnore, OthersAreNone) {
  EXPECT_EQ(listed(with_comment("$ gapcheck: ignore GC101 node=1")), 0U);
  EXPECT_EQ(listed(with_comment("$ gapcheck GC109999")), 0U);
  EXPECT_EQ(listed(with_comment("$ see gapcheck: GC109999")), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::bad_ignore_test
