#include "audit/rules/judged_run.hpp"

namespace gapcheck::audit_test::energy_ratio_test {
namespace {

/// Total energy 100 all along.
JudgedRun run_of(const std::vector<double>& ratios) {
  JudgedRun run;
  for (const double ratio : ratios) {
    auto& state = run.global(static_cast<double>(run.files.glstat.size()));
    state.total = 100;
    state.ratio = ratio;
  }
  return run;
}

TEST(EnergyRatio, FirstTimeAndFarthestValue) {
  const Finding f = run_of({1, 1.06, 1.02, 0.92, 1}).finding("GC603");
  EXPECT_EQ(f.severity, Severity::warning);
  EXPECT_EQ(f.file, "out/glstat");
  EXPECT_EQ(f.message, "the energy ratio leaves 0.95 to 1.05 at time 1; farthest from 1 is 0.92 at time 3");
  EXPECT_EQ(run_of({1, 1.06, 0.89}).finding("GC603").severity, Severity::error);
  EXPECT_TRUE(run_of({1, 1.049, 0.951}).findings("GC603").empty());
}

TEST(EnergyRatio, StatesWithNextToNoEnergyAreNotJudged) {
  JudgedRun run = run_of({1, 1.5, 1});
  run.files.glstat[0].total = 1e-20;
  run.files.glstat[1].total = 0.5;
  EXPECT_TRUE(run.findings("GC603").empty());
  run.files.glstat[1].external = 50;
  EXPECT_EQ(run.findings("GC603").size(), 1u) << "energy that was put in and is gone";
}

TEST(EnergyRatio, EnergiesThatAreNoNumbers) {
  JudgedRun run = run_of({1, 1, 1});
  run.files.glstat[1].kinetic = no_number;
  const Finding f = run.finding("GC603");
  EXPECT_EQ(f.severity, Severity::error);
  EXPECT_TRUE(says(f, "no numbers any more from time 1 on"));
  EXPECT_TRUE(JudgedRun().findings("GC603").empty());
}

}  // namespace
}  // namespace gapcheck::audit_test::energy_ratio_test
