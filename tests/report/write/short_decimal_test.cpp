// Short decimals are those of fmt, which is the slow twin, and whatever is not short is left to it.
#include "report/write/short_decimal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace gapcheck::report {
namespace {

/// The text, "" where it is left to fmt.
std::string short_text(double value, char* (*write)(double, char*) = write_short_decimal) {
  char text[short_decimal_room + 1];
  text[short_decimal_room] = '#';
  const char* end = write(value, text);
  EXPECT_EQ(text[short_decimal_room], '#');
  return end == nullptr ? "" : std::string(text, static_cast<std::size_t>(end - text));
}

TEST(ShortDecimal, NumbersOfDecksAreWrittenAsByFmt) {
  std::mt19937_64 random(7);
  for (int sample = 0; sample < 100000; ++sample) {
    const int places = static_cast<int>(random() % 9);
    const auto most = static_cast<std::uint64_t>(1e7 * std::pow(10., places)) >> (random() % 40);
    const double value = static_cast<double>(random() % (most + 1)) / std::pow(10., places) * (sample % 2 ? 1 : -1);
    const std::string text = short_text(value);
    if (value == 0 || (std::abs(value) >= 1e-4 && std::abs(value) < 1e7))
      ASSERT_EQ(text, fmt::format("{}", value));
    else
      ASSERT_EQ(text, "") << value;
  }
}

TEST(ShortDecimal, AnyOtherNumberIsLeftToFmt) {
  std::mt19937_64 random(8);
  int left = 0;
  for (int sample = 0; sample < 100000; ++sample) {
    // Any bits at all, and full mantissas of the usual size.
    double value = std::bit_cast<double>(random());
    if (sample % 2) value = std::ldexp(static_cast<double>(random() >> 11), -static_cast<int>(random() % 80));
    const std::string text = short_text(value);
    left += text.empty() ? 1 : 0;
    if (!text.empty()) {
      ASSERT_EQ(text, fmt::format("{}", value));
    }
  }
  EXPECT_GT(left, 75000);
}

TEST(ShortDecimal, Bounds) {
  EXPECT_EQ(short_text(0.), "0");
  EXPECT_EQ(short_text(-0.), "-0");
  EXPECT_EQ(short_text(1.), "1");
  EXPECT_EQ(short_text(-0.5), "-0.5");
  EXPECT_EQ(short_text(9999999.99999999), "9999999.99999999");
  EXPECT_EQ(short_text(-1234567.00000001), "-1234567.00000001");
  EXPECT_EQ(short_text(0.0001), "0.0001");
  for (const double value : {1e7, 9.9e-5, 5e-324, 0.1 + 0.2, 1. / 3, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(short_text(value), "") << value;
  // Numbers beside a short one.
  for (const double near : {0.3, 1.25, 1234.5678, 9999999.5})
    for (const double beyond : {0., 1e9}) EXPECT_EQ(short_text(std::nextafter(near, beyond)), "") << near;
}

TEST(ShortDecimal, SixDigitsAreThoseOfFmt) {
  std::mt19937_64 random(9);
  int left = 0, inside = 0;
  const auto expect_same = [&](double value) {
    const std::string text = short_text(value, write_six_digits);
    const bool in = std::abs(value) >= 1e-4 && std::abs(value) < 1e5;
    if (text.empty())
      left += in ? 1 : 0;
    else
      ASSERT_EQ(text, fmt::format("{:.6g}", value));
    inside += in ? 1 : 0;
  };
  for (int sample = 0; sample < 100000; ++sample) {
    expect_same(std::ldexp(static_cast<double>(random() >> 11), -36 - static_cast<int>(random() % 32)));
    expect_same(-static_cast<double>(random() % 1000000) / std::pow(10., 1 + random() % 9));
  }
  EXPECT_GT(inside, 130000);
  EXPECT_LT(left, 10);
  // Half between two texts, and beside it; where digits carry; bounds and what is not a number.
  for (double half : {1.000005, 0.1234565, 99999.95, 12345.65, 0.000123456500, 0.99999950, 9999.9951, 1.5})
    for (int step = 0; step < 5; ++step, half = std::nextafter(half, 0.)) expect_same(half);
  for (const double value :
       {0., -0., 1e5, 1e-5, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(short_text(value, write_six_digits), "") << value;
}

}  // namespace
}  // namespace gapcheck::report
