#include "audit/grouped.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace gapcheck::audit::grouped_test {
namespace {

Finding words(const Found& found) {
  Finding f;
  f.part = found.group;
  f.node = static_cast<std::int64_t>(found.item);
  f.penetration = found.weight;
  return f;
}

Finding rest(const Found& heaviest, std::uint64_t count) {
  Finding f = words(heaviest);
  f.message = std::to_string(count) + " more";
  return f;
}

TEST(Grouped, AFewAreReportedOneByOneHeaviestFirst) {
  Report report;
  add_grouped(report, {{1, 0.5, 7}, {1, 2.0, 9}, {1, 0.5, 3}}, words, rest);
  ASSERT_EQ(report.findings.size(), 3U);
  EXPECT_EQ(report.findings[0].node, 9);
  EXPECT_EQ(report.findings[1].node, 3);
  EXPECT_EQ(report.findings[2].node, 7);
  for (const Finding& f : report.findings) EXPECT_EQ(f.count, 1U);
}

TEST(Grouped, WhatIsCollectedIsThatOfEveryThing) {
  std::vector<Found> found;
  for (std::uint64_t i = 1; i <= 100; ++i) found.push_back({1, static_cast<double>(i), i});
  Report report;
  add_grouped(report, found, words, rest, [](const Found& f, FindingMembers& members) {
    members.nodes.push_back(static_cast<std::int64_t>(f.item));
  });
  ASSERT_EQ(report.findings.size(), 11U);
  EXPECT_EQ(report.findings[0].members.nodes, (std::vector<std::int64_t>{100}));
  const auto& others = report.findings[10].members.nodes;
  EXPECT_EQ(others.size(), 90U);
  EXPECT_EQ(std::set<std::int64_t>(others.begin(), others.end()).size(), 90U);
  EXPECT_EQ(others.back(), 1);
}

TEST(Grouped, ManyGetOneLineForTheRestOfEachGroup) {
  std::vector<Found> found;
  for (std::uint64_t i = 0; i < 1000; ++i) found.push_back({i < 989 ? 1 : 2, static_cast<double>(i), i});
  std::shuffle(found.begin(), found.end(), std::mt19937(1));
  Report report;
  add_grouped(report, found, words, rest);
  // Group 1: ten and one line for 979; group 2 has eleven: all of them.
  ASSERT_EQ(report.findings.size(), 22U);
  EXPECT_EQ(report.findings[10].count, 979U);
  EXPECT_EQ(report.findings[10].message, "979 more");
  EXPECT_EQ(report.findings[10].node, 978);
  EXPECT_EQ(report.findings[21].count, 1U);
  EXPECT_TRUE(report.findings[21].message.empty());
  std::uint64_t total = 0;
  for (const Finding& f : report.findings) total += f.count;
  EXPECT_EQ(total, 1000U);
}

TEST(Grouped, TheFirstInFullAndTheRestInOne) {
  std::vector<Finding> found(12);
  for (std::size_t i = 0; i < found.size(); ++i) found[i].contact = static_cast<std::int64_t>(i + 1);
  Report all, some;
  add_first(all, {found.begin(), found.begin() + 10}, "more");
  EXPECT_EQ(all.findings.size(), 10U);
  add_first(some, found, "more contacts");
  ASSERT_EQ(some.findings.size(), 11U);
  EXPECT_EQ(some.findings[9].contact, 10);
  EXPECT_EQ(some.findings[10].count, 2U);
  EXPECT_EQ(some.findings[10].message, "2 more contacts, the first of them contact 11");
}

TEST(Grouped, NothingGivesNothing) {
  Report report;
  add_grouped(report, {}, words, rest);
  EXPECT_TRUE(report.findings.empty());
}

}  // namespace
}  // namespace gapcheck::audit::grouped_test
