#include "report/text/rule_table.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "report/sample.hpp"

namespace gapcheck::report::rule_table_test {
namespace {

Report deck_with(const std::string& name) {
  Report report;
  report.input = name;
  report.findings = {make_finding("GC501", "duplicate-id", "a"), make_finding("GC501", "duplicate-id", "b")};
  return report;
}

TEST(RuleTable, EachRuleWithItsDecksAndFindings) {
  const std::vector<Report> decks{deck_with("a.k"), deck_with("b.k"), Report{}};
  EXPECT_EQ(rule_table({decks, {}}),
            "3 decks: 4 errors, 0 warnings, 0 notes\n\n"
            "| rule | severity | decks | findings |\n"
            "|---|---|---:|---:|\n"
            "| GC501 duplicate-id | error | 2 | 4 |\n");
  EXPECT_EQ(rule_table({std::span(decks).subspan(2), {}}).find('|'), std::string::npos) << "nothing was found";
}

TEST(RuleTable, WithBaselinesWhatIsNew) {
  std::vector<Report> decks{deck_with("a.k"), deck_with("b.k")};
  decks[0].baseline.emplace().states = {BaselineState::unchanged, BaselineState::fresh};
  const std::string table = rule_table({decks, {}});
  EXPECT_NE(table.find("| findings | new | worse | unchanged | gone |\n|---|---|---:|---:|---:|---:|---:|---:|\n"
                       "| GC501 duplicate-id | error | 2 | 4 | 1 | 0 | 1 | 0 |\n"),
            std::string::npos)
      << table;
}

TEST(RuleTable, DecksThatWereNotAudited) {
  const std::vector<Report> decks{deck_with("a.k")};
  std::vector<Unread> unread(23, {"x`<img>.k", "is\nempty"});
  const std::string table = rule_table({decks, unread});
  EXPECT_NE(table.find("\nNot audited:\n\n- `x'<img>.k: is?empty`\n"), std::string::npos) << table;
  EXPECT_TRUE(table.ends_with("- 3 more\n")) << table;
  unread.assign(1, {"x.k", "x.k: is empty"});
  EXPECT_TRUE(rule_table({decks, unread}).ends_with("\n- `x.k: is empty`\n"));
}

}  // namespace
}  // namespace gapcheck::report::rule_table_test
