#pragma once
#include <span>

#include "audit/rule.hpp"

namespace gapcheck::audit {

/// Every rule, in the order of the build's list (lib/audit/CMakeLists.txt).
[[nodiscard]] std::span<const Rule* const> listed_rules();

/// Runs the selected rules on decks, or on runs, in order of their ids. Rules whose findings are records are only
/// counted.
void run_rules(Context& context, RuleLog& log, Report& report);
void run_rules(RunContext& context, Report& report);
/// Runs the selected rules on ignores: last, when all other findings are known.
void review_ignores(const AuditOptions& options, const IgnoreOutcome& ignores, Report& report);

}  // namespace gapcheck::audit
