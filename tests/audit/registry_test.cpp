#include "audit/registry.hpp"

#include <gtest/gtest.h>

#include <set>

namespace gapcheck::audit::registry_test {
namespace {

TEST(Registry, RulesAscendAndHaveTextAndPages) {
  ASSERT_FALSE(rules().empty());
  std::set<std::string_view> names;
  std::string_view last;
  for (const RuleInfo& rule : rules()) {
    EXPECT_LT(last, rule.id);
    EXPECT_TRUE(rule.id.starts_with("GC") && rule.id.size() == 5) << rule.id;
    EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
    EXPECT_FALSE(rule.summary.empty()) << rule.id;
    EXPECT_FALSE(page(rule).empty()) << rule.id;
    last = rule.id;
  }
}

TEST(Registry, FindsByIdAndNameInAnyCase) {
  for (const char* name : {"GC101", "gc101", "initial-penetration", "Initial-Penetration"}) {
    const RuleInfo* rule = find_rule(name);
    ASSERT_NE(rule, nullptr) << name;
    EXPECT_EQ(rule->id, "GC101");
  }
  EXPECT_EQ(find_rule("GC1"), nullptr);
  EXPECT_EQ(find_rule(""), nullptr);
  EXPECT_EQ(find_rule("no-such-rule"), nullptr);
}

TEST(Registry, SelectsByIdNameAndPrefix) {
  const RuleInfo& rule = *find_rule("GC106");
  EXPECT_TRUE(selected(rule, {}, {}));
  EXPECT_TRUE(selected(rule, {"GC1"}, {}));
  EXPECT_TRUE(selected(rule, {"GC501", "edge-zone"}, {}));
  EXPECT_FALSE(selected(rule, {"GC5"}, {}));
  EXPECT_FALSE(selected(rule, {}, {"GC106"}));
  EXPECT_FALSE(selected(rule, {"GC106"}, {"GC1"}));
}

}  // namespace
}  // namespace gapcheck::audit::registry_test
