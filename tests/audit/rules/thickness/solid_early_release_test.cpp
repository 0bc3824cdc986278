#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::solid_early_release_test {
namespace {

// Bricks of 2 x 2 x height, and shells far away. Solids release at 0.5 x 0.4 V / A, shells at 0.4 (t + t).
RuleDeck bricks(double height, double shell, const std::string& card_b = "",
                const std::string& type = "AUTOMATIC_SINGLE_SURFACE") {
  RuleDeck deck;
  deck.solid_part(1).block(1, 1, 2, 1, 1, Vector(0, 0, 0), Vector(2, 2, height));
  if (shell > 0) deck.shell_part(2, shell).plate(101, 2, 1, 1, Vector(0, 0, 50), 20, 20);
  const std::string card_a = "0,0.1,0,0.,0,0,0,0\n";
  return deck.contact(3, type, "0,0,5,0", "0.\n1.,1.\n" + (card_b.empty() ? "" : card_a + card_b + "\n"));
}

TEST(SolidEarlyRelease, AtLessThanHalfOfTheThinnestShells) {
  const Report report = run_rule("GC306", bricks(2, 1.5));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].part, 1);
  EXPECT_EQ(report.findings[0].count, 10U);  // free faces of two bricks
  EXPECT_NE(report.findings[0].message.find("at a depth of 0.4, where the thinnest shells hold to 1.2"),
            std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC306", bricks(2, 1.01))), 1U);
  EXPECT_EQ(listed(run_rule("GC306", bricks(2, 0.99))), 0U);
}

TEST(SolidEarlyRelease, FlatElementsWhereThereAreNoShells) {
  // Top and bottom: V / A = 0.9, depth 0.18 < 0.1 x 2. The narrow sides have V / A = 2 and edges of 0.9.
  const Report report = run_rule("GC306", bricks(0.9, 0));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].count, 4U);
  EXPECT_EQ(listed(run_rule("GC306", bricks(1.1, 0))), 0U);
}

TEST(SolidEarlyRelease, NotWithACoatOrAnotherLimit) {
  EXPECT_EQ(listed(run_rule("GC306", bricks(2, 1.5, "0.,0,0,0,0,0,1."))), 0U);  // SLDTHK = 1
  EXPECT_EQ(listed(run_rule("GC306", bricks(2, 0.9, "0.5"))),
            1U);  // PENMAX: 0.4 < 0.5 x 0.5 x 1.8; without, 0.4 > 0.36
  EXPECT_EQ(listed(run_rule("GC306", bricks(2, 1.5, "", "AUTOMATIC_GENERAL"))), 0U);
}

TEST(SolidEarlyRelease, NotSegmentBasedAndNotBetweenTwoSurfaces) {
  RuleDeck deck;
  deck.solid_part(1).shell_part(2, 3).block(1, 1, 1, 1, 1, Vector(0, 0, 0), Vector(2, 2, 2));
  deck.plate(101, 2, 1, 1, Vector(0, 0, 50), 20, 20);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", "0.\n1.,1.\n2,0.1\n");
  deck.contact(2, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3");
  EXPECT_EQ(listed(run_rule("GC306", deck)), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::solid_early_release_test
