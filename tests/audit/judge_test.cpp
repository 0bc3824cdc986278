#include "audit/judge.hpp"

#include <string>
#include <vector>

#include "audit/registry.hpp"
#include "audit/rules/judged_run.hpp"
#include "audit/run.hpp"

namespace gapcheck::audit_test::judge_test {
namespace {

/// A run with something for most rules.
JudgedRun bad_run() {
  JudgedRun run;
  run.internal(100);
  run.sleout(1, 3, -50, 0, 0);
  run.sleout(2, 4, 50, 0, 0);
  run.rcforc(1, 3, Vector(1, 0, 0), Vector(1, 0, 0));
  run.log.termination = SolverRun::Termination::error;
  return run;
}

Report judged(const JudgedRun& run, const audit::JudgeOptions& options) {
  Report report;
  report.run = run.log;
  static_cast<void>(audit::judge_run(run.files, options, report));
  return report;
}

TEST(Judge, FindingsComeInOrderOfTheirRules) {
  const Report report = judged(bad_run(), {});
  std::vector<std::string> ids;
  for (const Finding& f : report.findings) ids.push_back(f.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"GC601", "GC602", "GC606", "GC607", "GC608"}));
}

TEST(Judge, SelectAndIgnore) {
  EXPECT_EQ(judged(bad_run(), {{"GC607"}, {}, {}}).findings.size(), 1u);
  EXPECT_EQ(judged(bad_run(), {{"run-"}, {}, {}}).findings.size(), 1u);
  const Report rest = judged(bad_run(), {{}, {"GC601", "GC602"}, {}});
  ASSERT_EQ(rest.findings.size(), 3u);
  EXPECT_EQ(rest.findings[0].id, "GC606");
  EXPECT_EQ(rest.findings[1].id, "GC607");
  EXPECT_EQ(rest.findings[2].id, "GC608");
  EXPECT_TRUE(judged(bad_run(), {{}, {"GC6"}, {}}).findings.empty());
  EXPECT_TRUE(judged(bad_run(), {{"GC1"}, {}, {}}).findings.empty()) << "rules on decks never judge a run";
}

TEST(Judge, ADeckIsNotJudgedByRulesOnRuns) {
  audit::AuditOptions options;
  options.select = {"GC6"};
  const AuditRun run = run_text("*KEYWORD\n*END\n", options);
  EXPECT_TRUE(clean(run)) << describe(run.diagnostics);
  EXPECT_TRUE(run.report.findings.empty());
}

TEST(Judge, TheRegistryKnowsWhichIsWhich) {
  for (const RuleIdentity& rule : audit::rules()) EXPECT_EQ(rule.of_runs(), rule.id.starts_with("GC6")) << rule.id;
}

TEST(Judge, NothingIsJudgedByNothing) {
  JudgedRun run;
  Report report;
  const auto skips = audit::judge_run(run.files, {}, report);
  EXPECT_TRUE(report.findings.empty());
  EXPECT_EQ(skips.size(), 7u) << "all but GC608, which needs the log alone";
  EXPECT_EQ(report.statistics.size(), skips.size());
}

TEST(Judge, AnyNumbers) {
  const std::vector<double> odd{0, -0.0, 1e300, -1e300, 1.7e308, -1.7e308, 5e-324, no_number, 1};
  JudgedRun run;
  for (const double a : odd)
    for (const double b : odd) {
      auto& state = run.global(a);
      state.internal = state.kinetic = b;
      state.total = state.hourglass = state.time_step = a;
      state.sliding = state.external = state.ratio = b;
      state.walls = {{1, a}, {2, b}};
      run.sleout(b, 3, a, b, a);
      run.rcforc(b, 3, Vector(a, b, a), Vector(b, b, a));
      run.part(a, 3, b, a);
    }
  run.log.contact_timestep = 1e-300;
  const Report report = judged(run, {});
  EXPECT_FALSE(report.findings.empty());
  for (const Finding& f : report.findings) EXPECT_FALSE(f.message.empty());
}

}  // namespace
}  // namespace gapcheck::audit_test::judge_test
