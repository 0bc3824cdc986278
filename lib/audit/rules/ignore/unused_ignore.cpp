#include <fmt/format.h>

#include "audit/rules.hpp"

namespace gapcheck::audit::rule::unused_ignore {
namespace {

void review(const RuleInfo& rule, const Context& context, Report& report) {
  for (const IgnoreOutcome::Place& place : context.ignores().unused)
    report.findings.push_back(finding(
        rule, fmt::format("the ignore of {} matches no finding; remove it, or correct its rules and ids", place.rules),
        place.file, place.line));
}

}  // namespace

const Rule definition{.info = {"GC513", "unused-ignore", Severity::warning, "an ignore matches no finding"},
                         .review = review};

}  // namespace gapcheck::audit::rule::unused_ignore
