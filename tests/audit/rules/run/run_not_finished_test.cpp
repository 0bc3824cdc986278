#include "audit/rules/judged_run.hpp"

namespace gapcheck::audit_test::run_not_finished_test {
namespace {

using enum SolverRun::Termination;

JudgedRun ended(SolverRun::Termination how, double time, double end) {
  JudgedRun run;
  run.log.termination = how;
  run.log.problem_time = time;
  run.log.end_time = end;
  return run;
}

TEST(RunNotFinished, ErrorTermination) {
  const Finding f = ended(error, 0.1, 240).finding("GC608");
  EXPECT_EQ(f.severity, Severity::error);
  EXPECT_EQ(f.file, "out/messag");
  EXPECT_EQ(f.message, "the solver ended with an error at time 0.1 of 240");
  EXPECT_EQ(ended(error, 0, 0).finding("GC608").message, "the solver ended with an error");
  EXPECT_EQ(ended(error, 0, 240).finding("GC608").message, "the solver ended with an error before time 240");
}

TEST(RunNotFinished, NormalTerminationBeforeTheEnd) {
  const Finding f = ended(normal, 100, 240).finding("GC608");
  EXPECT_EQ(f.severity, Severity::warning);
  EXPECT_EQ(f.message, "the run ended early at time 100 of 240");
  EXPECT_TRUE(ended(normal, 239.9, 240).findings("GC608").empty());
  EXPECT_TRUE(ended(normal, 100, 0).findings("GC608").empty());
  JudgedRun longer = ended(normal, 100, 240);
  longer.global(240);
  EXPECT_TRUE(longer.findings("GC608").empty()) << "glstat has gone on";
}

TEST(RunNotFinished, LogsWithoutAnEnd) {
  JudgedRun run = ended(unknown, 1, 2);
  EXPECT_TRUE(run.findings("GC608").empty()) << "a log alone may be a part of one";
  run.global(1.5);
  EXPECT_EQ(run.finding("GC608").severity, Severity::warning);
  EXPECT_TRUE(says(run.finding("GC608"), "at time 1.5 of 2"));
}

}  // namespace
}  // namespace gapcheck::audit_test::run_not_finished_test
