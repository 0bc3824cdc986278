#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test {
namespace {

TEST(EmptySurface, APartWithoutElements) {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3,0");
  EXPECT_EQ(listed(run_rule("GC503", deck)), 0U);
  deck.contact(2, "AUTOMATIC_SINGLE_SURFACE", "2,0,3,0");
  const Report report = run_rule("GC503", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].contact, 2);
}

}  // namespace
}  // namespace gapcheck::audit_test
