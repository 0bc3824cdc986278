#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::part_friction_test {
namespace {

/// Parts 1 and 2, the second with *PART_CONTACT; a contact of part 1 or of both with FS = -1.
RuleDeck parts(const std::string& part_contact, const std::string& keyword, const std::string& card1) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.raw("SECTION_SHELL", "2,2\n1.\n").raw("PART_CONTACT", "two\n2,2,1\n" + part_contact + "\n");
  deck.plate(101, 2, 2, 2, Vector(0, 0, 9), 5, 5);
  return deck.contact(1, keyword, card1, "-1.\n1.,1.\n");
}

std::size_t found(const RuleDeck& deck) { return listed(run_rule("GC407", deck)); }

TEST(PartFriction, SomePartOfTheContactMustHaveIt) {
  EXPECT_EQ(found(parts("0.2", "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0")), 0U);
  EXPECT_EQ(found(parts(",,,,1.5", "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0")), 1U);  // OPTT alone
  EXPECT_EQ(found(parts("0.2", "AUTOMATIC_SINGLE_SURFACE", "1,0,3,0")), 1U);      // the other part has it
  EXPECT_EQ(found(parts("0.2", "AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3")), 0U);
  EXPECT_EQ(found(parts("0.2", "AUTOMATIC_SURFACE_TO_SURFACE", "2,1,3,3")), 0U);
}

TEST(PartFriction, OrTheDefaultsOfControlContact) {
  RuleDeck deck = parts("", "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0");
  EXPECT_EQ(found(deck), 1U);
  EXPECT_EQ(found(deck.raw("CONTROL_CONTACT", "\n\n0.1\n")), 0U);
}

TEST(PartFriction, OnlySomeTypesTakeIt) {
  const Report report = run_rule("GC407", parts("0.2", "SURFACE_TO_SURFACE", "1,2,3,3"));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NE(report.findings[0].message.find("not available"), std::string::npos);
  EXPECT_EQ(found(parts("0.2", "AIRBAG_SINGLE_SURFACE", "2,0,3,0")), 0U);
  EXPECT_EQ(found(parts("0.2", "TIED_SURFACE_TO_SURFACE", "1,2,3,3")), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::part_friction_test
