#pragma once
#include <span>

#include "audit/audit_steps.hpp"
#include "audit/rule.hpp"

namespace gapcheck::audit {

/// Every rule, in the order of the build's list (lib/audit/CMakeLists.txt).
[[nodiscard]] std::span<const Rule* const> listed_rules();

/// How many rules on decks are selected.
[[nodiscard]] std::size_t selected_rules(const AuditOptions& options);

/// Runs the selected rules on decks, or on runs, in order of their ids. Rules whose findings are records are only
/// counted. False: the steps are to stop.
[[nodiscard]] bool run_rules(Context& context, AuditSteps& steps, RuleLog& log, Report& report);
void run_rules(RunContext& context, Report& report);
/// Runs the selected rules on ignores: last, when all other findings are known.
void review_ignores(const AuditOptions& options, const IgnoreOutcome& ignores, Report& report);

}  // namespace gapcheck::audit
