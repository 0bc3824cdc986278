#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::moved_into_another_test {
namespace {

/// Three plates at heights 0, `low` and `high`, 1 thick; the middle one is part 2, smaller, and alone is tracked.
RuleDeck sandwich(double low, double high, const std::string& more = "") {
  RuleDeck deck;
  for (int part = 1; part <= 3; ++part) deck.shell_part(part, 1);
  deck.plate(1, 1, 3, 3, Vector(0, 0, 0), 4, 4);
  deck.plate(101, 2, 1, 1, Vector(4.5, 4.5, low), 4, 4);
  deck.plate(201, 3, 3, 3, Vector(0, 0, high), 4, 4);
  deck.raw("SET_PART_LIST", "1\n1,3\n");
  return deck.contact(7, "AUTOMATIC_NODES_TO_SURFACE", "2,1,3,2", "0.\n1.,1.\n0\n" + more);
}

// A node in the middle is 0.3494 inside the upper plate, its closest one, and is moved down by 0.350099, to 0.349901
// above the lower plate: 0.650099 inside.
TEST(MovedIntoAnother, ASandwichWithoutRoom) {
  const Report report = run_rule("GC112", sandwich(0.7, 1.3506));
  ASSERT_GE(report.findings.size(), 4U);
  const Finding& f = report.findings[0];
  EXPECT_EQ(f.severity, Severity::error);
  EXPECT_EQ(f.contact, 7);
  bool middle = false;
  for (const Finding& one : report.findings) {
    if (one.part != 2) continue;
    middle = true;
    EXPECT_EQ(one.element_part, 1);
    EXPECT_NEAR(one.penetration, 0.3 + 1.002 * 0.3494, 1e-9) << one.message;
    EXPECT_NE(one.message.find("moved by 0.350099 out of element"), std::string::npos) << one.message;
    EXPECT_NE(one.message.find("(part 3), lands 0.650099 inside the contact distance 1 of element"), std::string::npos)
        << one.message;
  }
  EXPECT_TRUE(middle);
}

TEST(MovedIntoAnother, NotWithRoomOrWithoutMoves) {
  EXPECT_EQ(listed(run_rule("GC112", sandwich(0.7, 3))), 0U);
  EXPECT_EQ(listed(run_rule("GC112", sandwich(0.7, 1.3506, "0.,0,0,1\n"))), 0U);       // SNLOG = 1
  EXPECT_EQ(listed(run_rule("GC112", sandwich(0.7, 1.3506, "0.,0,0,0\n1,1\n"))), 0U);  // IGNORE = 1
}

}  // namespace
}  // namespace gapcheck::audit_test::moved_into_another_test
