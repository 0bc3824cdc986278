#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::same_surface_test {
namespace {

Report with_sides(const std::string& keyword, const std::string& card1) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 2, 2, Vector(0, 0, 9), 5, 5);
  deck.raw("SET_PART_LIST", "1\n1\n").raw("SET_PART_LIST", "2\n1,2\n").raw("SET_PART_LIST", "3\n2,1\n");
  deck.raw("SET_PART_LIST", "4\n2\n").raw("SET_SEGMENT", "1\n1,2,5,4\n").raw("SET_SEGMENT", "2\n1,2,5,4\n");
  deck.raw("SET_SEGMENT", "3\n2,3,6,5\n").raw("DEFINE_BOX", "7,-1.,6.,-1.,6.,-1.,1.\n");
  return run_rule("GC405", deck.contact(1, keyword, card1));
}

TEST(SameSurface, PartsAndSetsWithTheSameMembers) {
  for (const char* sides : {"1,1,3,3", "1,1,3,2", "2,3,2,2", "2,0,2,5", "4,1,6,3", "1,1,0,0", "1,2,0,0"}) {
    const Report report = with_sides("AUTOMATIC_SURFACE_TO_SURFACE", sides);
    ASSERT_EQ(report.findings.size(), 1U) << sides;
    EXPECT_EQ(report.findings[0].contact, 1);
  }
  for (const char* sides : {"1,2,3,3", "1,2,3,2", "1,2,2,2", "4,2,6,3", "1,3,0,0", "1,1,0,3", "1,1,3,3,7"})
    EXPECT_EQ(listed(with_sides("AUTOMATIC_SURFACE_TO_SURFACE", sides)), 0U) << sides;
}

TEST(SameSurface, TiesToo) {
  const Report report = with_sides("TIED_SURFACE_TO_SURFACE", "1,1,3,3");
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NE(report.findings[0].message.find("tied to itself"), std::string::npos);
  EXPECT_EQ(listed(with_sides("AUTOMATIC_SINGLE_SURFACE", "1,1,3,3")), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::same_surface_test
