#include <fmt/format.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "audit/published/cases.hpp"

namespace gapcheck::audit_test::published_cases_test {
namespace {

std::vector<PublishedCase> all_cases() {
  std::vector<PublishedCase> all;
  for (const auto& group : {published_penetrations::cases(), published_ties::cases(), published_thicknesses::cases(),
                            published_definitions::cases(), published_definitions::friction_cases(),
                            published_surfaces::cases(), published_meshes::cases()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

/// What a report lists, one line each, whatever its kind.
std::string said(const Report& report) {
  std::string text;
  for (const Finding& f : report.findings) text += f.message + "\n";
  for (const Penetration& p : report.penetrations)
    text += fmt::format("node {} of part {} is {:.4g} inside element {}: {}\n", p.node, p.part, p.depth, p.element,
                        name(p.outcome));
  for (const TieFailure& t : report.tie_failures)
    text += fmt::format("node {} of part {}: {}, {:.4g} where {:.4g} is allowed\n", t.node, t.part, name(t.reason),
                        t.distance, t.allowed);
  return text;
}

TEST(PublishedCases, FireTheirRuleWithThisMessage) {
  for (const PublishedCase& each : all_cases()) {
    const Report report = run_rule(each.rule, each.wrong);
    EXPECT_GE(listed(report), 1U) << each.rule;
    EXPECT_NE(said(report).find(each.says), std::string::npos) << each.rule << ": " << said(report);
  }
}

TEST(PublishedCases, PutRightTheyAreSilent) {
  for (const PublishedCase& each : all_cases()) {
    const Report report = run_rule(each.rule, each.right);
    EXPECT_EQ(listed(report), 0U) << each.rule << ": " << said(report);
  }
}

std::string page() {
  std::ifstream file(std::string(GAPCHECK_ROOT) + "/docs/real-decks.md");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::set<std::string> rules_in(const std::string& text) {
  std::set<std::string> rules;
  const std::regex row(R"(\n\| (GC\d{3}) \[)");
  for (std::sregex_iterator at(text.begin(), text.end(), row), end; at != end; ++at) rules.insert((*at)[1]);
  return rules;
}

/// Every rule of the audit has a real deck in which it fires, or a published case; the page says which.
TEST(PublishedCases, ThePageNamesThemAll) {
  const std::string text = page();
  const auto begin = text.find("## Rules that fire in none of these decks");
  ASSERT_NE(begin, std::string::npos);
  const auto end = text.find("\n## ", begin + 1);
  const std::set<std::string> listed_there = rules_in(text.substr(begin, end - begin));
  std::set<std::string> tested;
  for (const PublishedCase& each : all_cases()) tested.insert(each.rule);
  // Rules on gapcheck's own comments: nobody else has written any.
  for (const char* own : {"GC513", "GC514", "GC515"}) tested.insert(own);
  EXPECT_EQ(listed_there, tested);

  std::set<std::string> fired;
  const std::regex counted(R"(\n\| (GC\d{3}) \[[^\n]*\| *[1-9][\d,]* *\|)");
  const std::string before = text.substr(0, begin);
  for (std::sregex_iterator at(before.begin(), before.end(), counted), none; at != none; ++at) fired.insert((*at)[1]);
  for (const std::string& rule : rules_in(before))
    EXPECT_NE(fired.contains(rule), listed_there.contains(rule)) << rule << ": a real deck or a case, not both";
}

}  // namespace
}  // namespace gapcheck::audit_test::published_cases_test
