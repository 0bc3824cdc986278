#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::stray_segment_test {
namespace {

Report segment(const std::string& nodes) {
  RuleDeck deck;
  deck.shell_part(1, 1)
      .solid_part(2)
      .plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5)
      .block(101, 2, 1, 1, 1, {0, 0, 9}, {5, 5, 5});
  deck.raw("SET_SEGMENT", "4\n1,2,5,4\n" + nodes + "\n");
  return run_rule("GC509", deck.contact(3, "AUTOMATIC_SURFACE_TO_SURFACE", "2,4,3,0"));
}

TEST(StraySegment, NoElementHasTheseCorners) {
  const Report report = segment("1,3,9,7");
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].contact, 3);
  EXPECT_EQ(report.findings[0].node, 1);
  EXPECT_NE(report.findings[0].message.find("segment 1 3 9 7 is not a face"), std::string::npos)
      << report.findings[0].message;
}

TEST(StraySegment, NotFacesOfShellsAndSolids) {
  EXPECT_EQ(listed(segment("4,5,2,1")), 0U);          // the shell again, turned round
  EXPECT_EQ(listed(segment("101,102,104,103")), 0U);  // the block's lower face
}

}  // namespace
}  // namespace gapcheck::audit_test::stray_segment_test
