// Every rule has its page and every page its rule; writers and registry agree.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "audit/registry.hpp"
#include "report/item/describe_tie.hpp"

namespace gapcheck::rule_pages_test {
namespace {

namespace fs = std::filesystem;

const fs::path pages = fs::path(GAPCHECK_ROOT) / "docs" / "rules";

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST(RulePages, OnePerRule) {
  std::set<std::string> expected, found;
  for (const auto& rule : audit::rules()) expected.insert(std::string(rule.name));
  for (const auto& entry : fs::directory_iterator(pages)) found.insert(entry.path().stem().string());
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(found, expected);
}

TEST(RulePages, AreCompiledInAsTheyStand) {
  for (const auto& rule : audit::rules())
    EXPECT_EQ(audit::page(rule), content(pages / (std::string(rule.name) + ".md"))) << rule.name;
}

TEST(RulePages, TitleNamesRuleIdAndSeverity) {
  for (const auto& rule : audit::rules()) {
    const std::string text(audit::page(rule));
    const std::string title = "# " + std::string(rule.name) + " (" + std::string(rule.id) + ", " +
                              std::string(report::name(rule.severity)) + ")";
    EXPECT_EQ(text.substr(0, text.find('\n')), title);
  }
}

TEST(RulePages, HaveAllSections) {
  for (const auto& rule : audit::rules()) {
    const std::string_view text = audit::page(rule);
    for (const char* section :
         {"## What it finds", "## Formula", "## Why it is bad", "## Example", "## What to do", "## Sources"})
      EXPECT_NE(text.find(section), text.npos) << rule.name << ": " << section;
  }
}

TEST(Registry, IdsAscendAndAreFoundInAnyCase) {
  std::string_view last;
  for (const auto& rule : audit::rules()) {
    EXPECT_LT(last, rule.id);
    last = rule.id;
    EXPECT_EQ(audit::find_rule(rule.id), &rule);
    std::string upper(rule.name);
    for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    EXPECT_EQ(audit::find_rule(upper), &rule);
    EXPECT_FALSE(rule.summary.empty());
  }
  EXPECT_EQ(audit::find_rule(""), nullptr);
  EXPECT_EQ(audit::find_rule("GC"), nullptr);
}

TEST(Registry, SelectAndIgnore) {
  for (const auto& rule : audit::rules()) {
    EXPECT_TRUE(audit::selected(rule, {}, {}));
    EXPECT_TRUE(audit::selected(rule, {"GC"}, {}));
    EXPECT_FALSE(audit::selected(rule, {"GC"}, {std::string(rule.id)}));
    EXPECT_FALSE(audit::selected(rule, {}, {std::string(rule.name)}));
    EXPECT_EQ(audit::selected(rule, {"GC1"}, {}), rule.id.starts_with("GC1"));
    EXPECT_FALSE(audit::selected(rule, {"no-such-rule"}, {}));
  }
}

TEST(Registry, AgreesWithTheWriters) {
  for (std::size_t kind = 0; kind < penetration_kinds; ++kind) {
    const RuleIdentity& rule = rule_of(static_cast<PenetrationKind>(kind));
    const RuleIdentity* listed = audit::find_rule(rule.id);
    ASSERT_NE(listed, nullptr) << rule.id;
    EXPECT_EQ(listed->name, rule.name);
    EXPECT_EQ(listed->severity, rule.severity);
    EXPECT_EQ(report::rule_of(Report(), static_cast<PenetrationKind>(kind)).severity, rule.severity);
  }
  for (const TieReason reason : tie_reasons) {
    const RuleIdentity rule = rule_of(TieFailure{.reason = reason});
    const RuleIdentity* listed = audit::find_rule(rule.id);
    ASSERT_NE(listed, nullptr) << rule.id;
    EXPECT_EQ(listed->name, rule.name);
    EXPECT_EQ(listed->severity, rule.severity);
    EXPECT_EQ(rule_of(reason).id, rule.id);
  }
}

}  // namespace
}  // namespace gapcheck::rule_pages_test
