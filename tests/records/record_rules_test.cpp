#include "records/record_rules.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace gapcheck::record_rules_test {
namespace {

TEST(RecordRules, EveryKindOfPenetrationHasItsOwnRule) {
  std::set<std::string_view> ids;
  for (std::size_t kind = 0; kind < penetration_kinds; ++kind)
    ids.insert(rule_of(static_cast<PenetrationKind>(kind)).id);
  EXPECT_EQ(ids, (std::set<std::string_view>{"GC101", "GC102", "GC106", "GC107", "GC108", "GC109"}));
}

TEST(RecordRules, OneRulePerOutcomeOfATie) {
  for (const TieReason reason : tie_reasons) {
    const std::string_view expected = reason == TieReason::sep      ? "GC204"
                                      : reason == TieReason::offset ? "GC202"
                                                                    : "GC201";
    EXPECT_EQ(rule_of(reason).id, expected);
    TieFailure failure{.reason = reason};
    EXPECT_EQ(rule_of(failure).id, expected);
    EXPECT_EQ(rule_of(failure).severity, rule_of(reason).severity);
    failure.by_node_set = true;
    EXPECT_EQ(rule_of(failure).severity, untied(reason) ? Severity::error : rule_of(reason).severity);
  }
}

// Only a node that the tie moves, and only where both sides have a thickness.
TEST(RecordRules, AMoveBeyondBothThicknessesIsAWarning) {
  TieFailure moved{.distance = 2.1, .thickness = 2, .reason = TieReason::sep};
  EXPECT_EQ(rule_of(moved).severity, Severity::warning);
  moved.distance = 2;
  EXPECT_EQ(rule_of(moved).severity, Severity::note);
  EXPECT_EQ(rule_of(TieFailure{.distance = 2.1, .reason = TieReason::sep}).severity, Severity::note);
  EXPECT_EQ(rule_of(TieFailure{.distance = 2.1, .thickness = 2, .reason = TieReason::too_far}).id, "GC201");
}

TEST(RecordRules, WorseFindingsOfOneFamilyHaveAHigherDegree) {
  const auto degree = [](std::string_view id, std::string_view family) {
    const RecordRule* rule = find_record_rule(id);
    EXPECT_NE(rule, nullptr) << id;
    EXPECT_EQ(rule == nullptr ? "" : rule->family, family);
    return rule == nullptr ? -1 : rule->degree;
  };
  EXPECT_LT(degree("GC106", "GC101"), degree("GC101", "GC101"));
  EXPECT_LT(degree("GC101", "GC101"), degree("GC102", "GC101"));
  EXPECT_LT(degree("GC204", "GC201"), degree("GC202", "GC201"));
  EXPECT_LT(degree("GC202", "GC201"), degree("GC201", "GC201"));
  for (const char* alone : {"GC107", "GC108", "GC109"}) EXPECT_EQ(degree(alone, alone), 0);
}

TEST(RecordRules, OtherRulesReportNoRecords) {
  EXPECT_EQ(find_record_rule("GC103"), nullptr);
  EXPECT_EQ(find_record_rule("initial-penetration"), nullptr) << "found by id only";
  EXPECT_EQ(find_record_rule(""), nullptr);
}

TEST(RuleNeeds, AreWhatWasDeclared) {
  constexpr RuleNeeds both = Need::surfaces | Need::crossings;
  static_assert(both.has(Need::surfaces) && both.has(Need::crossings) && !both.has(Need::model));
  static_assert(RuleNeeds(Need::model).has(Need::model) && !RuleNeeds(Need::model).has(Need::ignores));
  RuleNeeds sum = Need::crossings;
  sum |= Need::surfaces;
  EXPECT_EQ(sum, both);
}

}  // namespace
}  // namespace gapcheck::record_rules_test
