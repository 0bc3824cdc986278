#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::null_surface_test {
namespace {

/// Part 1 of steel, part 2 of shells with *MAT_NULL, its E given.
Report null_shells(const std::string& young, int soft = 0, const std::string& card1 = "1,2,3,3") {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1, 7).raw("MAT_NULL", "7,1.0e-9,0,0,0,0," + young + ",0.3\n");
  deck.plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 2, 2, 2, Vector(0, 0, 9), 5, 5);
  deck.contact(3, card1.ends_with("5") ? "AUTOMATIC_SINGLE_SURFACE" : "AUTOMATIC_SURFACE_TO_SURFACE", card1,
               fmt::format("0.\n1.,1.\n{}\n", soft));
  return run_rule("GC418", deck);
}

TEST(NullSurface, WholeSidesWithoutStiffnessOnly) {
  const Report report = null_shells("0.");
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].contact, 3);
  EXPECT_EQ(report.findings[0].part, 2);
  EXPECT_NE(report.findings[0].message.find("side B has no stiffness: all its 4 segments"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(null_shells("100.")), 0U);
  EXPECT_EQ(listed(null_shells("0.", 1)), 0U);
  EXPECT_EQ(listed(null_shells("0.", 0, "0,0,5")), 0U);  // part 1 is in the surface, too
}

TEST(NullSurface, SolidsHaveAnEquationOfState) {
  RuleDeck deck;
  deck.shell_part(1, 1).solid_part(2, 7).raw("MAT_NULL", "7,1.0e-9\n");
  deck.plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).block(101, 2, 1, 1, 1, Vector(0, 0, 9), Vector(5, 5, 5));
  EXPECT_EQ(listed(run_rule("GC418", deck.contact(3, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3"))), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::null_surface_test
