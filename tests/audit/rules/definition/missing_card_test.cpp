#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::missing_card_test {
namespace {

RuleDeck plate() {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  return deck;
}

/// The messages for one contact with these lines.
std::vector<std::string> messages(const std::string& keyword, const std::string& lines) {
  std::vector<std::string> list;
  for (const Finding& f : run_rule("GC401", plate().raw("CONTACT_" + keyword, lines)).findings)
    list.push_back(f.message);
  return list;
}

void expect_missing(const std::string& keyword, const std::string& lines, const std::string& card) {
  const auto list = messages(keyword, lines);
  ASSERT_EQ(list.size(), 1U) << keyword;
  EXPECT_NE(list[0].find("ends before " + card), std::string::npos) << list[0];
}

TEST(MissingCard, Cards1To3) {
  expect_missing("AUTOMATIC_SINGLE_SURFACE", "0,0,5,0\n", "card 2");
  expect_missing("AUTOMATIC_SINGLE_SURFACE", "0,0,5,0\n0.\n", "card 3");
  expect_missing("AUTOMATIC_SINGLE_SURFACE_MPP_ID", "1,name\n1\n0,0,5,0\n0.\n", "card 3");
  EXPECT_TRUE(messages("AUTOMATIC_SINGLE_SURFACE", "0,0,5,0\n\n\n").empty());
  EXPECT_TRUE(messages("FORCE_TRANSDUCER_PENALTY", "1,0,3,0\n").empty());
}

TEST(MissingCard, WithoutCard1TheInputIsInError) {
  audit::AuditOptions options;
  options.select = {"GC401"};
  const AuditRun run = run_text(plate().raw("CONTACT_AUTOMATIC_SINGLE_SURFACE").text(), options);
  EXPECT_EQ(run.errors(), 1U);
  EXPECT_TRUE(run.report.findings.empty());
  ASSERT_EQ(run.report.contacts.size(), 1U);
  EXPECT_NE(run.report.contacts[0].not_checked, "");
}

TEST(MissingCard, Card4OfTheType) {
  const std::string three = "1,1,3,3\n0.\n1.,1.\n";
  const struct {
    const char *keyword, *card, *line;
  } cases[] = {
      {"ERODING_SINGLE_SURFACE", "card 4 (ISYM, EROSOP, IADJ)", "1,1,1\n"},
      {"SURFACE_TO_SURFACE_INTERFERENCE", "card 4 (LCID1, LCID2)", "3,4\n"},
      {"CONSTRAINT_SURFACE_TO_SURFACE", "card 4 (KPF)", "0.5\n"},
      {"RIGID_BODY_TWO_WAY_TO_RIGID_BODY", "card 4 (LCID, FCM", "7,1,0.5\n"},
      {"TIEBREAK_NODES_TO_SURFACE", "card 4 (NFLF", "1.5,2.5\n"},
      {"TIEBREAK_SURFACE_TO_SURFACE", "card 4 (NFLS", "1.5,2.5\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", "card 4 (OPTION", "6,1.5,2.5\n"},
      {"AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK_MORTAR", "card 4 (OPTION", "6,1.5,2.5\n"},
      {"AUTOMATIC_SINGLE_SURFACE_TIED", "card 4 (CLOSE)", "0.1\n"},
      {"DRAWBEAD", "card 4 (LCIDRF", "7,8\n"},
  };
  for (const auto& test : cases) {
    expect_missing(test.keyword, three, test.card);
    EXPECT_TRUE(messages(test.keyword, three + test.line).empty()) << test.keyword;
  }
  expect_missing("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", three + "13,1.,1.\n1.\n", "the cards of the cohesive law");
  EXPECT_TRUE(messages("AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK", three + "13,1.,1.\n1.\n2.\n").empty());
}

TEST(MissingCard, ALineThatCannotBeCard4) {
  const std::string three = "0,0,5,0\n0.\n1.,1.\n";
  const Report report = run_rule("GC401", plate().raw("CONTACT_ERODING_SINGLE_SURFACE", three + "2,0.1\n"));
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_NE(report.findings[0].message.find("cannot be that card"), std::string::npos);
  EXPECT_EQ(messages("ERODING_SINGLE_SURFACE", three + "2,0,0,1.025\n").size(), 1U);
  EXPECT_TRUE(messages("ERODING_SINGLE_SURFACE", three + "2,0,0,0.0,0\n").empty());
  EXPECT_TRUE(messages("ERODING_SINGLE_SURFACE", three + "1,1,1\n2,0.1\n").empty());
}

}  // namespace
}  // namespace gapcheck::audit_test::missing_card_test
