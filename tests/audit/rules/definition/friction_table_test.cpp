#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::friction_table_test {
namespace {

Report with_tables(const std::string& card2, const std::vector<int>& tables,
                   const std::string& keyword = "AUTOMATIC_SINGLE_SURFACE") {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  for (const int id : tables) deck.raw("DEFINE_FRICTION", fmt::format("{},0.1,0.1\n1,1,0.2,0.2\n", id));
  return run_rule("GC408", deck.contact(1, keyword, "0,0,5,5", card2 + "\n1.,1.\n"));
}

TEST(FrictionTable, TheTableMustBeThere) {
  EXPECT_EQ(listed(with_tables("-2.", {})), 1U);
  EXPECT_EQ(listed(with_tables("-2.", {5})), 0U);
  EXPECT_EQ(listed(with_tables("-2.,6.", {5})), 1U);
  EXPECT_EQ(listed(with_tables("-2.,5.", {5})), 0U);
  EXPECT_EQ(listed(with_tables("-2.,5.", {4, 5})), 0U);
  EXPECT_EQ(listed(with_tables("-2.,4.5", {4, 5})), 1U);
  EXPECT_EQ(listed(with_tables("-2.,1e29", {4, 5})), 1U);
  EXPECT_EQ(listed(with_tables("0.2,6.", {})), 0U);
}

TEST(FrictionTable, SeveralTablesNeedAName) {
  const Report report = with_tables("-2.", {4, 5});
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].severity, Severity::warning);
  EXPECT_EQ(with_tables("-2.", {}).findings[0].severity, Severity::error);
}

TEST(FrictionTable, OnlySomeTypesTakeIt) {
  EXPECT_EQ(listed(with_tables("-2.", {5}, "AIRBAG_SINGLE_SURFACE")), 1U);
  EXPECT_EQ(listed(with_tables("-2.", {5}, "AUTOMATIC_GENERAL")), 0U);
  EXPECT_EQ(listed(with_tables("-2.", {}, "TIED_SURFACE_TO_SURFACE")), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::friction_table_test
