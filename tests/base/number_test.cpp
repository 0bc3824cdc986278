#include "base/number.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <random>
#include <regex>
#include <string>

namespace gapcheck::number_test {
namespace {

/// The slow twin of parse_real: a grammar, and strtod for the value.
std::optional<double> slow_real(const std::string& text) {
  static const std::regex grammar(
      R"([ \t]*([+-]?)([0-9]+\.?[0-9]*|\.[0-9]+)(?:[eEdD]([+-]?[0-9]+)|([+-][0-9]+))?[ \t\r]*)");
  std::smatch match;
  if (!std::regex_match(text, match, grammar)) return std::nullopt;
  const std::string exponent = match[3].matched ? match[3].str() : match[4].matched ? match[4].str() : "0";
  const double value = std::strtod((match[1].str() + match[2].str() + "e" + exponent).c_str(), nullptr);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string random_text(std::mt19937& random, std::string_view alphabet, std::size_t longest) {
  std::string text(random() % (longest + 1), ' ');
  for (char& c : text) c = alphabet[random() % alphabet.size()];
  return text;
}

TEST(Trimmed, TakesBlanksOffBothEnds) {
  EXPECT_EQ(trimmed(" \t a b \t\r"), "a b");
  EXPECT_EQ(trimmed(" \t "), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(ParseReal, FormsThatDecksUse) {
  EXPECT_EQ(parse_real("1.5-3"), 1.5e-3);
  EXPECT_EQ(parse_real("  -1.0D+2 "), -100.0);
  EXPECT_EQ(parse_real("2.5d0"), 2.5);
  EXPECT_EQ(parse_real(".5"), 0.5);
  EXPECT_EQ(parse_real("5."), 5.0);
  EXPECT_EQ(parse_real("+7"), 7.0);
  EXPECT_EQ(parse_real("1e-400"), 0.0);
  EXPECT_EQ(parse_real("1.0E+20"), 1e20);
}

TEST(ParseReal, WhatIsNoNumber) {
  for (const char* text :
       {"",    "   ", "nan",   "inf", "-inf", "infinity", "0x10", "1e400", "1+400", "abc", "1.0a", "1 2", "--1",
        "+-1", "-+1", "1.2.3", "e5",  ".",    "+",        "-",    "1e",    "1e+",   "1-",  "1d",   "&p"})
    EXPECT_FALSE(parse_real(text).has_value()) << text;
}

TEST(ParseReal, AgreesWithTheGrammarOnRandomText) {
  std::mt19937 random(1);
  std::size_t numbers = 0;
  for (int i = 0; i < 200'000; ++i) {
    const std::string text = random_text(random, "00123456789..++--eEdD  nx", 9);
    const auto expected = slow_real(text);
    const auto found = parse_real(text);
    ASSERT_EQ(found.has_value(), expected.has_value()) << "'" << text << "'";
    if (expected) {
      ASSERT_EQ(*found, *expected) << "'" << text << "'";
    }
    numbers += expected.has_value();
  }
  EXPECT_GT(numbers, 10'000u);
}

TEST(ParseReal, RoundsCorrectlyAndBack) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100'000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    ASSERT_EQ(parse_real({text, static_cast<std::size_t>(end - text)}), value);
  }
}

TEST(ParseReal, LongTextIsNoProblem) {
  EXPECT_EQ(parse_real("0." + std::string(1000, '0') + "1"), 0.0);
  EXPECT_EQ(parse_real(std::string(300, '1')), std::strtod(std::string(300, '1').c_str(), nullptr));
  EXPECT_FALSE(parse_real(std::string(10'000, '9')).has_value());
  EXPECT_EQ(parse_real("1" + std::string(100, '0') + "D-100"), 1.0);
}

TEST(ParseInteger, FormsThatDecksUse) {
  EXPECT_EQ(parse_integer("  12 "), 12);
  EXPECT_EQ(parse_integer("-3"), -3);
  EXPECT_EQ(parse_integer("+3"), 3);
  EXPECT_EQ(parse_integer("12.0"), 12);
  EXPECT_EQ(parse_integer("1.2E1"), 12);
  EXPECT_EQ(parse_integer("9223372036854775807"), 9223372036854775807LL);
  EXPECT_EQ(parse_integer("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(parse_integer("00000012"), 12);
}

TEST(ParseInteger, WhatIsNoWholeNumber) {
  for (const char* text :
       {"", " ", "1.5", "abc", "9223372036854775808", "1e30", "+-1", "++1", "1 2", "0x1", "nan", "-"})
    EXPECT_FALSE(parse_integer(text).has_value()) << text;
}

TEST(ParseInteger, AgreesWithStrtollOnRandomText) {
  static const std::regex grammar(R"([ \t]*[+-]?[0-9]+[ \t\r]*)");
  std::mt19937 random(3);
  for (int i = 0; i < 100'000; ++i) {
    const std::string text = random_text(random, "0123456789+- ", 10);
    const bool whole = std::regex_match(text, grammar);
    const auto found = parse_integer(text);
    if (whole) {
      ASSERT_EQ(found, std::strtoll(text.c_str(), nullptr, 10)) << "'" << text << "'";
    } else {
      // Fortran's 12+3 is 12000.
      const auto real = slow_real(text);
      const bool integral = real && *real == std::floor(*real) && std::abs(*real) <= 9e15;
      ASSERT_EQ(found.has_value(), integral) << "'" << text << "'";
    }
  }
}

}  // namespace
}  // namespace gapcheck::number_test
