#include "audit/rules/judged_run.hpp"

namespace gapcheck::audit_test::sliding_energy_share_test {
namespace {

TEST(SlidingEnergyShare, NoteAndWarning) {
  for (const auto& [energy, found] : std::vector<std::pair<double, int>>{{49, 0}, {51, 1}, {99, 1}, {101, 2}}) {
    JudgedRun run;
    run.internal(1000);
    run.sleout(1, 3, energy + 200, 300, 500);
    run.sleout(2, 3, 200, 300, 500);
    const auto list = run.findings("GC602");
    ASSERT_EQ(list.size(), found > 0 ? 1u : 0u) << energy;
    if (found == 0) continue;
    EXPECT_EQ(list[0].severity, found == 1 ? Severity::note : Severity::warning) << energy;
    EXPECT_EQ(list[0].contact, 3);
    EXPECT_TRUE(says(list[0], "at time 1:")) << list[0].message;
  }
}

TEST(SlidingEnergyShare, NotWithoutSleoutAndNotOfRigidBodies) {
  JudgedRun run;
  run.internal(100);
  run.files.glstat[1].sliding = 50;
  EXPECT_TRUE(run.findings("GC602").empty());
  EXPECT_EQ(run.skips.size(), 1u);
  JudgedRun rigid;
  rigid.global(0).total = 50;
  rigid.sleout(1, 1, 40, 0, 0);
  EXPECT_TRUE(rigid.findings("GC602").empty());
  EXPECT_EQ(rigid.skips.size(), 1u);
}

}  // namespace
}  // namespace gapcheck::audit_test::sliding_energy_share_test
