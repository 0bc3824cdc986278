#include <tuple>

#include "audit/rules/judged_run.hpp"

namespace gapcheck::audit_test::negative_sliding_energy_test {
namespace {

TEST(NegativeSlidingEnergy, WithoutTheFrictionThatBothSidesContain) {
  JudgedRun run;
  run.internal(1000);
  for (const double time : {0.0, 2.0, 5.0, 7.0}) {
    run.sleout(time, 3, time > 1 ? 10 : 0, -10, time > 4 ? 30 : 0);  // -30 from time 5 on
    run.sleout(time, 4, -20, 60, 40);                                // positive but for friction
  }
  const Finding f = run.finding("GC601");
  EXPECT_EQ(f.contact, 3);
  EXPECT_EQ(f.severity, Severity::warning);
  EXPECT_EQ(f.file, "out/sleout");
  EXPECT_EQ(f.message,
            "the sliding energy without friction falls to -30 at time 5: -3 % of the peak internal energy, -6 % of the "
            "internal energy then; below -1 % since time 5");
}

TEST(NegativeSlidingEnergy, LimitsOfWarningAndError) {
  for (const auto& [energy, found] : std::vector<std::pair<double, int>>{{-9.9, 0}, {-10.1, 1}, {-99, 1}, {-101, 2}}) {
    JudgedRun run;
    run.internal(1000);
    run.sleout(1, 3, energy, 0, 0);
    const auto list = run.findings("GC601");
    ASSERT_EQ(list.size(), found > 0 ? 1u : 0u) << energy;
    if (found > 0) {
      EXPECT_EQ(list[0].severity, found == 1 ? Severity::warning : Severity::error) << energy;
    }
  }
}

TEST(NegativeSlidingEnergy, WhatPrintingTakesAwayIsNone) {
  JudgedRun run;
  run.internal(10);
  run.sleout(1, 3, 5000, -5001, 0);
  EXPECT_TRUE(run.findings("GC601").empty()) << "four digits of 5000";
  run.sleout(2, 3, 5000, -5003, 0);
  EXPECT_EQ(run.findings("GC601").size(), 1u);
  // A unit of the last digit of either side and of the friction may be missing.
  for (const auto& [side_a, side_b, friction] :
       {std::tuple{5000., -5001.9, 0.}, std::tuple{-5001.9, 5000., 0.}, std::tuple{5., -5.001, 5000.}}) {
    JudgedRun rounded;
    rounded.internal(1);
    rounded.sleout(1, 3, side_a, side_b + (friction > 0 ? friction - 0.9 : 0), friction);
    EXPECT_TRUE(rounded.findings("GC601").empty()) << side_a << " " << side_b << " " << friction;
  }
}

TEST(NegativeSlidingEnergy, AllContactsByGlstatWithoutSleout) {
  JudgedRun run;
  run.internal(100);
  run.files.glstat[1].sliding = -5;
  const Finding f = run.finding("GC601");
  EXPECT_EQ(f.contact, 0);
  EXPECT_EQ(f.file, "out/glstat");
  EXPECT_FALSE(says(f, "without friction"));
  EXPECT_TRUE(run.skips.empty());
}

TEST(NegativeSlidingEnergy, RigidBodiesAgainstTheTotalEnergy) {
  JudgedRun run;
  for (const double time : {0.0, 1.0}) run.global(time).total = 50;
  run.sleout(1, 1, -0.4, 0, 0);
  EXPECT_TRUE(run.findings("GC601").empty());
  run.sleout(2, 1, -0.6, 0, 0);
  EXPECT_TRUE(says(run.finding("GC601"), "-1.2 % of the peak total energy;"));
}

TEST(NegativeSlidingEnergy, ContactsThatAreNotChosenNumbersThatAreNoneFilesThatAreMissing) {
  JudgedRun run;
  run.internal(100);
  run.sleout(1, 3, no_number, 0, 0);
  run.sleout(2, 3, -50, 0, 0);
  EXPECT_EQ(run.findings("GC601").size(), 1u);
  run.only = {4};
  EXPECT_TRUE(run.findings("GC601").empty());
  JudgedRun none;
  EXPECT_TRUE(none.findings("GC601").empty());
  EXPECT_EQ(none.skips, std::vector<std::string>{"GC601 negative-sliding-energy: there is neither sleout nor glstat"});
  none.sleout(1, 3, -50, 0, 0);
  EXPECT_TRUE(none.findings("GC601").empty());
  EXPECT_EQ(none.skips.size(), 1u) << "nothing to hold it against";
}

}  // namespace
}  // namespace gapcheck::audit_test::negative_sliding_energy_test
