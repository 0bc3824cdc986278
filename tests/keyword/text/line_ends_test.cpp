#include "keyword/text/line_ends.hpp"

#include <algorithm>

#include "keyword/rows.hpp"
#include "support.hpp"

namespace gapcheck::keyword::line_ends_test {
namespace {

constexpr auto nowhere = std::string_view::npos;

/// A deck with other line ends.
std::string with_ends(std::string text, const std::string& end) {
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + end.size()))
    text.replace(at, 1, end);
  return text;
}

const std::string deck_text =
    "*KEYWORD\n$ a comment\n*PART\ntitle\n         1         1         1\n*NODE\n       1             1.0\n"
    "       2             2.5\n*ELEMENT_MASS,\n*END\n";

std::string refusal(const std::string& text) {
  Diagnostics diagnostics;
  const auto deck = read_deck_text(text, "deck.k", {}, diagnostics);
  EXPECT_FALSE(deck.ok()) << text;
  return deck.ok() ? "" : deck.error().message;
}

TEST(LineEnds, CarriageReturnsAtTheEndOfALineDoNotCount) {
  for (const char* end : {"\n", "\r\n", "\r\r\n", "\r\r\r\n"}) {
    TextDeck deck(with_ends(deck_text, end));
    EXPECT_EQ(reports(deck.diagnostics), "");
    EXPECT_EQ(names(deck.deck), (std::vector<std::string>{"KEYWORD", "PART", "NODE", "ELEMENT_MASS,", "END"}));
    const CardReader part = deck.reader("PART");
    EXPECT_EQ(part.peek(), "title");
    const Rows rows = read_rows(deck.deck, deck.block("NODE"), card_layout("NODE", "card1"), deck.diagnostics);
    ASSERT_EQ(rows.count, 2U);
    EXPECT_EQ(rows.reals[0], 1.0);
    EXPECT_EQ(rows.reals[rows.real_columns], 2.5);
    EXPECT_EQ(reports(deck.diagnostics), "");
  }
}

TEST(LineEnds, DecksWithOtherLineEndsAreRefusedByName) {
  EXPECT_NE(refusal(with_ends(deck_text, "\r")).find("CR alone"), std::string::npos);
  EXPECT_NE(refusal(with_ends(deck_text, "\r")).find("tr '\\r' '\\n' < FILE > NEW"), std::string::npos);
  EXPECT_NE(refusal(with_ends(deck_text, "\r") + "\n").find("CR alone"), std::string::npos);
  EXPECT_NE(refusal(with_ends(deck_text, "\u0085")).find("U+0085"), std::string::npos);
  EXPECT_NE(refusal(with_ends(deck_text, "\u2028")).find("U+2028"), std::string::npos);
  EXPECT_NE(refusal(with_ends(deck_text, "\u2029")).find("U+2029; the solver needs LF or CR LF"), std::string::npos);
}

TEST(LineEnds, SoAreIncludes) {
  const TemporaryDirectory directory;
  directory.write("mesh.k", "*NODE\r1,1.,2.,3.\r2,1.,2.,3.\r");
  Diagnostics diagnostics;
  const auto deck = read_deck(directory.write("main.k", "*KEYWORD\n*INCLUDE\nmesh.k\n*END\n"), {}, diagnostics);
  ASSERT_TRUE(deck.ok());
  EXPECT_EQ(count_errors(diagnostics), 1U);
  EXPECT_NE(reports(diagnostics).find("mesh.k\" has lines that end with CR alone"), std::string::npos)
      << reports(diagnostics);
}

TEST(LineEnds, AStrayBreakInAKeywordOrCommentIsAnErrorOnce) {
  for (const char* lost : {"$ comment\r*NODE", "*NODE\r1,1.", "*NODE\u20281,1.", "$ text\u2028*NODE", "$ \u0085$"}) {
    const std::string rest = "*NODE\n1,1.,2.,3.\n$ b\r*NODE\n*END\n*PART\ra\n";
    TextDeck deck("*KEYWORD\n" + std::string(lost) + "\n" + rest);
    EXPECT_EQ(count_errors(deck.diagnostics), 1U) << lost;
    EXPECT_NE(reports(deck.diagnostics).find("deck.k:2: holds a line break that is neither LF nor CR LF"),
              std::string::npos)
        << reports(deck.diagnostics);
    EXPECT_NE(reports(deck.diagnostics).find("the first of 2 such lines"), std::string::npos) << "not after *END";
    for (const Block& block : deck.deck.blocks()) EXPECT_EQ(block.name.find_first_of("\r\xE2"), nowhere) << block.name;
  }
}

TEST(LineEnds, PartOfTheTextOfAComment) {
  TextDeck deck("*KEYWORD\n$ one\u2028two\u0085 three\n*NODE\n1,1.,2.,3.\n*END\n");
  EXPECT_EQ(reports(deck.diagnostics), "");
  EXPECT_EQ(foreign_break("$ one\u2028two"), nowhere);
  EXPECT_EQ(foreign_break("$ one\u2028*NODE"), 5U);
  EXPECT_EQ(foreign_break("$ one\r*NODE\r\r"), 5U);
  EXPECT_EQ(foreign_break("$ one\r\r"), nowhere);
  EXPECT_EQ(foreign_break(""), nowhere);
}

TEST(LineEnds, OfTheBeginningOfAFile) {
  EXPECT_EQ(foreign_line_ends(""), "");
  EXPECT_EQ(foreign_line_ends("*KEYWORD"), "");
  EXPECT_EQ(foreign_line_ends("a\nb\rc\n"), "");
  EXPECT_EQ(foreign_line_ends("a\r\nb\r\r\n"), "");
  EXPECT_EQ(foreign_line_ends("a\rb\rc\n"), "CR alone");
}

}  // namespace
}  // namespace gapcheck::keyword::line_ends_test
