#include "audit/rules/judged_run.hpp"

namespace gapcheck::audit_test::hourglass_share_test {
namespace {

TEST(HourglassShare, OfTheModel) {
  JudgedRun run;
  run.internal(100);
  run.files.glstat[1].hourglass = 9.9;
  EXPECT_TRUE(run.findings("GC604").empty());
  EXPECT_EQ(run.skips.size(), 1u) << "no matsum";
  run.files.glstat[1].hourglass = 10.1;
  const Finding f = run.finding("GC604");
  EXPECT_EQ(f.message, "the hourglass energy reaches 10.1 at time 5: 10.1 % of the peak internal energy");
}

TEST(HourglassShare, OfParts) {
  JudgedRun run;
  run.internal(100);
  run.part(0, 7, 0, 0);
  run.part(0, 8, 0, 0);
  run.part(0, 9, 0, 0);
  run.part(1, 7, 20, 2.1);   // 10.5 % of its own
  run.part(1, 8, 50, 4.9);   // less than 10 %
  run.part(1, 9, 0.1, 0.9);  // 0.9 % of the model
  const Finding f = run.finding("GC604");
  EXPECT_EQ(f.part, 7);
  EXPECT_EQ(f.file, "out/matsum");
  EXPECT_TRUE(says(f, "part 7: the hourglass energy reaches 2.1 at time 1; the part's peak internal energy is 20"));
}

TEST(HourglassShare, ManyPartsAreCounted) {
  JudgedRun run;
  run.internal(100);
  for (std::int64_t part = 1; part <= 30; ++part) run.part(1, part, 1, 2);
  const auto list = run.findings("GC604");
  ASSERT_EQ(list.size(), 11u);
  EXPECT_EQ(list.back().count, 20u);
}

TEST(HourglassShare, WithoutGlstat) {
  JudgedRun run;
  run.part(1, 7, 20, 20);
  EXPECT_TRUE(run.findings("GC604").empty());
  EXPECT_EQ(run.skips.size(), 1u);
}

}  // namespace
}  // namespace gapcheck::audit_test::hourglass_share_test
