#include "keyword/text/fixed_field.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "base/number.hpp"
#include "slow_twins.hpp"

namespace gapcheck::keyword::fixed_field_test {
namespace {

/// A field between bytes that are no part of it.
struct Surrounded {
  std::string text;
  explicit Surrounded(const std::string& field, char around = '7')
      : text(std::string(reach, around) + field + std::string(reach, around)) {}
  [[nodiscard]] const char* at() const { return text.data() + reach; }
};

constexpr double untouched = 12345.678;

/// True if the fast way takes the field; then the value must be strtod's to the last bit, and one for parse_real().
bool agrees(const std::string& field, char around = '7') {
  double value = untouched;
  const bool taken = read_fixed_real(Surrounded(field, around).at(), field.size(), value);
  if (!taken) {
    EXPECT_EQ(value, untouched) << '"' << field << '"';
    return false;
  }
  EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(by_strtod(field))) << '"' << field << '"';
  if (!trimmed(field).empty()) {
    EXPECT_EQ(parse_real(field), value) << '"' << field << '"';
  }
  return true;
}

std::string placed(const std::string& number, std::size_t width, std::size_t blanks) {
  return std::string(blanks, ' ') + number + std::string(width - blanks - number.size(), ' ');
}

const std::vector<std::string> forms{
    "0",          "-0",      "0.",        ".0",       "-0.0",     "1",       "-1",      "+1",       "1.",
    "-1.",        ".5",      "-.5",       "+.5",      "1.5",      "12.75",   "-12.75",  "1e2",      "1E2",
    "1.e2",       ".5e2",    "1.5E+02",   "1.5e-02",  "1.5D+02",  "1.5d-02", "1.5D2",   "1.5-3",    "1.5+3",
    "-1.5-3",     ".5-3",    "5.+3",      "15-3",     "1.5E+003", "1.5E22",  "1.5E-21", "1.E-9",    "0.1",
    "0.3",        "-7.1E-5", "00012.50",  "1e0",      "1e00",     "9999999", "1234.5",  "-0.00001", "123456.",
    "0.00000123", "2.5E+10", "1.0000001", "-9.99E-3", "+1.5D+1"};

TEST(FixedField, RealsOfAllFormsAtAllPlaces) {
  for (const std::string& number : forms)
    for (std::size_t width = number.size(); width <= 31; ++width)
      for (std::size_t blanks = 0; blanks + number.size() <= width; ++blanks)
        for (const char around : {'7', ' ', '.', 'E', '-', '\n'})
          EXPECT_TRUE(agrees(placed(number, width, blanks), around))
              << number << " in " << width << " after " << blanks;
}

TEST(FixedField, WhatIsNoPlainRealIsLeftAlone) {
  for (const char* text : {"x",
                           "-",
                           "+",
                           ".",
                           "-.",
                           "e5",
                           "1e",
                           "1e+",
                           "1.5E+-3",
                           "--1",
                           "+-1",
                           "1 2",
                           "1. 5",
                           "1..5",
                           "1.5.",
                           "inf",
                           "nan",
                           "-inf",
                           "0x10",
                           "&p",
                           "-&p",
                           "<p>",
                           "1,2",
                           "1\t",
                           "\t1",
                           "1\r",
                           "1\n",
                           "1e5.",
                           "1e.5",
                           "1f5",
                           "1e1000",
                           "1.5E+0001",
                           "1e400",
                           "1e-400",
                           "1e60",
                           "1e-60",
                           "$1",
                           "\xC3\xA9",
                           "12345678901234567",
                           ".12345678901234567",
                           "1234567890.1234567890"}) {
    EXPECT_FALSE(agrees(text)) << text;
    EXPECT_FALSE(agrees(std::string("  ") + text + " ")) << text;
  }
  double value = untouched;
  EXPECT_FALSE(read_fixed_real(Surrounded(std::string(32, '1')).at(), 32, value));
  EXPECT_FALSE(agrees(std::string("1\0", 2)));
}

TEST(FixedField, BlankIsZero) {
  for (std::size_t width = 1; width <= 31; ++width) {
    double real = untouched;
    ASSERT_TRUE(read_fixed_real(Surrounded(std::string(width, ' ')).at(), width, real));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(real), 0u);
    std::int64_t integer = 5;
    if (width < 8 || width > 24) continue;
    ASSERT_TRUE(read_fixed_integer(Surrounded(std::string(width, ' ')).at(), width, integer));
    EXPECT_EQ(integer, 0);
  }
}

TEST(FixedField, Integers) {
  std::mt19937 random(3);
  for (std::size_t width = 8; width <= 24; ++width)
    for (std::size_t digits = 1; digits <= 8; ++digits)
      for (int i = 0; i < 2000; ++i) {
        std::string number;
        for (std::size_t k = 0; k < digits; ++k) number += static_cast<char>('0' + random() % 10);
        std::int64_t value = -5;
        const std::string field = placed(number, width, width - digits);
        ASSERT_TRUE(read_fixed_integer(Surrounded(field, " 7\n"[random() % 3]).at(), width, value)) << field;
        ASSERT_EQ(value, std::stoll(number)) << field;
      }
}

/// Every byte at every place of a field: taken only where it leaves a number.
TEST(FixedField, IntegersWithAnyByte) {
  for (const std::size_t width : {8u, 10u, 20u})
    for (std::size_t place = 0; place < width; ++place)
      for (int byte = 0; byte < 256; ++byte) {
        std::string field = placed("1234", width, width - 4);
        field[place] = static_cast<char>(byte);
        const std::string number(trimmed(field));
        const bool plain = number.size() <= 8 && field.back() != ' ' &&
                           number.size() == field.size() - field.find(number) &&
                           field.find_first_not_of(' ') == field.find(number) &&
                           number.find_first_not_of("0123456789") == std::string::npos;
        std::int64_t value = -5;
        ASSERT_EQ(read_fixed_integer(Surrounded(field).at(), width, value), plain) << field << " byte " << byte;
        ASSERT_EQ(value, plain ? std::stoll(number) : -5) << field;
      }
}

TEST(FixedField, RealsWithAnyByte) {
  for (const char* text : {"   -1234.567E+02", "1.5", "  12.25-3   "})
    for (std::size_t place = 0; place < std::string(text).size(); ++place)
      for (int byte = 0; byte < 256; ++byte) {
        std::string field = text;
        field[place] = static_cast<char>(byte);
        double value = untouched;
        if (!read_fixed_real(Surrounded(field).at(), field.size(), value)) continue;
        const auto slow = parse_real(field);
        if (trimmed(field).empty()) continue;
        ASSERT_TRUE(slow.has_value()) << field << " byte " << byte;
        ASSERT_EQ(*slow, value) << field << " byte " << byte;
      }
}

/// Halfway between two doubles, and one unit of the last digit beside it: ties go to even, all else to the nearer one.
TEST(FixedField, TiesAndTheirNeighbours) {
  std::mt19937_64 random(4);
  int taken = 0;
  for (int i = 0; i < 20000; ++i) {
    // Odd numbers of 54 bits are halfway between two doubles; divided by a power of two their digits end.
    const std::uint64_t tie = (std::uint64_t{1} << 53) + 2 * (random() % (std::uint64_t{1} << 52)) + 1;
    for (const std::uint64_t number : {tie - 1, tie, tie + 1})
      for (const char* exponent : {"", "E+2", "E-2", "E+9", "E-19"}) {
        std::string text = std::to_string(number) + "00" + exponent;
        text.insert(random() % 8 + 3, ".");
        taken += agrees(text) ? 1 : 0;
      }
  }
  EXPECT_GT(taken, 100000);
}

TEST(FixedField, ScaledExactly) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 200000; ++i) {
    const std::uint64_t mantissa = random() >> random() % 64;
    for (const int exponent : {static_cast<int>(random() % 39) - 19, -19, 0, 19}) {
      const std::string text = std::to_string(mantissa) + "e" + std::to_string(exponent);
      double value = untouched;
      ASSERT_TRUE(scaled_exactly(mantissa, exponent, value));
      ASSERT_EQ(value, std::strtod(text.c_str(), nullptr)) << text;
    }
  }
  double value = untouched;
  EXPECT_FALSE(scaled_exactly(1, 20, value));
  EXPECT_FALSE(scaled_exactly(1, -20, value));
  EXPECT_TRUE(scaled_exactly(0, -5, value));
  EXPECT_EQ(std::bit_cast<std::uint64_t>(value), 0u);
}

/// One real as programs write it, or any digits at all.
std::string random_number(std::mt19937_64& random, std::size_t width) {
  char buffer[64];
  const double scale = std::pow(10.0, static_cast<int>(random() % 16) - 8);
  const double number = (static_cast<double>(random()) * 0x1p-63 - 1) * scale;
  const int digits = static_cast<int>(random() % (width - 4));
  const auto kind = random() % 4;
  if (kind == 0) std::snprintf(buffer, sizeof buffer, "%.*E", digits, number);
  if (kind == 1) std::snprintf(buffer, sizeof buffer, "%.*f", digits, number);
  if (kind == 2) std::snprintf(buffer, sizeof buffer, "%.*g", digits, number);
  if (kind < 3) return std::string(buffer).substr(0, width);
  std::string text(random() % 2, '-');
  const std::size_t length = 1 + random() % (width - 2), point = random() % (length + 1);
  for (std::size_t i = 0; i < length; ++i) {
    if (i == point) text += '.';
    text += static_cast<char>('0' + random() % 10);
  }
  if (random() % 2 == 0) text += "EeDd"[random() % 4];
  if (random() % 2 == 0) text += "+-"[random() % 2];
  if (random() % 2 == 0) text += std::to_string(random() % 30);
  return text.substr(0, width);
}

/// GAPCHECK_RANDOM_FIELDS sets how many are tried; a hundred million take some minutes.
TEST(FixedField, RandomRealsAreThoseOfStrtod) {
  const char* wanted = std::getenv("GAPCHECK_RANDOM_FIELDS");
  const std::uint64_t count = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 1000000;
  std::mt19937_64 random(6);
  std::uint64_t taken = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::size_t width = random() % 2 == 0 ? 16 : 20;
    const std::string number = random_number(random, width);
    taken += agrees(placed(number, width, random() % (width - number.size() + 1))) ? 1 : 0;
    if (::testing::Test::HasFailure()) FAIL() << "field " << i;
  }
  EXPECT_GT(taken, count / 10 * 7);
}

}  // namespace
}  // namespace gapcheck::keyword::fixed_field_test
