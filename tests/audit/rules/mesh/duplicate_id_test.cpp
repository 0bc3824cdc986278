#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::duplicate_id_test {
namespace {

TEST(DuplicateId, TwoContactsWithOneId) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  EXPECT_EQ(listed(run_rule("GC501", deck)), 0U);
  deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  EXPECT_EQ(listed(run_rule("GC501", deck)), 1U);
}

}  // namespace
}  // namespace gapcheck::audit_test::duplicate_id_test
