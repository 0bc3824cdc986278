// Two sources are compared as the command line compares them.
#include "report/compare/compare.hpp"

#include <gtest/gtest.h>

#include <gapcheck/compare.hpp>
#include <gapcheck/run.hpp>
#include <string>

#include "api/new_folder.hpp"
#include "audit/audit.hpp"

namespace gapcheck::api_test::compare_test {
namespace {

gapcheck::Report internal(const std::string& deck) {
  Diagnostics diagnostics;
  auto report = audit::audit_deck(deck, {}, diagnostics);
  EXPECT_TRUE(report.ok());
  return report.ok() ? std::move(report).value() : gapcheck::Report{};
}

std::string short_run(const NewFolder& folder, const std::string& name, const std::string& deck, std::uint64_t cycles) {
  api::RunOptions options;
  options.cycles = cycles;
  EXPECT_TRUE(api::run_deck(data(deck), folder / name, options).ok());
  return folder / name;
}

TEST(ApiCompare, TwoDecksGiveWhatTheRoomsGive) {
  const std::string a = data("two_plates.k"), b = data("two_plates_tilted.k");
  const gapcheck::Report first = internal(a), second = internal(b);
  const report::Comparison expected = report::compare(first, second, 0);
  const auto result = api::compare(a, b);
  ASSERT_TRUE(result.ok());
  const api::Comparison& comparison = result.value();
  EXPECT_FALSE(comparison.equal);
  EXPECT_TRUE(comparison.complete);
  EXPECT_EQ(comparison.first.penetrations.size(), 18u);
  ASSERT_EQ(comparison.contacts.size(), 1u);
  EXPECT_EQ(comparison.contacts[0].only_first, expected.contacts[0].only_first);
  EXPECT_EQ(comparison.contacts[0].depth_differs, 9u);
  EXPECT_EQ(comparison.contacts[0].largest_difference, expected.contacts[0].largest_difference);
  ASSERT_EQ(comparison.differences.size(), expected.differences.size());
  for (std::size_t i = 0; i < comparison.differences.size(); ++i) {
    EXPECT_EQ(comparison.differences[i].node, expected.differences[i].node);
    EXPECT_EQ(comparison.differences[i].first.value_or(-1), expected.differences[i].first);
    EXPECT_EQ(comparison.differences[i].second.value_or(-1), expected.differences[i].second);
  }
  EXPECT_FALSE(comparison.curves.has_value());
  EXPECT_EQ(api::text(comparison), report::comparison_text(expected, first, second, 10));
  EXPECT_EQ(api::json(comparison), report::comparison_json(expected, first, second));
}

TEST(ApiCompare, ToleranceMakesThemEqual) {
  api::CompareOptions options;
  options.tolerance = 10;
  const auto comparison = api::compare(data("two_plates.k"), data("ignore_2.k"), options);
  ASSERT_TRUE(comparison.ok());
  EXPECT_TRUE(comparison.value().equal);
}

TEST(ApiCompare, ADeckAndItsRun) {
  const NewFolder folder;
  const auto comparison = api::compare(data("two_plates.k"), short_run(folder, "out", "two_plates.k", 2));
  ASSERT_TRUE(comparison.ok()) << comparison.error().message;
  EXPECT_TRUE(comparison.value().equal);
  EXPECT_EQ(comparison.value().contacts[0].agree, 18u);
  EXPECT_EQ(comparison.value().second.source, "messag");
}

TEST(ApiCompare, CurvesOfTwoRuns) {
  const NewFolder folder;
  const std::string a = short_run(folder, "a", "workshop/penetration_snlog_0.k", 60);
  const std::string b = short_run(folder, "b", "workshop/penetration_snlog_1.k", 60);
  const auto comparison = api::compare(a, b);
  ASSERT_TRUE(comparison.ok());
  ASSERT_TRUE(comparison.value().curves.has_value());
  EXPECT_FALSE(comparison.value().equal);
  const api::CurveComparison& curves = *comparison.value().curves;
  EXPECT_GT(curves.differ, 0u);
  EXPECT_EQ(curves.pairs.size(), curves.agree + curves.differ + curves.without_common_times);
  EXPECT_EQ(curves.pairs[0].verdict, api::CurvePair::Verdict::differs);
  ASSERT_TRUE(curves.pairs[0].rating.has_value());
  EXPECT_LT(curves.pairs[0].rating->overall, 1);
  ASSERT_TRUE(comparison.value().motion.has_value());
  const api::MotionComparison& motion = *comparison.value().motion;
  ASSERT_EQ(motion.parts.size(), 2u);
  EXPECT_EQ(motion.parts[0].largest.size(), motion.times.size());
  EXPECT_EQ(motion.differ, motion.parts[0].differs ? 1u : 0u);
  EXPECT_NE(api::text(comparison.value()).find("curves: "), std::string::npos);
  api::CompareOptions options;
  options.curves = false;
  const auto records = api::compare(a, b, options);
  ASSERT_TRUE(records.ok());
  EXPECT_FALSE(records.value().curves.has_value());
  EXPECT_FALSE(records.value().motion.has_value());
  EXPECT_TRUE(records.value().equal);
}

TEST(ApiCompare, WhatCannotBeComparedIsAnError) {
  const NewFolder folder;
  const std::string deck = data("two_plates.k");
  const auto message = [&](const std::string& second, const api::CompareOptions& options = {}) {
    const auto comparison = api::compare(deck, second, options);
    return comparison.ok() ? std::string("accepted") : comparison.error().message;
  };
  EXPECT_NE(message(folder / "none.k").find("cannot be opened"), std::string::npos);
  EXPECT_NE(message(folder.path()).find("no messag"), std::string::npos);
  EXPECT_NE(message(folder.file("empty.k", "")).find("is empty"), std::string::npos);
  api::CompareOptions options;
  options.contacts = {77};
  EXPECT_EQ(message(deck, options), "contact 77: neither source has such a contact");
  options = {};
  options.tolerance = -1;
  EXPECT_EQ(message(deck, options), "tolerance: -1 is not a number of 0 or more");
  options = {};
  options.curve_names = {"energy"};
  EXPECT_EQ(message(deck, options), "curve_names: there are no such curves that both sources have");
}

TEST(ApiCompare, AnEmptyComparisonIsWritten) {
  EXPECT_FALSE(api::text(api::Comparison{}).empty());
  EXPECT_FALSE(api::json(api::Comparison{}).empty());
}

TEST(ApiCompare, TheCallerMayStopItAtAnyTime) {
  const NewFolder folder;
  const std::string a = short_run(folder, "a", "two_plates.k", 3), b = short_run(folder, "b", "two_plates.k", 3);
  for (const auto& [first, second] : {std::pair(data("two_plates.k"), data("ignore_2.k")), std::pair(a, b)}) {
    api::CompareOptions options;
    int asked = 0;
    options.watch = [&asked] { return ++asked > 0; };
    ASSERT_TRUE(api::compare(first, second, options).ok());
    const int all = asked;
    EXPECT_GT(all, 8);
    for (const int last : {1, all / 2, all}) {
      asked = 0;
      options.watch = [&asked, last] { return ++asked < last; };
      const auto stopped = api::compare(first, second, options);
      ASSERT_FALSE(stopped.ok()) << last;
      EXPECT_EQ(stopped.error().message, "the comparison was stopped");
      EXPECT_EQ(asked, last);
    }
  }
}

}  // namespace
}  // namespace gapcheck::api_test::compare_test
