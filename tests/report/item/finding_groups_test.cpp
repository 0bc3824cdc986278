#include "report/item/finding_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

#include "report/item/item.hpp"
#include "report/sample.hpp"

namespace gapcheck::report::finding_groups_test {
namespace {

Finding make(std::string id, Severity severity, std::int64_t contact, std::int64_t part, std::uint64_t count) {
  Finding finding = make_finding(std::move(id), "some-rule", "something");
  finding.severity = severity;
  finding.contact = contact;
  finding.part = part;
  finding.count = count;
  return finding;
}

TEST(FindingGroups, SampleDeck) {
  const Report report = sample_report();
  const auto groups = finding_groups(report);
  ASSERT_EQ(groups.size(), 5U);
  EXPECT_EQ(groups[0].id, "GC102");
  EXPECT_EQ(groups[0].deepest, &report.penetrations[0]);
  EXPECT_EQ(groups[0].contact, 7);
  EXPECT_EQ(std::tuple(groups[0].part, groups[0].element_part), std::tuple(1, 2));
  EXPECT_EQ(groups[1].id, "GC501");
  EXPECT_EQ(groups[1].contact_position, no_position);
  EXPECT_EQ(groups[2].id, "GC503");
  EXPECT_EQ(groups[2].contact_position, 1U);
  EXPECT_EQ(groups[3].id, "GC101");
  EXPECT_EQ(groups[3].severity, Severity::warning);
  EXPECT_EQ(groups[4].id, "GC106");
}

/// The same by looking at every finding alone: how many there are by severity, rule, contact and parts.
TEST(FindingGroups, CountWhatTheListHolds) {
  Report report = random_report(2000, 3, 11);
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i)
    report.findings.push_back(make("GC50" + std::to_string(random() % 4), static_cast<Severity>(random() % 3),
                                   random() % 5, random() % 3, 1 + random() % 4));
  using Key = std::tuple<Severity, std::string, std::int64_t, std::int64_t, std::int64_t>;
  std::map<Key, std::uint64_t> expected, found;
  for_each_item(report, [&](const Item& item) {
    expected[{item.severity, std::string(item.id), item.contact, item.part, item.element_part}] += item.count;
    return true;
  });
  const auto groups = finding_groups(report);
  for (const FindingGroup& group : groups)
    found[{group.severity, std::string(group.id), group.contact, group.part, group.element_part}] += group.things;
  EXPECT_EQ(found, expected);
  EXPECT_EQ(groups.size(), expected.size());
  EXPECT_TRUE(std::is_sorted(groups.begin(), groups.end(),
                             [](const auto& a, const auto& b) { return a.severity > b.severity; }));
}

TEST(FindingGroups, TheDeepestRepresentsItsGroup) {
  const Report report = random_report(500, 2, 5);
  const auto groups = finding_groups(report);
  EXPECT_GE(groups.size(), 12U) << "six kinds in two contacts";
  for (const FindingGroup& group : groups) {
    ASSERT_NE(group.deepest, nullptr);
    for (const Penetration& record : report.penetrations) {
      const bool same = record.kind == group.deepest->kind && record.contact == group.deepest->contact &&
                        record.part == group.deepest->part && record.element_part == group.deepest->element_part;
      EXPECT_TRUE(!same || record.depth <= group.deepest->depth);
    }
  }
}

TEST(FindingGroups, WhatFollowsIsFoldedUnderItsCause) {
  Report report;
  report.findings = {make("GC503", Severity::error, 1, 0, 1), make("GC502", Severity::error, 0, 0, 1),
                     make("GC503", Severity::error, 2, 0, 1), make("GC503", Severity::error, 3, 0, 1)};
  report.findings[1].key = 1;
  report.findings[0].cause = report.findings[2].cause = 1;
  report.findings[2].count = 40;  // a line that represents that many
  auto groups = finding_groups(report);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].id, "GC502");
  EXPECT_EQ(groups[0].following, 41U);
  EXPECT_EQ(groups[1].contact, 3);
  EXPECT_EQ(groups[1].following, 0U);
  // Without its cause, because that is ignored, each stands by itself.
  report.findings[1].key = 0;
  EXPECT_EQ(finding_groups(report).size(), 4U);
}

TEST(FindingGroups, KnownFindingsAreInNone) {
  Report report;
  report.findings = {make("GC502", Severity::error, 0, 0, 1), make("GC503", Severity::error, 1, 0, 1)};
  report.findings[0].key = 1;
  report.findings[1].cause = 1;
  report.baseline.emplace().states = {BaselineState::unchanged, BaselineState::fresh};
  const auto groups = finding_groups(report);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].id, "GC503");  // new, although its cause is known
}

// The number by which lists and the page of --html call what represents a group.
TEST(FindingGroups, NumbersAreThoseOfTheItems) {
  Report report = sample_report();
  report.tie_failures.push_back({.node = 77, .distance = 2, .reason = TieReason::too_far});
  report.tie_failures.push_back({.node = 78, .distance = 3, .reason = TieReason::too_far});
  std::vector<Item> items;
  for_each_item(report, [&](const Item& item) {
    items.push_back(item);
    EXPECT_EQ(item.number, items.size());
    return true;
  });
  std::size_t ties = 0;
  const auto groups = finding_groups(report);
  ASSERT_GT(groups.size(), 3U);
  for (const FindingGroup& group : groups) {
    const std::size_t number = number_of(report, group);
    ASSERT_TRUE(number >= 1 && number <= items.size()) << group.id;
    EXPECT_EQ(items[number - 1].id, group.id);
    if (group.deepest != nullptr) {
      EXPECT_EQ(items[number - 1].node, group.deepest->node);
    }
    if (group.first != nullptr) {
      EXPECT_EQ(items[number - 1].message, group.first->message);
    }
    if (group.widest == nullptr) continue;
    ++ties;
    EXPECT_EQ(items[number - 1].node, 78);
  }
  EXPECT_EQ(ties, 1U);
  EXPECT_EQ(link_to(report, 3), "");
  report.page = "out/page.html";
  EXPECT_EQ(link_to(report, 3), "out/page.html#f3");
}

TEST(FindingGroups, TiesByReasonAndSeverity) {
  Report report;
  report.contacts.push_back(make_contact(4, 1, "CONTACT_TIED", "2", 10, 10));
  for (const TieReason reason : {TieReason::too_far, TieReason::too_far, TieReason::offset, TieReason::too_far}) {
    TieFailure failure;
    failure.node = static_cast<std::int64_t>(report.tie_failures.size()) + 1;
    failure.distance = 0.1 * static_cast<double>(failure.node);
    failure.reason = reason;
    report.tie_failures.push_back(failure);
  }
  report.tie_failures[0].by_node_set = true;
  const auto groups = finding_groups(report);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].severity, Severity::error);
  EXPECT_EQ(groups[0].widest->node, 1);
  EXPECT_EQ(groups[1].things, 2U);
  EXPECT_EQ(groups[1].widest->node, 4);
  EXPECT_EQ(groups[2].id, "GC202");
}

}  // namespace
}  // namespace gapcheck::report::finding_groups_test
