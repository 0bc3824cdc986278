#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::fine_reference_test {
namespace {

/// Part 1 with edges of 4 as side A, part 2 with edges of `size` as side B.
Report reference_with(double size, const std::string& keyword, const std::string& card1 = "1,2,3,3") {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 3, 3, Vector(0, 0, 0), 4, 4);
  deck.plate(101, 2, 4, 4, Vector(0, 0, 9), size, size);
  deck.raw("SET_NODE_LIST", "5\n1,2,3,5,6,7\n").contact(8, keyword, card1);
  return run_rule("GC417", deck);
}

TEST(FineReference, ReferenceSideMustNotBeFiner) {
  const Report report = reference_with(2, "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE");
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].contact, 8);
  EXPECT_NE(report.findings[0].message.find("2 times finer than the tracked side A (mean edges 2 and 4)"),
            std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(reference_with(2.66, "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE")), 1U) << "1.504 times";
  EXPECT_EQ(listed(reference_with(2.68, "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE")), 0U) << "1.493 times";
  EXPECT_EQ(listed(reference_with(8, "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE")), 0U);
}

TEST(FineReference, OneWayPenaltyTypesOnly) {
  EXPECT_EQ(listed(reference_with(2, "NODES_TO_SURFACE", "5,2,4,3")), 1U);
  EXPECT_EQ(listed(reference_with(3, "NODES_TO_SURFACE", "5,2,4,3")), 0U);
  EXPECT_EQ(listed(reference_with(2, "AUTOMATIC_SURFACE_TO_SURFACE")), 0U);
  EXPECT_EQ(listed(reference_with(2, "FORMING_ONE_WAY_SURFACE_TO_SURFACE")), 0U);
  EXPECT_EQ(listed(reference_with(2, "TIED_SURFACE_TO_SURFACE")), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::fine_reference_test
