#include "results/text/lines.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace gapcheck::results::lines_test {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> result;
  for (Lines lines(text); !lines.done(); lines.advance()) {
    result.emplace_back(lines.line());
    EXPECT_EQ(lines.number(), result.size());
  }
  return result;
}

/// The obvious twin, one character after the other.
std::vector<std::string> slow_lines(std::string text) {
  std::string ends;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 3, "\r\r\n") == 0)
      i += 2;
    else if (text.compare(i, 2, "\r\n") == 0)
      i += 1;
    ends += text[i] == '\r' ? '\n' : text[i];
  }
  std::vector<std::string> result;
  std::string line;
  for (const char c : ends) {
    if (c != '\n') {
      line += c;
      continue;
    }
    result.push_back(line);
    line.clear();
  }
  if (!line.empty()) result.push_back(line);
  for (std::string& one : result) {
    while (!one.empty() && one.front() == '\0') one.erase(0, 1);
    while (!one.empty() && one.back() == '\0') one.pop_back();
  }
  return result;
}

TEST(Lines, AllLineEnds) {
  EXPECT_EQ(lines_of("a\nb\r\nc\rd\r\r\ne"), (std::vector<std::string>{"a", "b", "c", "d", "e"}));
  EXPECT_EQ(lines_of("\n\n"), (std::vector<std::string>{"", ""}));
  EXPECT_EQ(lines_of("a\r"), (std::vector<std::string>{"a"}));
  EXPECT_TRUE(lines_of("").empty());
}

TEST(Lines, SameAsOneCharacterAfterTheOther) {
  std::mt19937 random(7);
  constexpr std::string_view alphabet("ab\n\r\n\r\0", 7);
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (auto size = random() % 24; size > 0; --size) text += alphabet[random() % alphabet.size()];
    ASSERT_EQ(lines_of(text), slow_lines(text)) << round;
  }
}

TEST(Lines, OpenLastLine) {
  Lines lines("a\nb");
  EXPECT_FALSE(lines.open());
  lines.advance();
  EXPECT_TRUE(lines.open());
  EXPECT_FALSE(Lines("a\n").open());
}

TEST(Lines, LongLinesAreCutAndCounted) {
  const std::string text = "a\n" + std::string(10'000'000, 'x') + "\nb\n" + std::string(Lines::longest, 'y') + "\n";
  Lines lines(text);
  std::vector<std::size_t> sizes;
  for (; !lines.done(); lines.advance()) sizes.push_back(lines.line().size());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, Lines::longest, 1, Lines::longest}));
  EXPECT_EQ(lines.cut_lines(), 1u);
  EXPECT_EQ(lines.first_cut(), 2u);
}

TEST(Lines, NulBytesAreFoundWhereTheyAre) {
  const std::string text("a\nb\0c\nd\0\n", 9);
  Lines lines(text);
  EXPECT_EQ(lines.first_nul(), 0u);
  lines.advance();
  EXPECT_EQ(lines.first_nul(), 2u);
  EXPECT_EQ(lines.line(), std::string_view("b\0c", 3));
  lines.advance();
  EXPECT_EQ(lines.line(), "d");
}

TEST(Lines, ManyCarriageReturnsAreLinear) {
  const std::string text = std::string(4'000'000, '\r') + "x\n";
  std::size_t count = 0;
  for (Lines lines(text); !lines.done(); lines.advance()) ++count;
  EXPECT_EQ(count, 4'000'001u);
}

}  // namespace
}  // namespace gapcheck::results::lines_test
