#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/threshold.hpp"
#include "records/rule_identity.hpp"

namespace gapcheck::audit {

/// All rules, ascending by id.
[[nodiscard]] std::span<const RuleIdentity> rules();
/// By id or name, ignoring case; nullptr if there is none.
[[nodiscard]] const RuleIdentity* find_rule(std::string_view id_or_name);
/// What a settings file may replace of a rule; empty for most.
[[nodiscard]] std::span<const Threshold> thresholds(const RuleIdentity& rule);
/// Rules that a person may mean: those whose id begins with a text, or whose name has it; ascending by id.
[[nodiscard]] std::vector<const RuleIdentity*> rules_with(std::string_view text);
/// The name of the rule that was probably meant (base/nearest_name.hpp); `of_runs`: of a rule on results, otherwise on
/// decks. Empty: none is similar, or an id was written, whose neighbours are no better.
[[nodiscard]] std::string_view nearest_rule(std::string_view written, bool of_runs);
/// True if the rule is picked by `select` (empty: all) and not by `ignore`; both hold ids, names or prefixes of them.
[[nodiscard]] bool selected(const RuleIdentity& rule, const std::vector<std::string>& select,
                            const std::vector<std::string>& ignore);
/// The rule's page, compiled in; markdown. Empty if there is none.
[[nodiscard]] std::string_view page(const RuleIdentity& rule);

}  // namespace gapcheck::audit
