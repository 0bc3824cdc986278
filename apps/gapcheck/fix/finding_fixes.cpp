#include "fix/finding_fixes.hpp"

#include <cstddef>
#include <map>

#include "audit/repair/deck_edits.hpp"
#include "audit/repair/finding_repairs.hpp"
#include "audit/repair/repair_plan.hpp"
#include "fix/repaired_input.hpp"

namespace gapcheck::app {

bool repairable(const Report& report) {
  const std::size_t findings = report.penetrations.size() + report.tie_failures.size() + report.findings.size();
  for (std::size_t number = 1; number <= findings; ++number)
    if (audit::repair_target(report, number)) return true;
  return false;
}

Result<RepairPlan> plan_of_cards(const std::string& deck, const keyword::ReadOptions& read) {
  RepairedInput input(deck, read);
  Diagnostics repeated;  // the audit has said them
  const std::map<std::string, std::string> no_texts;
  const auto original = input.read(no_texts, repeated);
  if (!original) return original.error();
  auto plan = audit::plan_repairs(original.value(), {}, input.reread(), repeated, audit::Tried::cards);
  if (plan) audit::take_line_ends(original.value(), plan.value());
  return plan;
}

}  // namespace gapcheck::app
