#include "audit/rules.hpp"

namespace gapcheck::audit::rule::bad_ignore {
namespace {

void review(const RuleInfo& rule, const Context& context, Report& report) {
  for (const IgnoreOutcome::Bad& bad : context.ignores().bad)
    report.findings.push_back(finding(rule, bad.what, bad.file, bad.line));
}

}  // namespace

const Rule definition{
    .info = {"GC515", "bad-ignore", Severity::warning, "a comment to gapcheck is not understood, so it leaves out nothing"},
    .review = review};

}  // namespace gapcheck::audit::rule::bad_ignore
