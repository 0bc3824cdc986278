#include "report/compare/compare_curves.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "report/compare/compare.hpp"

namespace gapcheck::report::compare_curves_test {
namespace {

Curve curve(const std::string& name, std::vector<double> times, std::vector<double> values) {
  Curve result{"glstat", "energy", name, 6, {}, {}, 0};
  result.times = std::move(times);
  result.values = std::move(values);
  return result;
}

/// One pair of curves, alone in their family.
CurvePair pair_of(const Curve& a, const Curve& b, double tolerance = 1e-3) {
  const CurveComparison comparison = compare_curves({a}, {b}, {tolerance, {}});
  EXPECT_EQ(comparison.pairs.size(), 1u);
  return comparison.pairs.empty() ? CurvePair{} : comparison.pairs[0];
}

using Verdict = CurvePair::Verdict;

// A parabola against the chord of it: by hand, a largest difference of 1/4 in the middle, an L2 difference of
// sqrt(1/30) over sqrt(1/3).
TEST(CompareCurves, NormsOfKnownFunctions) {
  std::vector<double> times, values;
  for (int i = 0; i <= 1000; ++i) {
    times.push_back(i / 1000.0);
    values.push_back(times.back() * times.back());
  }
  const CurvePair pair = pair_of(curve("c", times, values), curve("c", {0, 1}, {0, 1}));
  EXPECT_EQ(pair.verdict, Verdict::differs);
  EXPECT_NEAR(pair.largest_difference, 0.25, 1e-12);
  EXPECT_DOUBLE_EQ(pair.time, 0.5);
  EXPECT_NEAR(pair.relative_difference, 0.25, 1e-12);
  EXPECT_NEAR(pair.l2_difference, std::sqrt(0.1), 1e-5);
  EXPECT_EQ(pair.largest_second, 1);
}

TEST(CompareCurves, OnlyTheCommonRangeCounts) {
  const CurvePair pair = pair_of(curve("c", {0, 1, 2}, {9, 1, 2}), curve("c", {1, 1.5, 3}, {1, 1.5, 99}));
  EXPECT_EQ(pair.largest_second, 1.5 + (99 - 1.5) / 3) << "sampled at 2, the last common time";
  EXPECT_EQ(pair.time, 2);
  EXPECT_EQ(pair.largest_first, 2);
  EXPECT_EQ(pair_of(curve("c", {0, 1}, {1, 1}), curve("c", {2, 3}, {1, 1})).verdict, Verdict::no_common_times);
  EXPECT_EQ(pair_of(curve("c", {0, 1}, {1, 1}), curve("c", {}, {})).verdict, Verdict::no_common_times);
  EXPECT_DOUBLE_EQ(pair_of(curve("c", {0, 1}, {1, 5}), curve("c", {1, 2}, {4, 5})).relative_difference, 0.2);
}

TEST(CompareCurves, ToleranceIsOfTheLargerCurve) {
  const Curve a = curve("c", {0, 1, 2}, {0, 1000, -2000}), b = curve("c", {0, 1, 2}, {0, 1001.9, -2000});
  EXPECT_EQ(pair_of(a, b).verdict, Verdict::agrees) << "1.9 of 2000";
  EXPECT_EQ(pair_of(a, b, 9e-4).verdict, Verdict::differs);
  EXPECT_NEAR(pair_of(a, b).largest_difference, 1.9, 1e-9);
}

TEST(CompareCurves, PrintingIsNoDifference) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> times, up, down;
    for (int i = 0; i < 20; ++i) {
      const double value = std::pow(10.0, std::uniform_real_distribution(-12.0, 6.0)(random));
      times.push_back(i);
      up.push_back(std::stod(fmt::format("{:.5e}", value)));
      down.push_back(std::stod(fmt::format("{:.5e}", value * (1 + 4e-7))));
    }
    EXPECT_EQ(pair_of(curve("c", times, up), curve("c", times, down), 0).verdict, Verdict::agrees);
  }
  EXPECT_EQ(pair_of(curve("c", {0}, {1.00000}), curve("c", {0}, {1.00002}), 0).verdict, Verdict::differs);
}

TEST(CompareCurves, ZeroAndNegligibleCurvesAgree) {
  EXPECT_EQ(pair_of(curve("c", {0, 1}, {0, 0}), curve("c", {0, 1}, {0, -0.0})).verdict, Verdict::agrees);
  const std::vector<Curve> first{curve("big", {0, 1}, {1, 1e6}), curve("small", {0, 1}, {0, 9e-4})};
  std::vector<Curve> second{curve("big", {0, 1}, {1, 1e6}), curve("small", {0, 1}, {0, -9e-4})};
  EXPECT_EQ(compare_curves(first, second, {}).differ, 0u) << "9e-10 of the largest energy";
  second[1].values[1] = 2e-3;
  EXPECT_EQ(compare_curves(first, second, {}).differ, 1u);
  second[1].values[1] = -9e-4;
  second[0].quantity = "work";
  std::vector<Curve> alone = first;
  alone[0].quantity = "work";
  EXPECT_EQ(compare_curves(alone, second, {}).differ, 1u) << "nothing to be small beside";
}

TEST(CompareCurves, ValuesThatAreNoNumbers) {
  Curve broken = curve("c", {0}, {1});
  broken.not_numbers = 3;
  EXPECT_EQ(pair_of(broken, curve("c", {0}, {1})).verdict, Verdict::differs);
  EXPECT_TRUE(pair_of(broken, curve("c", {0}, {1})).not_numbers);
  EXPECT_EQ(pair_of(broken, broken).verdict, Verdict::agrees);
}

TEST(CompareCurves, NothingOverflows) {
  const CurvePair pair = pair_of(curve("c", {0, 1}, {1e308, -1e308}), curve("c", {0, 1}, {-1e308, 1e308}));
  EXPECT_EQ(pair.relative_difference, 2);
  EXPECT_NEAR(pair.l2_difference, 2, 1e-12);
  EXPECT_EQ(pair_of(curve("c", {-1e308, 1e308}, {1, 2}), curve("c", {0}, {5e-324})).verdict, Verdict::differs);
}

TEST(CompareCurves, NamesOfOneRunAloneAreListed) {
  Curve node = curve("nodout node 1 x-velocity", {0}, {1});
  node.file = "nodout";
  const std::vector<Curve> first{curve("a", {0}, {1}), curve("b", {0}, {1}), node, node}, second{curve("a", {0}, {2})};
  const CurveComparison comparison = compare_curves(first, second, {});
  EXPECT_EQ(comparison.differ, 1u);
  EXPECT_EQ(comparison.only_first, (std::vector<std::string>{"b", "nodout"})) << "a whole file by its name";
  EXPECT_TRUE(comparison.only_second.empty());
  EXPECT_EQ(compare_curves(first, second, {1e-3, {"b"}}).pairs.size(), 0u);
  EXPECT_EQ(compare_curves(second, first, {}).only_second.size(), 2u);
}

TEST(CompareCurves, WorstFirstInTextAndJson) {
  const std::vector<Curve> first{curve("x", {0, 1}, {1, 1}), curve("y", {0, 1}, {1, 2}), curve("z", {0, 1}, {4, 4})};
  const std::vector<Curve> second{curve("x", {0, 1}, {1, 1.5}), curve("y", {0, 2}, {1, 7}), curve("z", {0, 1}, {4, 4})};
  const CurveComparison curves = compare_curves(first, second, {});
  Report a, b;
  a.input = "out1";
  b.input = "out2";
  const std::string text = comparison_text(compare(a, b, 0), a, b, 1, {&curves});
  EXPECT_NE(text.find(R"(curves: 3 compared, 2 differ by more than 0.001 of the larger one
  curve  rating  relative        L2  by at most  at time  largest A  largest B
  y       0.280  5.00e-01  4.36e-01           2        1          2          4
  … and 1 more
  A ends at time 1, B at 2

the two differ, 0 nodes agree, 1 curve agrees
)"),
            std::string::npos)
      << text;
  const auto json = nlohmann::json::parse(comparison_json(compare(a, b, 0), a, b, {&curves}));
  EXPECT_EQ(json["equal"], false);
  EXPECT_EQ(json["curves"]["differ"], 2);
  ASSERT_EQ(json["curves"]["pairs"].size(), 3u);
  EXPECT_EQ(json["curves"]["pairs"][0]["name"], "y");
  EXPECT_NEAR(json["curves"]["pairs"][1]["relative_difference"].get<double>(), 1 / 3.0, 1e-15);
  EXPECT_EQ(json["curves"]["pairs"][2]["verdict"], "agrees");
  // y rises three times as fast as its reference: corridor 0.05 + 0.45/3, slope and magnitude 0, no shift.
  EXPECT_NEAR(json["curves"]["pairs"][0]["rating"]["corridor"].get<double>(), 0.2, 1e-3);
  EXPECT_EQ(json["curves"]["pairs"][0]["rating"]["phase"], 1);
  EXPECT_EQ(json["curves"]["pairs"][0]["rating"]["magnitude"], 0);
  EXPECT_NEAR(json["curves"]["pairs"][0]["rating"]["slope"].get<double>(), 0, 1e-9);
  EXPECT_FALSE(nlohmann::json::parse(comparison_json(compare(a, b, 0), a, b)).contains("curves"));
}

}  // namespace
}  // namespace gapcheck::report::compare_curves_test
