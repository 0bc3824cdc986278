#include "report/compare/rating.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace gapcheck::report::rating_test {
namespace {

using Values = std::vector<double>;

constexpr std::size_t count = 501;

Values sampled(double (*function)(double)) {
  Values values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(function(static_cast<double>(i) / (count - 1)));
  return values;
}

double pulse(double x) { return std::exp(-std::pow((x - 0.5) / 0.08, 2)); }

Values times(Values values, double factor, double offset = 0) {
  for (double& value : values) value = factor * value + offset;
  return values;
}

Values delayed(const Values& values, std::ptrdiff_t by) {
  Values result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i) - by;
    result.push_back(values[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 0, std::ptrdiff_t{count} - 1))]);
  }
  return result;
}

Rating rated(const Values& reference, const Values& curve) {
  const auto rating = rate(reference, curve);
  EXPECT_TRUE(rating);
  return rating.value_or(Rating{-1, -1, -1, -1});
}

TEST(Rating, TheSameCurve) {
  const Rating rating = rated(sampled(pulse), sampled(pulse));
  EXPECT_EQ(rating.overall(), 1);
  EXPECT_EQ(rating.slope, 1);
}

// A delay of n samples costs n / (0.2 N) of the phase and nothing else once it is undone.
TEST(Rating, DelaysBothWays) {
  for (const std::ptrdiff_t by : {-60, -25, -1, 1, 25, 60}) {
    const Rating rating = rated(sampled(pulse), delayed(sampled(pulse), by));
    EXPECT_NEAR(rating.phase, 1 - std::abs(static_cast<double>(by)) / (0.2 * count), 1e-12) << by;
    EXPECT_NEAR(rating.magnitude, 1, 1e-6) << by;
    EXPECT_NEAR(rating.slope, 1, 1e-6) << by;
    EXPECT_EQ(rating.corridor<1, std::abs(by)> 1) << by;
  }
  EXPECT_EQ(rated(sampled(pulse), delayed(sampled(pulse), 200)).phase,
            rated(sampled(pulse), delayed(sampled(pulse), 130)).phase)
      << "beyond a fifth of the samples nothing is left";
}

// A constant reference and a curve at a distance d: no warping helps, so all scores are closed forms.
TEST(Rating, AConstantOffset) {
  const Values one(count, 1.0);
  for (const double d : {0.02, 0.2, 0.3, 0.49, 0.6}) {
    const Rating rating = rated(one, times(one, 1, d));
    const double share = std::clamp((0.5 - d) / 0.45, 0.0, 1.0);
    EXPECT_NEAR(rating.corridor, share * share, 1e-12) << d;
    EXPECT_NEAR(rating.magnitude, std::max(0.0, (0.5 - d) / 0.5), 1e-12) << d;
    EXPECT_EQ(rating.phase, 1) << d;
    EXPECT_EQ(rating.slope, 1) << d;
  }
}

// Slopes f times as steep have an error of |f - 1|; the worst that counts is 2.
TEST(Rating, SteeperSlopes) {
  for (const double factor : {0.5, 1.5, 2.5, 3.0, 4.0})
    EXPECT_NEAR(rated(sampled(pulse), times(sampled(pulse), factor)).slope,
                std::max(0.0, (2 - std::abs(factor - 1)) / 2), 1e-12)
        << factor;
}

TEST(Rating, DoesNotDependOnTheUnit) {
  const Values reference = sampled(pulse), curve = times(delayed(reference, 7), 1.1);
  const Rating plain = rated(reference, curve);
  for (const double factor : {1e-300, 1e-3, 1e300}) {
    const Rating other = rated(times(reference, factor), times(curve, factor));
    EXPECT_NEAR(other.overall(), plain.overall(), 1e-9) << factor;
  }
}

TEST(Rating, APeriodIsNoShift) {
  const auto wave = [](double x) { return std::sin(40 * std::numbers::pi * x); };
  const Values reference = sampled(+wave);
  EXPECT_EQ(rated(reference, times(reference, 1.01)).phase, 1);
}

TEST(Rating, WhatHasNoRating) {
  const Values pulses = sampled(pulse), zero(count, 0.0), few(9, 1.0);
  EXPECT_FALSE(rate(zero, pulses)) << "a reference without values";
  EXPECT_TRUE(rate(pulses, zero));
  EXPECT_FALSE(rate(few, few));
  EXPECT_FALSE(rate(pulses, Values(count - 1, 1.0)));
  Values broken = pulses;
  broken[3] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(rate(pulses, broken));
  EXPECT_FALSE(rate(broken, pulses));
  EXPECT_EQ(rated(times(pulses, 1e-300), times(pulses, 1e300)).magnitude, 0);
}

TEST(Rating, CurvesAreSampledOverTheirCommonRange) {
  Curve line{"glstat", "energy", "c", 6, {}, {}, 0}, late = line;
  for (const double t : {0.0, 1.0, 2.0}) line.add(t, t);
  for (const double t : {1.0, 3.0}) late.add(t, t);
  EXPECT_NEAR(rate(line, late).value_or(Rating{0, 0, 0, 0}).overall(), 1, 1e-9);
  Curve after = line;
  after.times = {2, 3, 4};
  EXPECT_FALSE(rate(line, after)) << "one instant is not a range";
}

/// Twin: the whole matrix of dynamic time warping, and the way back through it.
double plain_magnitude(const Values& t, const Values& c) {
  const std::size_t n = t.size();
  const auto window = static_cast<std::size_t>(std::ceil(0.1 * static_cast<double>(n)));
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<Values> cost(n, Values(n, none));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      if ((i > j ? i - j : j - i) >= window) continue;
      const double up = i > 0 ? cost[i - 1][j] : none, left = j > 0 ? cost[i][j - 1] : none;
      const double both = i > 0 && j > 0 ? cost[i - 1][j - 1] : none;
      const double before = i + j == 0 ? 0 : std::min({up, left, both});
      cost[i][j] = before + (c[i] - t[j]) * (c[i] - t[j]);
    }
  double difference = 0, size = 0;
  for (std::size_t i = n - 1, j = n - 1;;) {
    difference += std::abs(c[i] - t[j]);
    size += std::abs(t[j]);
    if (i + j == 0) break;
    const double up = i > 0 ? cost[i - 1][j] : none, left = j > 0 ? cost[i][j - 1] : none;
    const double both = i > 0 && j > 0 ? cost[i - 1][j - 1] : none;
    if (both <= up && both <= left) {
      --i;
      --j;
    } else if (up <= left) {
      --i;
    } else {
      --j;
    }
  }
  return std::max(0.0, (0.5 - difference / size) / 0.5);
}

TEST(Rating, MagnitudeAgreesWithTheWholeMatrix) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise;
  std::size_t between = 0;
  for (int scene = 0; scene < 40; ++scene) {
    // Both follow one slow wave without a shift, so that the best shift is none.
    Values t, c;
    const std::size_t n = 40 + static_cast<std::size_t>(scene);
    for (std::size_t i = 0; i < n; ++i) {
      const double wave = std::sin(3 * static_cast<double>(i) / static_cast<double>(n));
      t.push_back(wave + 0.03 * noise(random));
      c.push_back(1.1 * wave + 0.1 * noise(random));
    }
    const Rating rating = rated(t, c);
    if (rating.phase < 1) continue;
    ++between;
    EXPECT_NEAR(rating.magnitude, plain_magnitude(t, c), 1e-12) << scene;
    EXPECT_GT(rating.magnitude, 0) << scene;
    EXPECT_LT(rating.magnitude, 1) << scene;
  }
  EXPECT_GT(between, 10u);
}

}  // namespace
}  // namespace gapcheck::report::rating_test
