#include "audit/rules/judged_run.hpp"

namespace gapcheck::audit_test::contact_step_test {
namespace {

JudgedRun run_at(double step) {
  JudgedRun run;
  run.global(0).time_step = step / 2;
  run.global(1).time_step = step;
  run.log.contact_timestep = 1.669e-7;
  run.log.surface_timesteps = {{0, 'A', "a3", 1.605e-6, 19394, 2}, {1, 'B', "a3", 1.669e-7, 51, 1}};
  run.contacts.resize(2);
  run.contacts[0].id = 80086;
  run.contacts[1].id = 8009;
  return run;
}

TEST(ContactStep, NamesTheSurfaceThatControls) {
  const Finding f = run_at(2.1e-7).finding("GC605");
  EXPECT_EQ(f.severity, Severity::note);
  EXPECT_EQ(f.contact, 8009);
  EXPECT_EQ(f.node, 51);
  EXPECT_EQ(f.part, 1);
  EXPECT_EQ(f.message,
            "the time step is up to 2.1e-07, 1.26 times the 1.669e-07 that the solver says should not be exceeded "
            "(surface B, node 51)");
}

TEST(ContactStep, EqualButForPrintingIsNone) {
  EXPECT_TRUE(run_at(1.669e-7).findings("GC605").empty());
  EXPECT_TRUE(run_at(1.6695e-7).findings("GC605").empty());
  EXPECT_EQ(run_at(1.68e-7).findings("GC605").size(), 1u);
}

TEST(ContactStep, ImplicitSteps) {
  JudgedRun run = run_at(2.1e-7);
  run.log.element_timestep = 1.7e-7;
  EXPECT_EQ(run.findings("GC605").size(), 1u);
  run.files.glstat.back().time_step = 0.1;
  EXPECT_TRUE(run.findings("GC605").empty());
  EXPECT_EQ(run.skips.size(), 1u);
}

TEST(ContactStep, LogsThatNameNoLimitOrNoSurface) {
  JudgedRun run = run_at(1);
  run.log.surface_timesteps.clear();
  EXPECT_EQ(run.finding("GC605").contact, 0);
  run.log.contact_timestep = 0;
  EXPECT_TRUE(run.findings("GC605").empty());
  EXPECT_EQ(run.skips.size(), 1u);
  EXPECT_TRUE(JudgedRun().findings("GC605").empty());
}

}  // namespace
}  // namespace gapcheck::audit_test::contact_step_test
