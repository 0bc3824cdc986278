#include "model/unknown_keyword.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"

namespace gapcheck::audit::rule::unknown_keyword {
namespace {

Finding finding_of(const RuleIdentity& rule, const Context& context, const model::UnknownKeyword& unknown,
                   bool look_up) {
  const std::string nearest = look_up ? model::nearest_keyword(unknown) : std::string();
  Finding found =
      finding(rule, model::describe(unknown, nearest), context.path(unknown.place.file), unknown.place.line);
  found.severity = model::severity(unknown, nearest);
  return found;
}

/// Adds those of one severity: the first in full, the rest in one line with `beyond` that are not among them.
void add(Report& report, const std::vector<Finding>& found, Severity severity, std::uint64_t beyond) {
  std::vector<Finding> same;
  std::copy_if(found.begin(), found.end(), std::back_inserter(same),
               [severity](const Finding& one) { return one.severity == severity; });
  const std::size_t shown = std::min(same.size(), found_in_full);
  const std::uint64_t more = same.size() - shown + beyond;
  report.findings.insert(report.findings.end(), same.begin(), same.begin() + static_cast<std::ptrdiff_t>(shown));
  if (same.empty() || more == 0) return;
  Finding rest = same[std::min(shown, same.size() - 1)];
  rest.message = fmt::format("{} more keywords are not known, the first of them here", more);
  rest.count = more;
  report.findings.push_back(std::move(rest));
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const model::UnknownKeyword& unknown : context.model().unknown_keywords)
    found.push_back(finding_of(rule, context, unknown, found.size() < model::unknown_keywords_looked_up));
  const auto is_warning = [](const Finding& one) { return one.severity == Severity::warning; };
  const std::uint64_t beyond = context.model().more_unknown_keywords;
  const bool warnings = std::any_of(found.begin(), found.end(), is_warning);
  add(report, found, Severity::error, warnings ? 0 : beyond);
  add(report, found, Severity::warning, beyond);
}

}  // namespace

const Rule definition{
    {"GC516", "unknown-keyword", Severity::error, "the manual has no keyword of this name, so its data is lost",
     Need::model, "The solver stops, or the data of the keyword is lost"},
    run};

}  // namespace gapcheck::audit::rule::unknown_keyword
