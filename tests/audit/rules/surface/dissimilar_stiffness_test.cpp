#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::dissimilar_stiffness_test {
namespace {

/// Part 1 of steel, part 2 of a material with this modulus and the same ratio.
Report two_parts(double young, const std::string& keyword, const std::string& card1, int soft, double sfm = 1,
                 const std::string& more = "") {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1, 7);
  deck.raw("MAT_ELASTIC", fmt::format("7,1.0e-9,{},0.3\n", young));
  deck.plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).plate(101, 2, 2, 2, Vector(0, 0, 9), 5, 5);
  deck.contact(3, keyword, card1, fmt::format("0.\n1.,{}\n{}\n", sfm, soft));
  deck.raw("CONTROL_CONTACT", more);
  return run_rule("GC410", deck);
}

TEST(DissimilarStiffness, NamesThePair) {
  const Report report = two_parts(2100, "AUTOMATIC_SINGLE_SURFACE", "0,0,5", 0);
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.contact, 3);
  EXPECT_EQ(f.part, 2);
  EXPECT_EQ(f.element_part, 1);
  EXPECT_NE(f.message.find("part 1 (K = 1.75e+05) is 100 times as stiff as part 2 (K = 1750)"), std::string::npos)
      << f.message;
}

// 0.002 K_stiff presses a spring of SLSFAC SF K_soft to half the thickness: 25, in proportion to SLSFAC and SF.
TEST(DissimilarStiffness, FromTheRatioOn) {
  const auto found = [](double ratio, double sfm, const std::string& slsfac) {
    return listed(two_parts(210000 / ratio, "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3", 0, sfm, slsfac));
  };
  EXPECT_EQ(found(25, 1, ""), 1U);
  EXPECT_EQ(found(24.9, 1, ""), 0U);
  EXPECT_EQ(found(50, 1, "0.2\n"), 1U);
  EXPECT_EQ(found(49.9, 1, "0.2\n"), 0U);
  EXPECT_EQ(found(12.5, 0.5, ""), 1U);
  EXPECT_EQ(found(12.4, 0.5, ""), 0U);
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
