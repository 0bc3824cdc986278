#include "report/compare/sae_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace gapcheck::report::sae_filter_test {
namespace {

/// A wave of `hertz` over 0.2 s in `rate` states a second; the unit of time is `unit` seconds.
Curve wave(double hertz, double rate = 50'000, double unit = 1) {
  Curve curve{"rcforc", "force", "c", 6, {}, {}, 0};
  for (int i = 0; i <= static_cast<int>(0.2 * rate); ++i) {
    const double seconds = i / rate;
    curve.add(seconds / unit, std::sin(2 * std::numbers::pi * hertz * seconds));
  }
  return curve;
}

Curve after(const Curve& curve, int channel_class, double unit = 1) {
  auto result = filtered(curve, {channel_class, unit});
  EXPECT_TRUE(result);
  return result ? std::move(result).value() : Curve{};
}

/// Largest value in the middle half.
double amplitude(const Curve& curve) {
  double largest = 0;
  for (std::size_t i = curve.values.size() / 4; i < 3 * curve.values.size() / 4; ++i)
    largest = std::max(largest, std::abs(curve.values[i]));
  return largest;
}

// The corridor of J211-1, figure 1: below the class 0 dB to -0.5 dB; at 5/3 of it -3 dB within +0.5, -1 dB; at 10/3 of
// it at most -10 dB, and falling by 24 dB an octave.
TEST(SaeFilter, PassesWhatItsClassSays) {
  for (const int channel_class : {60, 180, 600, 1000}) {
    const auto decibel = [&](double hertz) {
      return 20 * std::log10(amplitude(after(wave(hertz, 500'000), channel_class)));
    };
    const double number = channel_class;
    EXPECT_NEAR(decibel(number / 6), 0, 0.02) << channel_class;
    EXPECT_GT(decibel(number), -1) << channel_class;
    EXPECT_NEAR(decibel(number * 5 / 3), -3, 0.5) << channel_class;
    EXPECT_LT(decibel(number * 10 / 3), -10) << channel_class;
    EXPECT_NEAR(decibel(number * 12) - decibel(number * 6), -24, 1) << channel_class;
  }
}

TEST(SaeFilter, ShiftsNothing) {
  const Curve slow = wave(30), result = after(slow, 180);
  ASSERT_EQ(result.values.size(), slow.values.size());
  for (std::size_t i = slow.values.size() / 4; i < 3 * slow.values.size() / 4; ++i)
    ASSERT_NEAR(result.values[i], slow.values[i], 2e-3) << i;
}

TEST(SaeFilter, KeepsConstantsAndLines) {
  Curve line{"glstat", "energy", "c", 6, {}, {}, 0};
  for (int i = 0; i <= 3000; ++i) line.add(i * 1e-5, 4 - 70e-5 * i);
  for (const double value : {0.0, 1.0}) {
    Curve curve = line;
    for (double& each : curve.values) each = value * each + 3;
    const Curve result = after(curve, 600);
    for (std::size_t i = 0; i < curve.values.size(); ++i) ASSERT_NEAR(result.values[i], curve.values[i], 2e-3);
  }
}

// In milliseconds the same curve; seconds taken for milliseconds would pass a thousand times as much.
TEST(SaeFilter, UnitsOfTime) {
  const Curve in_seconds = after(wave(900), 60), in_milliseconds = after(wave(900, 50'000, 1e-3), 60, 1e-3);
  EXPECT_LT(amplitude(in_seconds), 0.01);
  ASSERT_EQ(in_seconds.values.size(), in_milliseconds.values.size());
  EXPECT_NEAR(in_milliseconds.times.back(), 200, 1e-9);
  for (std::size_t i = 0; i < in_seconds.values.size(); ++i)
    ASSERT_NEAR(in_seconds.values[i], in_milliseconds.values[i], 1e-9);
}

TEST(SaeFilter, FewStatesAreSampledMoreOften) {
  Curve ramp{"glstat", "energy", "c", 6, {}, {}, 0};
  for (const double t : {0.0, 0.1, 0.2}) ramp.add(t, t);
  const Curve result = after(ramp, 180);
  EXPECT_GE(result.times.size(), 0.2 * 180 * 20);
  EXPECT_EQ(result.times.front(), 0);
  EXPECT_EQ(result.times.back(), 0.2);
}

TEST(SaeFilter, WhatCannotBeFiltered) {
  Curve long_one{"glstat", "energy", "c", 6, {}, {}, 0};
  EXPECT_TRUE(after(long_one, 60).times.empty());
  long_one.add(0, 1);
  EXPECT_EQ(after(long_one, 60).values.size(), 1u);
  long_one.add(120, 1);
  const auto wrong_unit = filtered(long_one, {1000, 1});
  ASSERT_FALSE(wrong_unit);
  EXPECT_NE(wrong_unit.error().message.find("check the unit of time"), std::string::npos);
  EXPECT_TRUE(filtered(long_one, {1000, 1e-3}));
  long_one.add(1e300, 1);
  EXPECT_FALSE(filtered(long_one, {60, 1}));
}

TEST(SaeFilter, Words) {
  EXPECT_EQ(channel_class("60"), 60);
  EXPECT_EQ(channel_class("CFC180"), 180);
  EXPECT_EQ(channel_class("cfc 1000"), 1000);
  for (const char* text : {"", "CFC", "CFC70", "180Hz", "-60", "60 ", "c60"}) EXPECT_EQ(channel_class(text), 0) << text;
  EXPECT_EQ(seconds_in("ms"), 1e-3);
  EXPECT_EQ(seconds_in("min"), 0);
}

}  // namespace
}  // namespace gapcheck::report::sae_filter_test
