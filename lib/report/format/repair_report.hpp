#pragma once
#include <string>
#include <string_view>

#include "records/repair_plan.hpp"
#include "report/format/fix_report.hpp"

namespace gapcheck::report {

/// The repairs of each pair of parts as a table, best first, and the lines that they change.
[[nodiscard]] std::string plan_text(const RepairPlan& plan, const FixTextOptions& options);
/// The same as JSON, schema `gapcheck-fix-plan/1`, complete.
[[nodiscard]] std::string plan_json(const RepairPlan& plan);

/// The same as SARIF 2.1.0: a result for each pair of parts and each tie, and as its fixes the repairs that solve it,
/// best first, with the lines that they change (except moves, which change those of many nodes). `version` is the
/// program's.
[[nodiscard]] std::string plan_sarif(const RepairPlan& plan, std::string_view version);

/// What repairs have done: contacts before and after, changed lines.
[[nodiscard]] std::string applied_text(const AppliedRepairs& applied, const FixTextOptions& options);
/// The same as JSON, schema `gapcheck-fix-applied/1`.
[[nodiscard]] std::string applied_json(const AppliedRepairs& applied);

}  // namespace gapcheck::report
