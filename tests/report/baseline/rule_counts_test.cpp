#include "report/baseline/rule_counts.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report/sample.hpp"

namespace gapcheck::report::rule_counts_test {
namespace {

/// "GC102 error 2 decks 3 findings"
std::vector<std::string> lines(const std::vector<RuleCount>& rules) {
  const std::string names[] = {"note", "warning", "error"};
  std::vector<std::string> all;
  for (const RuleCount& rule : rules)
    all.push_back(std::string(rule.id) + " " + names[static_cast<int>(rule.severity)] + " " +
                  std::to_string(rule.decks) + " " + std::to_string(rule.findings));
  return all;
}

Report with_findings(const std::vector<Finding>& findings) {
  Report report;
  report.findings = findings;
  return report;
}

TEST(RuleCounts, DecksAreCountedOnceForEachRule) {
  const Finding twice = make_finding("GC501", "duplicate-id", "a"), once = make_finding("GC503", "empty-surface", "b");
  const std::vector<Report> reports{with_findings({twice, twice}), with_findings({twice, once}), with_findings({}),
                                    with_findings({once})};
  EXPECT_EQ(lines(rule_counts(reports)), (std::vector<std::string>{"GC501 error 2 3", "GC503 error 2 2"}));
  EXPECT_TRUE(rule_counts({}).empty());
}

TEST(RuleCounts, TheGravestRuleFirstThenThatOfMostDecks) {
  Finding note = make_finding("GC308", "penetration-free-at", "a"), warning = make_finding("GC410", "x", "b");
  note.severity = Severity::note;
  warning.severity = Severity::warning;
  Finding grave = note;  // settings may give a rule another severity in one of the decks
  grave.severity = Severity::warning;
  const std::vector<Report> reports{with_findings({note, warning}), with_findings({grave})};
  EXPECT_EQ(lines(rule_counts(reports)), (std::vector<std::string>{"GC308 warning 2 2", "GC410 warning 1 1"}));
}

TEST(RuleCounts, RecordsCountLikeFindings) {
  const std::vector<Report> reports{sample_report(), sample_report()};
  std::size_t findings = 0;
  for (const RuleCount& rule : rule_counts(reports)) {
    EXPECT_EQ(rule.decks, 2U) << rule.id;
    EXPECT_FALSE(rule.rule.empty()) << rule.id;
    findings += rule.findings;
  }
  const Report& one = reports[0];
  EXPECT_EQ(findings, 2 * (one.penetrations.size() + one.tie_failures.size() + one.findings.size()));
}

TEST(RuleCounts, WhatIsNewIsCountedByRule) {
  Report report = with_findings({make_finding("GC501", "duplicate-id", "a"), make_finding("GC501", "duplicate-id", "b"),
                                 make_finding("GC503", "empty-surface", "c")});
  BaselineComparison& comparison = report.baseline.emplace();
  comparison.states = {BaselineState::fresh, BaselineState::unchanged, BaselineState::worse};
  KnownFinding gone;
  gone.id = "GC508";
  gone.rule = "free-node";
  comparison.gone = {gone, gone};
  const auto rules = rule_counts({&report, 1});
  ASSERT_EQ(rules.size(), 3U);
  EXPECT_EQ(rules[0].baseline.fresh, 1U);
  EXPECT_EQ(rules[0].baseline.unchanged, 1U);
  EXPECT_EQ(rules[0].baseline.worse, 0U);
  EXPECT_EQ(rules[1].baseline.worse, 1U);
  EXPECT_EQ(rules[2].rule, "free-node");
  EXPECT_EQ(rules[2].baseline.gone, 2U);
  EXPECT_EQ(rules[2].decks, 0U);
}

}  // namespace
}  // namespace gapcheck::report::rule_counts_test
