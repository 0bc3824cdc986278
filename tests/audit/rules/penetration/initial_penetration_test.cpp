#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::initial_penetration_test {
namespace {

TEST(InitialPenetration, EveryNodeOverTheOtherPlateAndNoneWhenApart) {
  RuleDeck near, far;
  near.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  far = near;
  near.plate(101, 2, 2, 2, Vector(0, 0, 0.7), 5, 5).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  far.plate(101, 2, 2, 2, Vector(0, 0, 1), 5, 5).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  const Report report = run_rule("GC101", near);
  EXPECT_EQ(listed(report), 18U);
  ASSERT_EQ(report.penetrations.size(), 18U);
  for (const Penetration& p : report.penetrations) {
    EXPECT_EQ(p.kind, PenetrationKind::initial);
    EXPECT_NEAR(p.depth, 0.3, 1e-12);
    EXPECT_DOUBLE_EQ(p.contact_distance, 1);
    EXPECT_EQ(p.outcome, Outcome::moved);
    // 1.002 times the penetration away from the other plate
    EXPECT_LT((p.moved_to - p.original - Vector(0, 0, p.part == 1 ? -0.3006 : 0.3006)).norm(), 1e-12);
  }
  EXPECT_EQ(listed(run_rule("GC101", far)), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::initial_penetration_test
