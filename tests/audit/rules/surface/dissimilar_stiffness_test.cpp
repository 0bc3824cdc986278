#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::dissimilar_stiffness_test {
namespace {

/// Part 1 of steel, part 2 of a material with this modulus and the same ratio.
Report two_parts(double young, const std::string& keyword, const std::string& card1, int soft,
                 const std::string& more = "") {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1, 7);
  deck.raw("MAT_ELASTIC", fmt::format("7,1.0e-9,{},0.3\n", young));
  deck.plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 2, 2, 2, Vector(0, 0, 9), 5, 5);
  deck.contact(3, keyword, card1, fmt::format("0.\n1.,1.\n{}\n", soft));
  if (!more.empty()) deck.raw("CONTACT_EXCLUDE_INTERACTION", more);
  return run_rule("GC410", deck);
}

TEST(DissimilarStiffness, FromAFactorOfAHundredOn) {
  const Report report = two_parts(2100, "AUTOMATIC_SINGLE_SURFACE", "0,0,5", 0);
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.contact, 3);
  EXPECT_EQ(f.part, 2);
  EXPECT_EQ(f.element_part, 1);
  EXPECT_NE(f.message.find("part 1 (K = 1.75e+05) is 100 times as stiff as part 2 (K = 1750)"), std::string::npos)
      << f.message;
  EXPECT_EQ(listed(two_parts(2200, "AUTOMATIC_SINGLE_SURFACE", "0,0,5", 0)), 0U);
}

TEST(DissimilarStiffness, AcrossTheSidesWithSoft0Only) {
  EXPECT_EQ(listed(two_parts(21, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", 0)), 1U);
  EXPECT_EQ(listed(two_parts(21, "AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3", 0)), 1U);
  EXPECT_EQ(listed(two_parts(21, "AUTOMATIC_SURFACE_TO_SURFACE", "1,1,3,3", 0)), 0U);
  EXPECT_EQ(listed(two_parts(21, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", 1)), 0U);
  EXPECT_EQ(listed(two_parts(21, "TIED_SURFACE_TO_SURFACE", "1,2,3,3", 0)), 0U);
  EXPECT_EQ(listed(two_parts(0, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", 0)), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::dissimilar_stiffness_test
