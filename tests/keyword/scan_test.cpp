#include "keyword/scan.hpp"

#include <random>
#include <regex>

#include "base/parallel.hpp"
#include "support.hpp"

namespace gapcheck::keyword::scan_test {
namespace {

/// The slow twin: one line after the other.
std::vector<Mark> marks_by_lines(const std::string& text) {
  std::vector<Mark> marks;
  std::uint32_t number = 0;
  for (std::size_t at = 0; at < text.size();) {
    ++number;
    const auto end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    if (line.starts_with("*")) marks.push_back({Mark::Kind::keyword, number, at});
    const auto last = line.find_last_not_of('\r');
    if (line.find_first_of("*$") == 0 && line.find('\r') < last && last != std::string::npos)
      marks.push_back({Mark::Kind::foreign_break, number, at});
    if (line.starts_with("-----BEGIN PGP MESSAGE-----")) marks.push_back({Mark::Kind::encrypted_begin, number, at});
    if (line.starts_with("-----END PGP MESSAGE-----")) marks.push_back({Mark::Kind::encrypted_end, number, at});
    static const std::regex directive("^\\$[ \t]*gapcheck:.*", std::regex::icase);
    if (line.starts_with("$") && std::regex_match(line.substr(0, 200), directive))
      marks.push_back({Mark::Kind::directive, number, at});
    at = end + 1;
  }
  return marks;
}

void expect_same(const std::string& text) {
  const auto fast = find_marks(text), slow = marks_by_lines(text);
  ASSERT_EQ(fast.size(), slow.size());
  for (std::size_t i = 0; i < fast.size(); ++i) {
    ASSERT_EQ(fast[i].kind, slow[i].kind) << i;
    ASSERT_EQ(fast[i].line, slow[i].line) << i;
    ASSERT_EQ(fast[i].offset, slow[i].offset) << i;
  }
}

TEST(Scan, SmallTexts) {
  for (const char* text :
       {"", "\n", "*", "*A", "*A\n", "\n*A", " *A\n*B\n\n*C", "-----BEGIN PGP MESSAGE-----\n-\n----",
        "$*\n*\n**\r\n-----END PGP MESSAGE-----", "$gapcheck:", "$\t GapCheck: x\n$gapcheck :\n $gapcheck:\n$ gapcheck",
        "$ \n$", "$ gapcheck\n: ignore\n$gapcheck:\n", "$\ra\n*A\r\r\n*B\rC\r\nD\rE\n"})
    expect_same(text);
}

TEST(Scan, BigTextsOverManyPieces) {
  std::mt19937 random(8);
  std::string text;
  while (text.size() < 9'000'000) {
    const auto kind = random() % 50;
    if (kind == 0) text += "*KEYWORD";
    if (kind == 1) text += "-----BEGIN PGP MESSAGE-----";
    if (kind == 2) text += "-----END PGP MESSAGE-----";
    if (kind == 3) text += "$ gapcheck: ";
    if (kind == 4) text += "$ ";
    text += std::string(random() % 200, "x*-"[random() % 3]) + "\n";
    if (random() % 2000 == 0) text += std::string(random() % 3'000'000, ' ');
  }
  expect_same(text);
}

TEST(Scan, TextOfADirective) {
  EXPECT_EQ(directive_text("$ gapcheck: ignore GC101"), " ignore GC101");
  EXPECT_EQ(directive_text("$GAPCHECK:"), "");
  for (const char* line :
       {"gapcheck: ignore", "$$ gapcheck: ignore", "$ a gapcheck: ignore", "$ gapcheck ignore", "$", ""})
    EXPECT_FALSE(directive_text(line)) << line;
}

}  // namespace
}  // namespace gapcheck::keyword::scan_test
