#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"

namespace gapcheck::audit::rule::missing_include {
namespace {

void run(const RuleIdentity& identity, Context& context, Report& report) {
  RuleIdentity rule = identity;
  if (context.options().read.skip_missing_includes) rule.severity = Severity::warning;
  const auto missing = context.deck().missing_includes();
  for (std::size_t i = 0; i < missing.size() && i < found_in_full; ++i)
    report.findings.push_back(
        finding(rule,
                fmt::format("include \"{}\" was not found, and what it defines is missing: correct its name, or give "
                            "its folder with -I",
                            missing[i].name),
                context.path(missing[i].file), missing[i].line));
  if (missing.size() <= found_in_full) return;
  report.findings.push_back(
      finding(rule, fmt::format("{} more includes were not found", missing.size() - found_in_full), "", 0));
  report.findings.back().count = missing.size() - found_in_full;
}

}  // namespace

const Rule definition{{"GC901", "missing-include", Severity::error, "a file that the deck includes was not found",
                       Need::model, "The solver stops; here everything that the file defines is missing"},
                      run};

}  // namespace gapcheck::audit::rule::missing_include
