#include "audit/rules.hpp"

namespace gapcheck::audit::rule::bad_ignore {
namespace {

void review(const RuleIdentity& rule, const IgnoreOutcome& ignores, Report& report) {
  for (const IgnoreOutcome::Bad& bad : ignores.bad)
    report.findings.push_back(finding(rule, bad.what, bad.file, bad.line));
}

}  // namespace

const Rule definition{.identity = {"GC515", "bad-ignore", Severity::warning,
                                   "a comment to gapcheck is not understood, so it leaves out nothing", Need::ignores,
                                   "The ignore does nothing"},
                      .review = review};

}  // namespace gapcheck::audit::rule::bad_ignore
