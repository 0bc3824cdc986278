#include <algorithm>

#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::thickness_too_thin_test {
namespace {

// Six elements of 5 x 6. Materials 3 and 4, which is rigid, tell no unit.
RuleDeck plate(double thickness, int material = 3) {
  RuleDeck deck;
  return deck.raw("MAT_ELASTIC", "3,1.,1.,0.3")
      .raw("MAT_RIGID", "4,1.,1.,0.3")
      .shell_part(1, thickness, material)
      .plate(1, 1, 3, 2, Vector(0, 0, 0), 5, 6)
      .contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
}

audit::AuditOptions in_units(double millimetre) {
  audit::AuditOptions options;
  options.millimetre = millimetre;
  return options;
}

TEST(ThicknessTooThin, BelowHalfAMillimetreWithUnits) {
  const Report report = run_rule("GC303", plate(0.49), in_units(1));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].count, 6U);
  EXPECT_EQ(report.findings[0].part, 1);
  EXPECT_NE(report.findings[0].message.find("0.49 (element thickness)"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC303", plate(0.5), in_units(1))), 0U);
  EXPECT_EQ(listed(run_rule("GC303", plate(0.0004), in_units(0.001))), 1U);
  EXPECT_EQ(listed(run_rule("GC303", plate(0.0006), in_units(0.001))), 0U);
}

TEST(ThicknessTooThin, BelowAShareOfTheEdgeWithoutUnits) {
  EXPECT_EQ(listed(run_rule("GC303", plate(0.0149))), 1U);
  EXPECT_EQ(listed(run_rule("GC303", plate(0.0151))), 0U);
  EXPECT_EQ(listed(run_rule("GC303", plate(0.0149, 4))), 0U);  // rigid elements set no time step
  EXPECT_EQ(listed(run_rule("GC303", plate(0.0149, 4), in_units(1))), 1U);
}

TEST(ThicknessTooThin, TheUnitOfTheDeck) {
  // Material 1 is steel in mm, t and s.
  const Report report = run_rule("GC303", plate(0.49, 1));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find(
                "below 0.5 (0.5 mm, taking the unit of length for mm, because material 1 looks like steel)"),
            std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(run_rule("GC303", plate(0.5, 1))), 0U);
  // What the user says goes first: 0.49 is 490 mm then, and 0.49 m more than 0.003 of any edge.
  EXPECT_EQ(listed(run_rule("GC303", plate(0.49, 1), in_units(0.001))), 0U);
  EXPECT_EQ(run_rule("GC303", plate(0.49, 1), in_units(1)).findings.at(0).message.find("taking"), std::string::npos);
  EXPECT_EQ(listed(run_rule("GC303", plate(0.00049).raw("CONTROL_UNITS", "m,s,kg"))), 1U);
  EXPECT_EQ(listed(run_rule("GC303", plate(0.00051).raw("CONTROL_UNITS", "m,s,kg"))), 0U);
}

TEST(ThicknessTooThin, TheContactThicknessCounts) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 3, 2, Vector(0, 0, 0), 5, 6);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", "0.\n1.,1.,0.1,0.1\n");
  const Report report = run_rule("GC303", deck, in_units(1));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("0.1 (SST/MST)"), std::string::npos) << report.findings[0].message;
}

TEST(ThicknessTooThin, NotInTiesAndNotWhereThicknessIsIgnored) {
  RuleDeck deck;
  deck.shell_part(1, 0.1).shell_part(2, 0.1).plate(1, 1, 3, 2, Vector(0, 0, 0), 5, 6);
  deck.plate(101, 2, 3, 2, Vector(0, 0, 3), 5, 6);
  deck.contact(1, "TIED_SURFACE_TO_SURFACE", "1,2,3,3").contact(2, "SURFACE_TO_SURFACE", "1,2,3,3");
  const Report report = run_rule("GC303", deck, in_units(1));
  EXPECT_EQ(listed(report), 0U);
  EXPECT_EQ(std::count_if(report.statistics.begin(), report.statistics.end(),
                          [](const auto& s) { return s.second.find("GC303: 1 tied") == 0; }),
            1);
  deck.contact(3, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3");
  EXPECT_EQ(listed(run_rule("GC303", deck, in_units(1))), 2U);
}

}  // namespace
}  // namespace gapcheck::audit_test::thickness_too_thin_test
