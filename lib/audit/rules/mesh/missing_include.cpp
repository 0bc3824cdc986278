#include <fmt/format.h>

#include <algorithm>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"

namespace gapcheck::audit::rule::missing_include {
namespace {

std::string words(const keyword::MissingInclude& include) {
  if (include.written_by > 0)
    return fmt::format("include \"{}\" is written by the run of *CASE {}: what starts from there is judged without it",
                       include.name, include.written_by);
  return fmt::format(
      "include \"{}\" was not found, and what it defines is missing: correct its name, or give its folder "
      "with -I",
      include.name);
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const bool skipped = context.options().read.skip_missing_includes;
  const auto missing = context.deck().missing_includes();
  for (std::size_t i = 0; i < missing.size() && i < found_in_full; ++i) {
    report.findings.push_back(finding(rule, words(missing[i]), context.path(missing[i].file), missing[i].line));
    Finding& f = report.findings.back();
    if (skipped || missing[i].written_by > 0) f.severity = Severity::warning;
    if (missing[i].written_by > 0)
      f.consequence = "A run starts from what an earlier *CASE leaves, which is not known here";
  }
  if (missing.size() <= found_in_full) return;
  report.findings.push_back(
      finding(rule, fmt::format("{} more includes were not found", missing.size() - found_in_full), "", 0));
  report.findings.back().count = missing.size() - found_in_full;
  const auto error = [&](const keyword::MissingInclude& include) { return !skipped && include.written_by == 0; };
  if (std::none_of(missing.begin() + found_in_full, missing.end(), error))
    report.findings.back().severity = Severity::warning;
}

}  // namespace

const Rule definition{{"GC901", "missing-include", Severity::error, "a file that the deck includes was not found",
                       Need::model, "The solver stops; here everything that the file defines is missing"},
                      run};

}  // namespace gapcheck::audit::rule::missing_include
