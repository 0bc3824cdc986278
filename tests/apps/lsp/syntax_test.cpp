#include "lsp/syntax.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "keyword/deck.hpp"
#include "model/model.hpp"

namespace gapcheck::app::lsp {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::string told(const std::vector<LineFault>& faults) {
  std::ostringstream text;
  for (const LineFault& fault : faults)
    text << fault.line + 1 << ":" << fault.begin << "-" << fault.end << " " << fault.message << "\n";
  return text.str();
}

std::string check(const std::string& text) { return told(SyntaxCheck().check(Text(text))); }

TEST(LspSyntax, FieldsThatAreNoNumbers) {
  EXPECT_EQ(check("*NODE\n       1             0.0             0.0             0.0\n$ c\n       2             0.x\n"),
            "4:21-24 *NODE, field x: \"0.x\" is not a number; correct the field\n");
  EXPECT_EQ(
      check("*SET_PART_LIST\n1\n1.5,2,3\n"),
      "3:0-3 *SET_PART_LIST, field parts: \"1.5\" is not a whole number of at most 18 digits; correct the field\n");
  EXPECT_EQ(check("*PART\nany text\n         1         1       abc\n"),
            "3:27-30 *PART, field mid: \"abc\" is not a whole number of at most 18 digits; correct the field\n");
  EXPECT_EQ(check("*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n         1title\n0\n 0.1      0.1x\n\n"),
            "4:10-14 *CONTACT_AUTOMATIC_SINGLE_SURFACE_ID, field fd: \"0.1x\" is not a number; correct the field\n");
  // Parameters may be anywhere, text is text, and behind *END nothing is read.
  EXPECT_EQ(check("*NODE\n1,&x,<a+b>,0\n*PART\nabc\n1,2,3\n*END\n*NODE\nx\n"), "");
}

TEST(LspSyntax, NamesOfKeywords) {
  EXPECT_EQ(check("*ELEMNT_SHELL\nx\n").substr(0, 34), "1:0-13 *ELEMNT_SHELL is not a know");
  EXPECT_EQ(check("*\n"), "1:0-1 a keyword line without a name; give the keyword or remove it\n");
}

TEST(LspSyntax, Formats) {
  EXPECT_EQ(check("*NODE %\n         1             0.0             0.0             0.0\n"), "");
  EXPECT_EQ(check("*KEYWORD LONG=Y\n*NODE\n                   1                 0.0                 0.y\n"),
            "3:57-60 *NODE, field y: \"0.y\" is not a number; correct the field\n");
}

/// What the check calls an error in the project's decks, the reader calls an error too, in the same line.
TEST(LspSyntax, AgreesWithTheReader) {
  std::size_t decks = 0;
  for (const fs::path folder : {"data", "tests/apps/fixtures"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(GAPCHECK_ROOT) / folder)) {
      if (entry.path().extension() != ".k" || entry.file_size() > 1'000'000) continue;
      ++decks;
      const auto faults = SyntaxCheck().check(Text(content(entry.path())));
      if (faults.empty()) continue;
      Diagnostics diagnostics;
      const auto deck = keyword::read_deck(entry.path().string(), {}, diagnostics);
      if (!deck) continue;
      const auto model = model::read_model(deck.value(), diagnostics);
      for (const LineFault& fault : faults)
        EXPECT_TRUE(fault.message.find("not a known keyword") != std::string::npos ||
                    diagnostics.has_error_in(entry.path().string(), fault.line + 1, fault.line + 1))
            << entry.path() << ": " << told({fault});
    }
  EXPECT_GT(decks, 50U);
}

TEST(LspSyntax, OnlyChangedPiecesAreLookedAt) {
  std::string bytes = "*NODE\n";
  for (int i = 1; i < 20'000; ++i) bytes += "       1             0.0             0.0             0.0\n";
  Text text(bytes);
  SyntaxCheck check;
  EXPECT_TRUE(check.check(text).empty());
  EXPECT_EQ(check.looked_at(), text.pieces().size());
  text = text.edited({10'000, 20}, {10'000, 21}, "x");
  EXPECT_EQ(check.check(text).size(), 1U);
  EXPECT_EQ(check.looked_at(), 1U);
  // A line more moves all that follow, but changes none of them.
  text = text.edited({5, 0}, {5, 0}, "$\n");
  const auto faults = check.check(text);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].line, 10'001U);
  EXPECT_EQ(check.looked_at(), 1U);
}

TEST(LspSyntax, StepByStepAsAtOnce) {
  std::mt19937 random(7);
  const auto below = [&random](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  std::string bytes;
  for (int i = 0; i < 9000; ++i) {
    if (i % 1500 == 0) bytes += i % 3000 == 0 ? "*PART\n" : "*SET_PART_LIST\n";
    bytes += i % 100 == 0 ? "a plate\n" : "         1         1         1\n";
  }
  Text text(bytes);
  SyntaxCheck step;
  const std::vector<std::string> typed{"",  "x",     "\n", "*NODE\n$\n*PART\n", "*PART_CONTACT\n", "*KEYWORD LONG=Y\n",
                                       "$", "*END\n"};
  for (int i = 0; i < 60; ++i) {
    const Place begin{below(text.lines()), below(30)};
    Place end = begin;
    if (below(2) == 0) end.line += below(3);
    text = text.edited(begin, end, typed[below(i < 50 ? typed.size() - 1 : typed.size())]);
    ASSERT_EQ(told(step.check(text)), told(SyntaxCheck().check(Text(text.bytes())))) << i;
  }
}

}  // namespace
}  // namespace gapcheck::app::lsp
