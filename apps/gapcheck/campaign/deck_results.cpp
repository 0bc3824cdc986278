#include "campaign/deck_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "audit/repair/finding_repairs.hpp"
#include "commands.hpp"

namespace gapcheck::app {
namespace {

bool has_part(const Report& report, std::int64_t id) {
  return std::find(report.unknown_parts.begin(), report.unknown_parts.end(), id) == report.unknown_parts.end();
}

}  // namespace

bool has_contact(const Report& report, std::int64_t id) {
  return std::any_of(report.contacts.begin(), report.contacts.end(),
                     [id](const ContactSummary& summary) { return summary.id == id; });
}

void check_ids(const DeckResults& results, const AskedIds& ids, bool several, Failures& failures) {
  if (results.reports.empty()) return;
  const auto check = [&](std::string_view option, std::string_view thing, const std::vector<std::int64_t>& asked,
                         const auto& has) {
    for (const std::int64_t id : asked)
      if (std::none_of(results.reports.begin(), results.reports.end(), [&](const Report& r) { return has(r, id); }))
        failures.add(plain_error(fmt::format(
            "{} {}: {} {}", option, id, several ? "none of the decks has such a" : "the deck has no such", thing)));
  };
  check("--contact", "contact", ids.contacts, has_contact);
  check("--part", "part", ids.parts, has_part);
}

int write_results(const DeckResults& results, const OutputOptions& output, const OverviewOptions& overview,
                  Failures& failures) {
  const report::Reports reports(results.reports, results.unread);
  write(reports, overview, failures);
  std::vector<report::FindingFixes> fixes;
  for (std::size_t i = 0; i < results.plans.size(); ++i)
    fixes.push_back(audit::solving_repairs(results.plans[i], results.reports[i]));
  failures.add(write(reports, output, fixes));
  if (failures.any()) return failed;
  int code = clean;
  for (const Report& report : results.reports) code = std::max(code, exit_code(report, output.fail_on));
  return code;
}

}  // namespace gapcheck::app
