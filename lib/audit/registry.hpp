#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "records/report.hpp"

namespace gapcheck::audit {

/// Public facts about a rule. Its page is docs/rules/<name>.md.
struct RuleInfo {
  std::string_view id;       ///< "GC101"
  std::string_view name;     ///< "initial-penetration"
  Severity severity;
  std::string_view summary;  ///< one line
  bool of_runs = false;      ///< judges the output of a run, not a deck
  bool of_ignores = false;   ///< judges the demands to leave findings out
};

/// All rules, ascending by id.
[[nodiscard]] std::span<const RuleInfo> rules();
/// By id or name, ignoring case; nullptr if there is none.
[[nodiscard]] const RuleInfo* find_rule(std::string_view id_or_name);
/// True if the rule is picked by `select` (empty: all) and not by `ignore`; both hold ids, names or prefixes of them.
[[nodiscard]] bool selected(const RuleInfo& rule, const std::vector<std::string>& select,
                            const std::vector<std::string>& ignore);
/// The rule's page, compiled in; markdown. Empty if there is none.
[[nodiscard]] std::string_view page(const RuleInfo& rule);

}  // namespace gapcheck::audit
