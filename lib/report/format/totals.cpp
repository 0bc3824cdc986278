#include "report/item/describe.hpp"
#include "report/item/describe_tie.hpp"
#include "report/item/item.hpp"
#include "report/text/check_c_view.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report {
namespace {

Totals totals_by_severity(const Report& report, bool with_known) {
  Totals sum;
  std::size_t number = 0;
  const auto add = [&](Severity severity) {
    if (state_of(report, number++) == BaselineState::unchanged && !with_known) return;
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
  };
  for (const Penetration& record : report.penetrations) add(severity_of(report, record));
  for (const TieFailure& failure : report.tie_failures) add(rule_of(report, failure).severity);
  for (const Finding& finding : report.findings) add(finding.severity);
  for (const ContactSummary& contact : report.contacts) sum.warnings += unlisted_penetrations(contact);
  sum.warnings += run_warnings(report);
  return sum;
}

}  // namespace

Totals totals(const Report& report) { return totals_by_severity(report, true); }
Totals counting_totals(const Report& report) { return totals_by_severity(report, false); }

}  // namespace gapcheck::report
