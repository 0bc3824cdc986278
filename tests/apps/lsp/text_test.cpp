#include "lsp/text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace gapcheck::app::lsp {
namespace {

/// The offset of a place in a text, the slow way.
std::size_t offset_of(const std::string& text, Place place) {
  std::size_t at = 0;
  for (; place.line > 0; --place.line) {
    const std::size_t newline = text.find('\n', at);
    if (newline == std::string::npos) return text.size();
    at = newline + 1;
  }
  std::size_t end = std::min(text.find('\n', at), text.size());
  while (end > at && text[end - 1] == '\r') --end;
  return std::min(at + place.byte, end);
}

TEST(LspText, Lines) {
  const Text text("*NODE\r\n       1\n\nlast");
  EXPECT_EQ(text.lines(), 4U);
  EXPECT_EQ(text.line(0), "*NODE");
  EXPECT_EQ(text.line(1), "       1");
  EXPECT_EQ(text.line(2), "");
  EXPECT_EQ(text.line(3), "last");
  EXPECT_EQ(text.line(4), "");
  EXPECT_EQ(Text().lines(), 1U);
  EXPECT_EQ(Text("a\n").lines(), 2U);
}

TEST(LspText, LineEnds) {
  EXPECT_EQ(Text("a\r\nb\nc").line_end(0), "\r\n");
  EXPECT_EQ(Text("a\r\nb\nc").line_end(1), "\n");
  EXPECT_EQ(Text("a\r\nb\nc").line_end(2), "\n");
  EXPECT_EQ(Text("a\r\n").line_end(1), "\r\n");
  EXPECT_EQ(Text("a\r\n").line_end(99), "\r\n");
  EXPECT_EQ(Text("a").line_end(0), "\n");
  EXPECT_EQ(Text().line_end(0), "\n");
}

TEST(LspText, AnEditSharesWhatItDoesNotTouch) {
  std::string bytes;
  for (int i = 0; i < 20'000; ++i) bytes += "$ a line of a text that has several pieces\n";
  const Text text(bytes);
  ASSERT_GT(text.pieces().size(), 5U);
  const Text edited = text.edited({7, 2}, {7, 3}, "the");
  EXPECT_EQ(edited.line(7), "$ the line of a text that has several pieces");
  EXPECT_EQ(text.line(7), "$ a line of a text that has several pieces");
  std::size_t shared = 0;
  for (const auto& piece : edited.pieces())
    shared += static_cast<std::size_t>(std::count(text.pieces().begin(), text.pieces().end(), piece));
  EXPECT_EQ(shared + 1, edited.pieces().size());
}

TEST(LspText, EditsAreThoseOfAString) {
  std::mt19937 random(5);
  const auto below = [&random](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
  std::string bytes;
  while (bytes.size() < 300'000) bytes += std::string(below(80), "*$ 1"[below(4)]) + "\n";
  Text text(bytes);
  const std::vector<std::string> typed{"", "x", "\n", "*NODE\n 1\n", "$\r\n", std::string(100'000, 'y') + "\n"};
  for (int i = 0; i < 300; ++i) {
    Place begin{below(text.lines() + 2), below(90)}, end = begin;
    if (below(2) == 0) end.byte += below(20);
    if (below(10) == 0) end.line += below(3000);
    const std::string& replacement = typed[below(below(20) == 0 ? typed.size() : typed.size() - 1)];
    const std::size_t from = offset_of(bytes, begin), to = std::max(from, offset_of(bytes, end));
    bytes.replace(from, to - from, replacement);
    text = text.edited(begin, end, replacement);
    ASSERT_EQ(text.bytes(), bytes) << i;
    ASSERT_EQ(text.lines(), static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), '\n')) + 1);
    ASSERT_EQ(text.size(), bytes.size());
    for (std::size_t p = 0; p + 1 < text.pieces().size(); ++p) ASSERT_EQ(text.pieces()[p]->bytes.back(), '\n');
    const std::uint32_t line = below(text.lines());
    ASSERT_EQ(text.line(line), bytes.substr(offset_of(bytes, {line, 0}),
                                            offset_of(bytes, {line, 1'000'000}) - offset_of(bytes, {line, 0})));
  }
}

TEST(LspText, WhatAPieceKnows) {
  const Piece piece("1\n*NODE\n$ c\n 2\n 3\n*END\n$\n4");
  ASSERT_EQ(piece.marks.size(), 2U);
  EXPECT_EQ(piece.marks[0].line, 1U);
  EXPECT_EQ(piece.marks[1].line, 5U);
  EXPECT_EQ(piece.rows, 1U);
  EXPECT_EQ(piece.newlines, 7U);
}

}  // namespace
}  // namespace gapcheck::app::lsp
