#include <fmt/format.h>

#include "audit/rules.hpp"

namespace gapcheck::audit::rule::expired_ignore {
namespace {

std::string words(const IgnoreOutcome::Place& place) {
  const std::chrono::year_month_day day = place.until.value_or(std::chrono::year_month_day{});
  const std::string held =
      fmt::format("the ignore of {} held until {:04}-{:02}-{:02}", place.rules, static_cast<int>(day.year()),
                  static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
  if (place.matched == 0) return held + " and would leave out nothing; remove it";
  return fmt::format("{}; the {} that it would leave out count{} again: mend {}, or give a later day", held,
                     place.matched == 1 ? "finding" : fmt::format("{} findings", place.matched),
                     place.matched == 1 ? "s" : "", place.matched == 1 ? "it" : "them");
}

void review(const RuleIdentity& rule, const IgnoreOutcome& ignores, Report& report) {
  for (const IgnoreOutcome::Place& place : ignores.expired)
    report.findings.push_back(finding(rule, words(place), place.file, place.line));
}

}  // namespace

const Rule definition{.identity = {"GC514", "expired-ignore", Severity::warning, "the last day of an ignore is over",
                                   Need::ignores, "The finding is no longer left out"},
                      .review = review};

}  // namespace gapcheck::audit::rule::expired_ignore
