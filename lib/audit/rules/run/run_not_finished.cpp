#include <fmt/format.h>

#include <algorithm>

#include "audit/rules.hpp"
#include "audit/run_context.hpp"

namespace gapcheck::audit::rule::run_not_finished {
namespace {

/// The last step need not meet the end time.
constexpr double end_share = 0.999;

/// Of glstat or the log, whichever is later.
double time_reached(const RunContext& context) {
  const auto& states = context.files().glstat;
  return std::max(context.log().problem_time, states.empty() ? 0.0 : states.back().time);
}

/// " at time 1.5 of 2"; as far as known.
std::string place(double time, double end) {
  std::string text = time > 0 ? fmt::format(" at time {:.6g}", time) : "";
  return end > 0 ? text + fmt::format("{} {:.6g}", text.empty() ? " before time" : " of", end) : text;
}

void judge(const RuleIdentity& rule, RunContext& context, Report& report) {
  using enum SolverRun::Termination;
  const SolverRun& log = context.log();
  const double time = time_reached(context);
  const auto add = [&](Severity severity, std::string message) {
    const std::string file = report.files.empty() ? std::string() : report.files.front();
    Finding f = finding(rule, std::move(message), file, 0);
    f.severity = severity;
    report.findings.push_back(std::move(f));
  };
  if (log.termination == error) {
    add(rule.severity, "the solver ended with an error" + place(time, log.end_time));
  } else if (log.termination == normal) {
    if (log.end_time > 0 && time > 0 && time < end_share * log.end_time)
      add(Severity::warning, "the run ended early" + place(time, log.end_time));
  } else if (!context.files().glstat.empty()) {
    add(Severity::warning,
        "the log names no end: the run goes on, or was ended from outside" + place(time, log.end_time));
  }
}

}  // namespace

const Rule definition{{"GC608", "run-not-finished", Severity::error, "the run did not reach its end", Need::run_files,
                       "The results end early"},
                      nullptr,
                      judge};

}  // namespace gapcheck::audit::rule::run_not_finished
