#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::unknown_reference_test {
namespace {

TEST(UnknownReference, APartThatIsNotThere) {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5).contact(1, "AUTOMATIC_SINGLE_SURFACE", "1,0,3,0");
  EXPECT_EQ(listed(run_rule("GC502", deck)), 0U);
  deck.contact(2, "AUTOMATIC_SINGLE_SURFACE", "9,0,3,0");
  const Report report = run_rule("GC502", deck);
  ASSERT_EQ(listed(report), 1U);
  EXPECT_EQ(report.findings[0].line, line_of(deck, "9,0,3,0") - 2) << "its keyword";
  EXPECT_EQ(report.findings[0].severity, Severity::error);
  EXPECT_NE(report.findings[0].message.find("part 9"), std::string::npos) << report.findings[0].message;
}

TEST(UnknownReference, BothSidesOfAllKindsOfContactAndTheirBoxes) {
  for (const char* keyword : {"AUTOMATIC_SURFACE_TO_SURFACE", "TIED_SURFACE_TO_SURFACE", "FORCE_TRANSDUCER_PENALTY",
                              "SINGLE_EDGE", "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR"})
    for (const int type : {0, 1, 2, 3, 4, 6}) {
      const auto found = [&](const std::string& card1) {
        RuleDeck deck;
        deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
        return listed(run_rule("GC502", deck.contact(1, keyword, card1)));
      };
      EXPECT_EQ(found(fmt::format("9,1,{},3", type)), 1U) << keyword << type;
      EXPECT_EQ(found(fmt::format("1,9,3,{}", type)), 1U) << keyword << type;
      EXPECT_EQ(found("1,1,3,3"), 0U) << keyword;
      EXPECT_EQ(found("1,1,3,3,7,8"), 2U) << keyword;
    }
}

}  // namespace
}  // namespace gapcheck::audit_test::unknown_reference_test
