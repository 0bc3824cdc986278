#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::unused_ignore_test {
namespace {

/// Two plates 1 thick and 0.5 apart in one contact: nodes penetrate (GC101), none is released (GC102).
std::string deck(const std::string& comment) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 2, 2, Vector(1, 1, 0.5), 5, 5).contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3");
  return comment + deck.text();
}

std::size_t unused(const std::string& comment, const audit::AuditOptions& options = {}) {
  const AuditRun run = run_text(deck(comment), options);
  EXPECT_TRUE(clean(run)) << describe(run.diagnostics);
  std::size_t found = 0;
  for (const Finding& f : run.report.findings) {
    if (f.id != "GC513") continue;
    ++found;
    EXPECT_EQ(f.line, 1U);
    EXPECT_NE(f.message.find("matches no finding"), std::string::npos);
  }
  return found;
}

TEST(UnusedIgnore, OnlyWhereNothingIsMatched) {
  EXPECT_EQ(unused("$ gapcheck: ignore GC101\n"), 0U);
  EXPECT_EQ(unused("$ gapcheck: ignore GC101 node=101\n"), 0U);
  EXPECT_EQ(unused("$ gapcheck: ignore GC101 node=9999\n"), 1U);
  EXPECT_EQ(unused("$ gapcheck: ignore GC102\n"), 1U);
  EXPECT_EQ(unused("$ gapcheck: ignore GC102 until=2020-01-01\n"), 1U) << "no day is given, so nothing expires";
  EXPECT_EQ(unused("$ gapcheck ignore GC102\n"), 0U) << "an ordinary comment";
}

TEST(UnusedIgnore, OnlyWhatHadItsChance) {
  const std::string comment = "$ gapcheck: ignore GC102,GC103 contact=1\n";
  audit::AuditOptions options;
  EXPECT_EQ(unused(comment, options), 1U);
  options.select = {"GC513", "GC102"};
  EXPECT_EQ(unused(comment, options), 0U) << "GC103 was not looked for";
  options.select.push_back("GC103");
  EXPECT_EQ(unused(comment, options), 1U);
  options.contacts = {1};
  EXPECT_EQ(unused(comment, options), 1U);
  EXPECT_EQ(unused("$ gapcheck: ignore GC102\n", options), 0U) << "it might match in other contacts";
  options.contacts = {2};
  EXPECT_EQ(unused(comment, options), 0U);
  options.contacts = {};
  options.ignore = {"GC103"};
  EXPECT_EQ(unused(comment, options), 0U);
  for (const auto set :
       {+[](audit::AuditOptions& o) { o.parts = {1}; }, +[](audit::AuditOptions& o) { o.ptol = 0.1; },
        +[](audit::AuditOptions& o) { o.rtol = 0.1; }, +[](audit::AuditOptions& o) { o.ratio = 0.1; }}) {
    options = {};
    set(options);
    EXPECT_EQ(unused(comment, options), 0U);
  }
}

TEST(UnusedIgnore, ItsFindingsAreNotIgnored) {
  EXPECT_EQ(unused("$ gapcheck: ignore GC5 node=77777777\n"), 1U);
  audit::AuditOptions options;
  options.ignore = {"unused-ignore"};
  EXPECT_EQ(unused("$ gapcheck: ignore GC102\n", options), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::unused_ignore_test
