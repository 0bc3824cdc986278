#include "audit/registry.hpp"

#include <gtest/gtest.h>

#include <set>

#include "audit/run_rules.hpp"
#include "records/record_rules.hpp"

namespace gapcheck::audit::registry_test {
namespace {

TEST(Registry, RulesAscendAndHaveTextAndPages) {
  ASSERT_FALSE(rules().empty());
  std::set<std::string_view> names, summaries;
  std::string_view last;
  for (const RuleIdentity& rule : rules()) {
    EXPECT_LT(last, rule.id);
    EXPECT_TRUE(rule.id.starts_with("GC") && rule.id.size() == 5) << rule.id;
    EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
    EXPECT_TRUE(!rule.summary.empty() && summaries.insert(rule.summary).second) << rule.id;
    EXPECT_TRUE(page(rule).starts_with("# " + std::string(rule.name) + " (" + std::string(rule.id) + ", ")) << rule.id;
    last = rule.id;
  }
}

TEST(Registry, NoNameSelectsAnotherRule) {
  for (const RuleIdentity& rule : rules())
    for (const RuleIdentity& other : rules())
      for (const std::string_view own : {rule.id, rule.name})
        EXPECT_EQ(selected(other, {std::string(own)}, {}), &rule == &other) << own << " and " << other.name;
}

/// An identity without needs does not compile; wrong ones do.
TEST(Registry, NeedsFitWhatTheRuleJudges) {
  for (const Rule* rule : listed_rules()) {
    const RuleIdentity& identity = rule->identity;
    const int functions = (rule->run != nullptr) + (rule->judge != nullptr) + (rule->review != nullptr);
    EXPECT_EQ(functions, rule->of_records() ? 0 : 1) << identity.id;
    EXPECT_EQ(identity.of_runs(), rule->judge != nullptr) << identity.id;
    EXPECT_EQ(identity.of_ignores(), rule->review != nullptr) << identity.id;
    EXPECT_EQ(identity.needs == Need::run_files, identity.of_runs()) << identity.id;
    EXPECT_EQ(identity.needs == Need::ignores, identity.of_ignores()) << identity.id;
  }
}

TEST(Registry, RulesOfRecordsAreListedAsTheyAreDeclared) {
  for (const Rule* rule : listed_rules()) {
    const RecordRule* of_records = find_record_rule(rule->identity.id);
    EXPECT_EQ(of_records != nullptr, rule->of_records()) << rule->identity.id;
    if (of_records == nullptr) continue;
    EXPECT_EQ(of_records->identity.name, rule->identity.name);
    EXPECT_EQ(of_records->identity.severity, rule->identity.severity);
    EXPECT_EQ(of_records->identity.needs, rule->identity.needs);
    EXPECT_NE(find_rule(of_records->family), nullptr);
  }
}

TEST(Registry, FindsByIdAndNameInAnyCase) {
  for (const char* name : {"GC101", "gc101", "initial-penetration", "Initial-Penetration"}) {
    const RuleIdentity* rule = find_rule(name);
    ASSERT_NE(rule, nullptr) << name;
    EXPECT_EQ(rule->id, "GC101");
  }
  EXPECT_EQ(find_rule("GC1"), nullptr);
  EXPECT_EQ(find_rule(""), nullptr);
  EXPECT_EQ(find_rule("no-such-rule"), nullptr);
}

TEST(Registry, SelectsByIdNameAndPrefix) {
  const RuleIdentity& rule = *find_rule("GC106");
  EXPECT_TRUE(selected(rule, {}, {}));
  EXPECT_TRUE(selected(rule, {"GC1"}, {}));
  EXPECT_TRUE(selected(rule, {"GC501", "edge-zone"}, {}));
  EXPECT_FALSE(selected(rule, {"GC5"}, {}));
  EXPECT_FALSE(selected(rule, {}, {"GC106"}));
  EXPECT_FALSE(selected(rule, {"GC106"}, {"GC1"}));
}

}  // namespace
}  // namespace gapcheck::audit::registry_test
