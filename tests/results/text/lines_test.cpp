#include "results/text/lines.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "base/work_watch.hpp"

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

/// A file for one test.
std::string file_with(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + "gapcheck_lines_" + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

// Lines of all lengths, also longer than what is read at once.
TEST(Lines, OfAFileAreThoseOfItsText) {
  std::mt19937 random(11);
  std::string text;
  while (text.size() < 25'000'000) {
    const std::size_t length = random() % 50 == 0 ? random() % 6'000'000 : random() % 100'000;
    text.append(length, static_cast<char>('a' + random() % 26));
    text += std::array{"\n", "\r\n", "\r\r\n", "\r", "\n\n"}[random() % 5];
  }
  const std::string path = file_with("same", text);
  auto file = FileBytes::begin(path);
  ASSERT_TRUE(file.ok());
  Lines expected(text);
  for (Lines lines(file.value()); !lines.done(); lines.advance(), expected.advance()) {
    ASSERT_FALSE(expected.done());
    ASSERT_EQ(lines.line(), expected.line());
    ASSERT_EQ(lines.offset(), expected.offset());
    ASSERT_EQ(lines.number(), expected.number());
    ASSERT_EQ(lines.open(), expected.open());
  }
  EXPECT_TRUE(expected.done());
  std::filesystem::remove(path);
}

TEST(Lines, OfAFileThatBecomesShorterEndWhereItFails) {
  std::string text;
  while (text.size() < 20'000'000) text += "a line of the log\n";
  const std::string path = file_with("shorter", text);
  auto file = FileBytes::begin(path);
  ASSERT_TRUE(file.ok());
  Lines lines(file.value());
  std::filesystem::resize_file(path, 10'000'000);
  for (; !lines.done(); lines.advance()) ASSERT_TRUE(text.substr(0, 18).starts_with(lines.line()));
  EXPECT_FALSE(lines.status().ok());
  EXPECT_LE(lines.offset(), 10'000'000u);
  EXPECT_GT(lines.offset(), 1'000'000u);
  std::filesystem::remove(path);
}

TEST(Lines, EndWhereTheWorkIsStopped) {
  std::string text;
  for (int line = 0; line < 5000; ++line) text += "line\n";
  int asked = 0;
  const std::function<bool()> go_on = [&asked] { return ++asked < 3; };
  const WorkWatch watch(go_on);
  std::size_t read = 0;
  Lines lines(text);
  for (; !lines.done(); lines.advance()) ++read;
  EXPECT_GT(read, 1000u);
  EXPECT_LT(read, 4000u);
  EXPECT_EQ(asked, 3);
  lines.advance();
  EXPECT_TRUE(lines.done());
  EXPECT_TRUE(Lines(text).done()) << "nothing is begun any more";
}

}  // namespace
}  // namespace gapcheck::results::lines_test
