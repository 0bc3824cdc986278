#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test {
namespace {

TEST(UnknownReference, APartThatIsNotThere) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3,0");
  EXPECT_EQ(listed(run_rule("GC502", deck)), 0U);
  deck.contact(2, "AUTOMATIC_SINGLE_SURFACE", "9,0,3,0");
  EXPECT_EQ(listed(run_rule("GC502", deck)), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test
