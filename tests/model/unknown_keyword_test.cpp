#include "model/unknown_keyword.hpp"

#include "read.hpp"

namespace gapcheck::model::unknown_keyword_test {
namespace {

TEST(UnknownKeyword, TheModelListsThemByTheirFirstPlace) {
  const Read read = read_text("*KEYWORD\n*ELEMNT_SHELL\n1,1\n*NODE\n1\n*ELEMNT_SHELL\n2,1\n*MAT_ELASTC\n1,1.,1.,.3\n");
  const auto& unknown = read.model.unknown_keywords;
  ASSERT_EQ(unknown.size(), 2U);
  EXPECT_EQ(unknown[0].name, "ELEMNT_SHELL");
  EXPECT_EQ(unknown[0].place.line, 2U);
  EXPECT_EQ(unknown[0].count, 2U);
  EXPECT_FALSE(unknown[0].read);
  EXPECT_EQ(describe(unknown[0], nearest_keyword(unknown[0])),
            "*ELEMNT_SHELL is not a known keyword (the deck has it 2 times), so what it defines is not read; did you "
            "mean *ELEMENT_SHELL?");
  // Density and the like of any material are read.
  EXPECT_TRUE(unknown[1].read);
  EXPECT_EQ(describe(unknown[1], ""), "*MAT_ELASTC is not a known keyword; correct the name");
}

TEST(UnknownKeyword, SaidOnce) {
  const Read read = read_text("*ELEMENT_SHELL_QWERTZ\n1,1\n*NODE_MERGE\n1,1\n");
  EXPECT_EQ(read.model.unknown_keywords.size(), 1U);
  EXPECT_EQ(read.text().find("QWERTZ"), std::string::npos) << read.text();
  EXPECT_NE(read.text().find("*NODE_MERGE is not read"), std::string::npos) << read.text();
}

TEST(UnknownKeyword, DiagnosticsForCommandsWithoutRules) {
  const Read read = read_text("*CONTCT_AUTOMATIC_SINGLE_SURFACE\n1\n*LOAD_BDY_Z\n1\n");
  Diagnostics diagnostics;
  report_unknown_keywords(read.model, diagnostics);
  const auto list = diagnostics.sorted();
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].severity, Severity::error);
  EXPECT_EQ(list[0].line, 1U);
  EXPECT_NE(list[0].message.find("did you mean *CONTACT_AUTOMATIC_SINGLE_SURFACE?"), std::string::npos);
  EXPECT_EQ(list[1].severity, Severity::warning);
}

}  // namespace
}  // namespace gapcheck::model::unknown_keyword_test
