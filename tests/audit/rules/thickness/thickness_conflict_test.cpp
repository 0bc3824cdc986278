#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::thickness_conflict_test {
namespace {

// Two rows of elements of 10 x 10: part 1 below, part 2 above, with the nodes 4 to 6 in common.
RuleDeck joint(double lower, double upper) {
  RuleDeck deck;
  deck.shell_part(1, lower).shell_part(2, upper);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) deck.node(1 + 3 * j + i, Vector(10 * i, 10 * j, 0));
  deck.shell(1, 1, {1, 2, 5, 4}).shell(2, 1, {2, 3, 6, 5}).shell(3, 2, {4, 5, 8, 7}).shell(4, 2, {5, 6, 9, 8});
  return deck;
}

// A thin sheet on a thick plate is meant. A third sheet below the joint, 1 thick, makes it matter: nodes 4 to 6 count 3
// where part 1 has 0.5, so 1.5 + 0.5 against 0.25 + 0.5.
RuleDeck joint_over_sheet(double gap, double upper = 3) {
  RuleDeck deck = joint(0.5, upper);
  deck.shell_part(9, 1).plate(901, 9, 1, 1, Vector(-5, -5, -gap), 40, 40);
  return deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
}

TEST(ThicknessConflict, ThinElementsWithNodesOfAThickOneThatPenetrate) {
  const Report report = run_rule("GC307", joint_over_sheet(1.8));
  ASSERT_EQ(listed(report), 1U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.part, 1);
  EXPECT_EQ(f.element, 1);
  EXPECT_EQ(f.count, 2U);
  EXPECT_NE(f.message.find("shell 1 has 0.5 (element thickness), its node"), std::string::npos) << f.message;
  EXPECT_NE(f.message.find("counts 3 (element thickness), by which alone it penetrates (0.2 deep)"), std::string::npos)
      << f.message;
}

TEST(ThicknessConflict, TwoSheetsOfTheDrawingAreMeant) {
  EXPECT_EQ(listed(run_rule("GC307", joint(0.5, 3).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0"))), 0U);
  EXPECT_EQ(listed(run_rule("GC307", joint_over_sheet(2.1))), 0U) << "nothing penetrates";
  EXPECT_EQ(listed(run_rule("GC307", joint_over_sheet(0.7))), 0U) << "penetrates as thin as it is, too";
}

TEST(ThicknessConflict, OneThicknessForAllHasNone) {
  EXPECT_EQ(
      listed(run_rule("GC307", joint(0.5, 3).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0", "0.\n1.,1.,1.,1.\n"))),
      0U);
}

TEST(ThicknessConflict, OpttOnOneOfTwoPartsThatShareNodes) {
  RuleDeck deck = joint(1, 1);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  EXPECT_EQ(listed(run_rule("GC307", deck)), 0U);
  deck.raw("PART_CONTACT", "part 3\n3,3,1\n0.,0.,0.,0.,2.5\n").raw("SECTION_SHELL", "3,2,0.833,5\n1.\n");
  deck.node(20, Vector(0, 30, 0)).node(21, Vector(10, 30, 0)).shell(20, 3, {7, 8, 21, 20});
  const Report report = run_rule("GC307", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].part, 2);
  EXPECT_EQ(report.findings[0].count, 2U);  // elements 3 and 4 have node 8, element 3 also 7
  EXPECT_NE(report.findings[0].message.find("counts 2.5 (OPTT"), std::string::npos) << report.findings[0].message;
}

TEST(ThicknessConflict, SstAndMstOfOnePartOnBothSides) {
  const auto both = [](const char* card3) {
    return run_rule("GC307", joint(1, 1).contact(1, "AUTOMATIC_SURFACE_TO_SURFACE", "1,1,3,3",
                                                 fmt::format("0.\n1.,1.,{}\n", card3)));
  };
  EXPECT_EQ(listed(both("2.,2.")), 0U);
  EXPECT_EQ(listed(both("4.,1.")), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::thickness_conflict_test
