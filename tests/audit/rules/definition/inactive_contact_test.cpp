#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::inactive_contact_test {
namespace {

std::size_t found(const std::string& birth_and_death, const std::string& end = "0.1",
                  const std::string& keyword = "AUTOMATIC_SINGLE_SURFACE") {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  if (!end.empty()) deck.raw("CONTROL_TERMINATION", end);
  return listed(run_rule("GC414", deck.contact(1, keyword, "1,0,3,0", ",,,,,," + birth_and_death + "\n1.,1.\n")));
}

TEST(InactiveContact, BirthAgainstDeathAndEnd) {
  EXPECT_EQ(found("0.,1e20"), 0U);
  EXPECT_EQ(found("0.01,0.02"), 0U);
  EXPECT_EQ(found("0.02,0.02"), 1U);
  EXPECT_EQ(found("0.02,0.01"), 1U);
  EXPECT_EQ(found("0.02,0.01", ""), 1U);
  EXPECT_EQ(found("0.1,1e20"), 1U);
  EXPECT_EQ(found("0.099,1e20"), 0U);
  EXPECT_EQ(found("5.,1e20", ""), 0U);
}

TEST(InactiveContact, ASlipInTheExponent) {
  EXPECT_EQ(found("0.,1e-20"), 1U);
  EXPECT_EQ(found("0.,1e-20", ""), 0U);
  EXPECT_EQ(found("0.,1e-6"), 0U);
}

TEST(InactiveContact, SignsHaveAMeaning) {
  EXPECT_EQ(found("-5.,0."), 0U);     // on in the whole transient phase
  EXPECT_EQ(found("-5.,-1e20"), 1U);  // follows BT there
  EXPECT_EQ(found("-0.05,-0.01"), 1U);
  EXPECT_EQ(found("17.,-9999."), 0U);  // a curve
  EXPECT_EQ(found("5.,1.", "0.1", "FORCE_TRANSDUCER_PENALTY"), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::inactive_contact_test
