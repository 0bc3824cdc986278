#include <mutex>

#include "base/parallel.hpp"
#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"
#include "report/item/item.hpp"
#include "report/text/check_c_view.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {
namespace {

void count(Severity severity, Totals& sum) {
  switch (severity) {
    case Severity::error:
      ++sum.errors;
      break;
    case Severity::warning:
      ++sum.warnings;
      break;
    case Severity::note:
      ++sum.notes;
      break;
  }
}

Totals totals_by_severity(const Report& report, bool with_known) {
  constexpr std::size_t grain = std::size_t{1} << 15;  // of records, which may be a million
  const auto counts = [&](std::size_t number) {
    return with_known || state_of(report, number) != BaselineState::unchanged;
  };
  Totals sum;
  std::mutex mutex;
  parallel_for(report.penetrations.size(), grain, [&](std::size_t begin, std::size_t end) {
    Totals piece;
    for (std::size_t i = begin; i < end; ++i)
      if (counts(i)) count(severity_of(report, report.penetrations[i]), piece);
    const std::scoped_lock lock(mutex);
    sum += piece;
  });
  std::size_t number = report.penetrations.size();
  for (const TieFailure& failure : report.tie_failures)
    if (counts(number++)) count(rule_of(report, failure).severity, sum);
  for (const Finding& finding : report.findings)
    if (counts(number++)) count(finding.severity, sum);
  for (const ContactSummary& contact : report.contacts) sum.warnings += unlisted_penetrations(contact);
  sum.warnings += run_warnings(report);
  return sum;
}

}  // namespace

Totals totals(const Report& report) { return totals_by_severity(report, true); }
Totals counting_totals(const Report& report) { return totals_by_severity(report, false); }

}  // namespace gapcheck::report
