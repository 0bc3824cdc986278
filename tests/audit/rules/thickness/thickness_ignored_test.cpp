#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::thickness_ignored_test {
namespace {

RuleDeck plates(const std::string& type, int material = 1, const std::string& cards = "0.\n1.,1.\n") {
  RuleDeck deck;
  deck.shell_part(1, 1, material).shell_part(2, 2, material).plate(1, 1, 3, 2, Vector(0, 0, 0), 5, 5);
  deck.plate(101, 2, 1, 1, Vector(0, 0, 3), 5, 5);
  return deck.contact(6, type, "1,2,3,3", cards);
}

TEST(ThicknessIgnored, OldTypesWithoutShlthk) {
  for (const char* type : {"SURFACE_TO_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE", "NODES_TO_SURFACE", "SLIDING_ONLY"}) {
    const Report report = run_rule("GC305", plates(type));
    ASSERT_EQ(listed(report), 1U) << type;
    EXPECT_EQ(report.findings[0].contact, 6);
    EXPECT_EQ(report.findings[0].count, 7U);
    EXPECT_NE(report.findings[0].message.find("7 shells, up to 2 thick"), std::string::npos);
  }
  for (const char* type : {"AUTOMATIC_SURFACE_TO_SURFACE", "FORMING_SURFACE_TO_SURFACE", "TIED_SURFACE_TO_SURFACE"})
    EXPECT_EQ(listed(run_rule("GC305", plates(type))), 0U) << type;
}

TEST(ThicknessIgnored, NotWithShlthkOnCardBOrGlobally) {
  const std::string card_a = "0,0.1,0,0.,0,0,0,0\n";
  EXPECT_EQ(listed(run_rule("GC305", plates("SURFACE_TO_SURFACE", 1, "0.\n1.,1.\n" + card_a + "0.,1,1\n"))), 0U);
  const Report unread = run_rule("GC305", plates("SURFACE_TO_SURFACE", 1, "0.\n1.,1.\n" + card_a + "0.,0,1\n"));
  ASSERT_EQ(listed(unread), 1U);
  EXPECT_NE(unread.findings[0].message.find("SHLTHK of card B needs THKOPT = 1"), std::string::npos);
  RuleDeck global = plates("SURFACE_TO_SURFACE");
  global.raw("CONTROL_CONTACT", "0.1,0.0,0,0,1,0,1,0\n");
  EXPECT_EQ(listed(run_rule("GC305", global)), 1U);
  RuleDeck with = plates("SURFACE_TO_SURFACE");
  with.raw("CONTROL_CONTACT", "0.1,0.0,0,1,1,0,1,0\n");
  EXPECT_EQ(listed(run_rule("GC305", with)), 0U);
  RuleDeck off = plates("SURFACE_TO_SURFACE", 1, "0.\n1.,1.\n" + card_a + "0.,2,1\n");
  const Report report = run_rule("GC305", off.raw("CONTROL_CONTACT", "0.1,0.0,0,1,1,0,1,0\n"));
  ASSERT_EQ(listed(report), 1U);
  EXPECT_NE(report.findings[0].message.find("THKOPT = 2"), std::string::npos);
}

// *CONTROL_CONTACT is of no help where THKOPT is not 0.
TEST(ThicknessIgnored, AdviceThatHelps) {
  const auto message = [](int thkopt) {
    const std::string cards = fmt::format("0.\n1.,1.\n0,0.1,0,0.,0,0,0,0\n0.,{},0\n", thkopt);
    const Report report = run_rule("GC305", plates("SURFACE_TO_SURFACE", 1, cards));
    return report.findings.size() == 1 ? report.findings[0].message : std::string();
  };
  EXPECT_NE(message(0).find("card B or SHLTHK = 1 in *CONTROL_CONTACT, or use"), std::string::npos);
  EXPECT_NE(message(1).find("set SHLTHK = 1 on card B, or use"), std::string::npos);
  EXPECT_NE(message(2).find("set THKOPT and SHLTHK = 1 on card B, or use"), std::string::npos);
}

TEST(ThicknessIgnored, RigidToolsAndSolidsHaveNoneToIgnore) {
  EXPECT_EQ(listed(run_rule("GC305", plates("SURFACE_TO_SURFACE", 2))), 0U);
  RuleDeck deck;
  deck.solid_part(1).solid_part(2).block(1, 1, 1, 1, 1, Vector(0, 0, 0), Vector(1, 1, 1));
  deck.block(101, 2, 1, 1, 1, Vector(0, 0, 2), Vector(1, 1, 1)).contact(1, "SURFACE_TO_SURFACE", "1,2,3,3");
  EXPECT_EQ(listed(run_rule("GC305", deck)), 0U);
}

}  // namespace
}  // namespace gapcheck::audit_test::thickness_ignored_test
