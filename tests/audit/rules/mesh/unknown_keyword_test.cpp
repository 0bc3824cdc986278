#include "audit/rules/rule_deck.hpp"

namespace gapcheck::audit_test::unknown_keyword_test {
namespace {

RuleDeck plate() {
  RuleDeck deck;
  deck.shell_part(1, 1).plate(1, 1, 2, 2, Vector(0, 0, 0), 5, 5);
  return deck;
}

Report with(const std::string& keyword, int times = 1) {
  RuleDeck deck = plate();
  for (int i = 0; i < times; ++i) deck.raw(keyword, "1,2\n");
  return run_rule("GC516", deck);
}

Finding only(const std::string& keyword, int times = 1) {
  const Report report = with(keyword, times);
  EXPECT_EQ(report.findings.size(), 1U) << keyword;
  return report.findings.empty() ? Finding() : report.findings[0];
}

TEST(UnknownKeyword, AnErrorWhereContactsMeshSetsOrIncludesAreLost) {
  for (const auto& [written, meant] :
       {std::pair{"CONTCT_AUTOMATIC_SURFACE_TO_SURFACE", "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE"},
        std::pair{"CONTCT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_MPP_ID",
                  "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_MPP_ID"},
        std::pair{"CONTCT_AUTOMATC_SINGLE_SURFACE", "CONTACT_AUTOMATIC_SINGLE_SURFACE"},
        std::pair{"ELEMNT_SHELL", "ELEMENT_SHELL"}, std::pair{"INCLUD", "INCLUDE"},
        std::pair{"SET_PRT_LIST", "SET_PART_LIST"}, std::pair{"SET_PRT_LIST_TITLE", "SET_PART_LIST_TITLE"},
        std::pair{"CONTROL_CONTCT", "CONTROL_CONTACT"}, std::pair{"PAT", "PART"},
        std::pair{"PART_CONTCT", "PART_CONTACT"}, std::pair{"MAT_ELASTC", "MAT_ELASTIC"},
        std::pair{"SETPART_LIST", "SET_PART_LIST"}, std::pair{"SHELL_ELEMENT", "ELEMENT_SHELL"}}) {
    const Finding found = only(written);
    EXPECT_EQ(found.severity, Severity::error) << written;
    EXPECT_NE(found.message.find(fmt::format("did you mean *{}?", meant)), std::string::npos) << found.message;
    EXPECT_EQ(found.message.find(fmt::format("*{} is not a known ", written)), 0U) << found.message;
  }
  EXPECT_EQ(only("ELEMENT_FOO").severity, Severity::error);
}

TEST(UnknownKeyword, AWarningForWhatTheAuditDoesNotNeed) {
  const Finding misspelt = only("LOAD_BDY_Z");
  EXPECT_EQ(misspelt.severity, Severity::warning);
  EXPECT_NE(misspelt.message.find("did you mean *LOAD_BODY_Z?"), std::string::npos) << misspelt.message;
  const Finding strange = only("WHATEVER_THIS_IS");
  EXPECT_EQ(strange.severity, Severity::warning);
  EXPECT_NE(strange.message.find("correct the name"), std::string::npos) << strange.message;
  const Finding newer = only("ELEMENT_SHELL_QWERTZ");
  EXPECT_EQ(newer.severity, Severity::warning);
  EXPECT_NE(newer.message.find("is not a known form of *ELEMENT_SHELL, so"), std::string::npos) << newer.message;
}

/// Findings of a keyword that may be read, so that its data may be errors.
std::size_t found_anyway(const std::string& keyword) {
  audit::AuditOptions options;
  options.select = {"GC516"};
  return run_text(plate().raw(keyword, "1,2\n").text(), options).report.findings.size();
}

TEST(UnknownKeyword, NothingOfKnownOnes) {
  for (const char* known :
       {"COMMENT", "MAT_024_TITLE", "MAT_ADD_EROSION", "MAT_T01", "SECTION_SHELL_TITLE", "DEFINE_CURVE_TITLE",
        "ICFD_CONTROL_ANYTHING", "EM_MAT_001", "CESE_CONTROL_SOLVER", "USER_LOADING", "FREQUENCY_DOMAIN_FRF",
        "CONTROL_MPP_IO_NODUMP", "ELEMENT_SHELL_OFFSET_COMPOSITE", "SET_NODE_LIST_GENERATE_TITLE",
        "INITIAL_STRESS_SHELL", "DATABASE_GLSTAT"})
    EXPECT_EQ(found_anyway(known), 0U) << known;
  // The rule unknown-contact says it.
  EXPECT_EQ(found_anyway("CONTACT_AUTOMATIC_SINGEL_SURFACE"), 0U);
}

TEST(UnknownKeyword, OnceForEachNameWithItsNumberAndFirstPlace) {
  const Finding found = only("LOAD_BDY_Z", 3);
  EXPECT_NE(found.message.find("(the deck has it 3 times)"), std::string::npos) << found.message;
  const std::string text = plate().text();
  EXPECT_EQ(found.line, std::count(text.begin(), text.end(), '\n'));
  EXPECT_EQ(only("LOAD_BDY_Z").message.find("times"), std::string::npos);
}

TEST(UnknownKeyword, ManyNamesAndEndlessOnes) {
  const Finding endless = only(std::string(9000, 'A'));
  EXPECT_LT(endless.message.size(), 300U);
  RuleDeck deck = plate();
  for (int i = 0; i < 3000; ++i) deck.raw(fmt::format("STRANGE{}_NAME", i));
  const Report report = run_rule("GC516", deck);
  ASSERT_EQ(report.findings.size(), 11U);
  EXPECT_EQ(report.findings[10].count, 2990U);
}

}  // namespace
}  // namespace gapcheck::audit_test::unknown_keyword_test
