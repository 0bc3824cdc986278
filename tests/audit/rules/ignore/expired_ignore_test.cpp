#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::expired_ignore_test {
namespace {

Report on(const std::string& comment, std::chrono::sys_days day) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 2, 2, Vector(1, 1, 0.5), 5, 5).contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3");
  audit::AuditOptions options;
  options.select = {"GC101", "GC514"};
  options.today = day;
  const AuditRun run = run_text(comment + deck.text(), options);
  EXPECT_TRUE(clean(run)) << describe(run.diagnostics);
  return run.report;
}

TEST(ExpiredIgnore, FromTheDayAfterTheLastOn) {
  using namespace std::chrono;
  const std::string comment = "$ gapcheck: ignore GC101 node=101-102 until=2027-03-01\n";
  const Report before = on(comment, year(2027) / 3 / 1), after = on(comment, year(2027) / 3 / 2);
  EXPECT_TRUE(before.findings.empty());
  EXPECT_EQ(before.ignored.size(), 2U);
  EXPECT_EQ(after.ignored.size(), 0U);
  EXPECT_EQ(after.penetrations.size(), before.penetrations.size() + 2) << "they count again";
  ASSERT_EQ(after.findings.size(), 1U);
  EXPECT_EQ(
      after.findings[0].message,
      "the ignore of GC101 held until 2027-03-01; the 2 findings that it would leave out count again: mend them, or "
      "give a later day");
  EXPECT_EQ(after.findings[0].line, 1U);
}

TEST(ExpiredIgnore, SaysWhereItIsNoLongerNeeded) {
  using namespace std::chrono;
  const Report report = on("$ gapcheck: ignore GC102 until=2020-03-01\n", year(2027) / 3 / 2);
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].message,
            "the ignore of GC102 held until 2020-03-01 and would leave out nothing; remove it");
  const Report one = on("$ gapcheck: ignore GC101 node=101 until=2020-03-01\n", year(2027) / 3 / 2);
  EXPECT_NE(one.findings.at(0).message.find("the finding that it would leave out counts again: mend it"),
            std::string::npos);
}

}  // namespace
}  // namespace gapcheck::audit_test::expired_ignore_test
