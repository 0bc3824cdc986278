#include <fmt/format.h>

#include "audit/rules.hpp"

namespace gapcheck::audit::rule::unused_ignore {
namespace {

void review(const RuleIdentity& rule, const IgnoreOutcome& ignores, Report& report) {
  for (const IgnoreOutcome::Place& place : ignores.unused)
    report.findings.push_back(finding(
        rule, fmt::format("the ignore of {} matches no finding; remove it, or correct its rules and ids", place.rules),
        place.file, place.line));
}

}  // namespace

const Rule definition{.identity = {"GC513", "unused-ignore", Severity::warning, "an ignore matches no finding",
                                   Need::ignores, "The ignore does nothing"},
                      .review = review};

}  // namespace gapcheck::audit::rule::unused_ignore
