#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::tie_negative_mst_test {
namespace {

Report tied_with(const std::string& thickness, const std::string& keyword = "TIED_SURFACE_TO_SURFACE",
                 const std::string& more = "") {
  RuleDeck deck;
  deck.shell_part(1, 1).shell_part(2, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 2, 2, Vector(0, 0, 1), 5, 5);
  return run_rule("GC210", deck.contact(7, keyword, "1,2,3,3", "0.\n1.,1.," + thickness + "\n" + more));
}

TEST(TieNegativeMst, OnlyMstIsNegative) {
  const Report report = tied_with("0.,-4.");
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].contact, 7);
  EXPECT_EQ(report.findings[0].severity, Severity::warning);
  EXPECT_NE(report.findings[0].message.find("MST = -4 is negative and SST = 0 is not"), std::string::npos)
      << report.findings[0].message;
  EXPECT_EQ(listed(tied_with("0.5,-4.")), 1U);
  EXPECT_EQ(listed(tied_with("-4.,0.")), 0U);
  EXPECT_EQ(listed(tied_with("-4.,0.5")), 0U);
  EXPECT_EQ(listed(tied_with("0.,4.")), 0U);
  EXPECT_EQ(listed(tied_with("0.,0.")), 0U);
}

TEST(TieNegativeMst, BothNegative) {
  const std::string beam_offset = "TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET";
  EXPECT_EQ(listed(tied_with("-0.001,-4.", beam_offset)), 1U);
  EXPECT_EQ(listed(tied_with("-4.,-0.001", beam_offset)), 0U);
  EXPECT_EQ(listed(tied_with("-4.,-4.", beam_offset)), 0U);
  EXPECT_EQ(listed(tied_with("-0.001,-4.", "TIED_SHELL_EDGE_TO_SURFACE_OFFSET")), 0U);
}

TEST(TieNegativeMst, TiesOnly) {
  EXPECT_EQ(listed(tied_with("0.,-4.", "TIED_SHELL_EDGE_TO_SURFACE")), 1U);
  EXPECT_EQ(listed(tied_with("0.,-4.", "TIEBREAK_SURFACE_TO_SURFACE", "1.,1.\n")), 1U);
  EXPECT_EQ(listed(tied_with("0.,-4.", "AUTOMATIC_SURFACE_TO_SURFACE")), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::tie_negative_mst_test
