#include "audit/rules/judged_run.hpp"

namespace gapcheck::audit_test::sudden_energy_test {
namespace {

struct Energies {
  double kinetic = 0, internal = 0, sliding = 0, external = 0;
};

JudgedRun run_of(const std::vector<Energies>& states) {
  JudgedRun run;
  for (const Energies& e : states) {
    auto& state = run.global(static_cast<double>(run.files.glstat.size()));
    state.kinetic = e.kinetic;
    state.internal = e.internal;
    state.sliding = e.sliding;
    state.external = e.external;
    state.total = e.kinetic + e.internal + e.sliding;
  }
  return run;
}

TEST(SuddenEnergy, ImpactReboundAndLoadsAreExplained) {
  EXPECT_TRUE(run_of({{100, 0, 0, 0}, {5, 60, 35, 0}, {98, 2, 0, 0}}).findings("GC606").empty());
  EXPECT_TRUE(run_of({{0, 0, 0, 0}, {80, 20, 0, 100}, {0, 0, 0, 0}}).findings("GC606").empty());
}

TEST(SuddenEnergy, TheTotalJumps) {
  const Finding f = run_of({{100, 0, 0, 0}, {100, 3, 0, 0}, {100, 13, 0, 0}, {100, 13, 0, 0}}).finding("GC606");
  EXPECT_EQ(f.severity, Severity::warning);
  EXPECT_EQ(f.message, "the total energy changes by 10 between time 1 and 2, 8.85 % of the peak energy, without work");
  EXPECT_EQ(run_of({{100, 0, 0, 0}, {80, 0, 0, 0}}).findings("GC606").size(), 1u) << "downwards too";
}

// What a contact below zero pays for: the total does not see it.
TEST(SuddenEnergy, ANodeIsShotOff) {
  const auto list = run_of({{100, 0, 0, 0}, {140, 0, -40, 0}, {150, 0, -50, 0}}).findings("GC606");
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].message,
            "the kinetic energy gains 40 between time 0 and 1, 40 % of the peak energy, without work; the largest of 2 "
            "such jumps");
}

TEST(SuddenEnergy, WhatCannotBeJudged) {
  JudgedRun run = run_of({{100, 0, 0, 0}, {no_number, 0, 0, 0}, {100, 0, 0, 0}});
  EXPECT_TRUE(run.findings("GC606").empty());
  EXPECT_TRUE(run_of({{0, 0, 0, 0}, {0, 0, 0, 0}}).findings("GC606").empty());
  JudgedRun one = run_of({{100, 0, 0, 0}});
  EXPECT_TRUE(one.findings("GC606").empty());
  EXPECT_EQ(one.skips.size(), 1u);
}

}  // namespace
}  // namespace gapcheck::audit_test::sudden_energy_test
