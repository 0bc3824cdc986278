#include "audit/judge.hpp"

#include "audit/run_context.hpp"
#include "audit/run_rules.hpp"

namespace gapcheck::audit {

std::vector<std::string> judge_run(const results::RunResults& files, const JudgeOptions& options, Report& report) {
  const SolverRun nothing;
  RunContext context(files, report.run ? *report.run : nothing, report.contacts, options);
  run_rules(context, report);
  for (const std::string& skip : context.skips()) report.statistics.emplace_back("not judged", skip);
  return context.skips();
}

}  // namespace gapcheck::audit
