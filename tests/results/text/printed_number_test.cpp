#include "results/text/printed_number.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace gapcheck::results::printed_number_test {
namespace {

std::vector<std::string> tokens(std::string_view text) {
  std::vector<std::string> result;
  for (auto token = take_token(text); !token.empty(); token = take_token(text)) result.emplace_back(token);
  return result;
}

using Tokens = std::vector<std::string>;

TEST(PrintedNumber, TokensApart) {
  EXPECT_EQ(tokens(" 22124 22164\t-1.0E+00"), (Tokens{"22124", "22164", "-1.0E+00"}));
  EXPECT_EQ(tokens("-1.0E+00-2.0E+00"), (Tokens{"-1.0E+00", "-2.0E+00"}));
  EXPECT_EQ(tokens("1.0E+002.0E+00"), (Tokens{"1.0E+00", "2.0E+00"}));
  EXPECT_EQ(tokens("0.00000E+00-1.50000E+00 0.00000E+00"), (Tokens{"0.00000E+00", "-1.50000E+00", "0.00000E+00"}));
  EXPECT_EQ(tokens("1.5-0.5"), (Tokens{"1.5", "-0.5"}));
  EXPECT_EQ(tokens("1.5000-345"), (Tokens{"1.5000-345"}));
  EXPECT_EQ(tokens("1.5000-345-2.0"), (Tokens{"1.5000-345", "-2.0"}));
  EXPECT_EQ(tokens("********"), (Tokens{"********"}));
  EXPECT_EQ(tokens("12abc 7"), (Tokens{"12abc", "7"}));
  EXPECT_EQ(tokens("+ - . E+1"), (Tokens{"+", "-", ".", "E+1"}));
  EXPECT_TRUE(tokens("  \t ").empty());
}

TEST(PrintedNumber, Values) {
  std::string_view text = "1.5000-300 -4.5005E+31 ******** 7";
  EXPECT_EQ(take_real(text), 1.5e-300);
  EXPECT_EQ(take_real(text), -4.5005e31);
  EXPECT_EQ(take_real(text), std::nullopt);
  EXPECT_EQ(take_integer(text), 7);
  EXPECT_EQ(take_integer(text), std::nullopt);
}

TEST(PrintedNumber, FieldsOfAFormatThatTouch) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-9e3, 9e3);
  for (int round = 0; round < 5000; ++round) {
    std::string line;
    std::vector<double> numbers;
    for (int i = 0; i < 6; ++i) {
      const std::string text = fmt::format("{: .4E}", value(random));
      numbers.push_back(std::stod(text));
      line += i > 0 && text.front() == ' ' && random() % 2 == 0 ? text.substr(1) : text;
    }
    std::string_view rest = line;
    for (const double number : numbers) ASSERT_EQ(take_real(rest), number) << line;
    ASSERT_TRUE(rest.empty()) << line;
  }
}

}  // namespace
}  // namespace gapcheck::results::printed_number_test
