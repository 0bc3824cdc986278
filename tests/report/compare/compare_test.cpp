#include "report/compare/compare.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "report/sample.hpp"

namespace gapcheck::report::compare_test {
namespace {

Penetration record(std::uint32_t contact, std::int64_t node, double depth) {
  Penetration result;
  result.contact = contact;
  result.node = node;
  result.depth = depth;
  result.contact_distance = 1;
  return result;
}

Report two_contacts(std::vector<Penetration> records) {
  Report report;
  report.input = "a.k";
  report.source = "deck";
  report.contacts = {make_contact(7, 1, "CONTACT_X", "13", 0, 0), make_contact(3, 2, "CONTACT_Y", "a3", 0, 0)};
  report.contacts[0].title = "all parts";
  report.penetrations = std::move(records);
  return report;
}

TEST(Compare, EqualReports) {
  const Report report = two_contacts({record(0, 5, 0.4), record(0, 4, 0.3), record(1, 5, 0.1)});
  const Comparison comparison = compare(report, report, 0);
  EXPECT_TRUE(comparison.equal());
  ASSERT_EQ(comparison.contacts.size(), 2u);
  EXPECT_EQ(comparison.contacts[0].agree, 2u);
  EXPECT_EQ(comparison.contacts[1].agree, 1u);
  EXPECT_TRUE(comparison.differences.empty());
}

TEST(Compare, OrderOfContactsAndRecordsDoesNotMatter) {
  const Report first = two_contacts({record(0, 5, 0.4), record(0, 4, 0.3), record(1, 5, 0.1)});
  Report second = two_contacts({record(0, 5, 0.1), record(1, 4, 0.3), record(1, 5, 0.4)});
  std::swap(second.contacts[0], second.contacts[1]);
  EXPECT_TRUE(compare(first, second, 0).equal());
}

TEST(Compare, MissingExtraAndDiffering) {
  const Report first = two_contacts({record(0, 5, 0.4), record(0, 4, 0.3), record(0, 9, 0.2)});
  const Report second = two_contacts({record(0, 5, 0.4), record(0, 4, 0.35), record(0, 8, 0.01), record(1, 1, 0.5)});
  const Comparison comparison = compare(first, second, 0.01);
  EXPECT_FALSE(comparison.equal());
  const ContactComparison& contact = comparison.contacts[0];
  EXPECT_EQ(contact.agree, 1u);
  EXPECT_EQ(contact.depth_differs, 1u);
  EXPECT_EQ(contact.only_first, 1u);
  EXPECT_EQ(contact.only_second, 1u);
  EXPECT_DOUBLE_EQ(contact.largest_difference, 0.35 - 0.3);
  ASSERT_EQ(comparison.differences.size(), 4u);
  EXPECT_EQ(comparison.differences[0].node, 9) << "largest first";
  EXPECT_LT(comparison.differences[0].second, 0);
  EXPECT_EQ(comparison.differences[3].contact, 3);
  EXPECT_TRUE(compare(first, second, 0.06).contacts[0].depth_differs == 0);
}

TEST(Compare, PrintedDigitsAreNoDifference) {
  std::mt19937 random(11);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::pow(10.0, std::uniform_real_distribution(-12.0, 6.0)(random));
    const double printed = std::stod(fmt::format("{:.4E}", value));
    EXPECT_TRUE(same_depth(value, printed, 0)) << value;
    EXPECT_FALSE(same_depth(value, value * 1.0002, 0)) << value;
  }
  EXPECT_TRUE(same_depth(0, 0, 0));
  EXPECT_FALSE(same_depth(0, 1e-9, 0));
  EXPECT_FALSE(same_depth(NAN, 1, 1));
}

TEST(Compare, ContactsThatWereNotCheckedAreNotHeldAgainstEachOther) {
  Report first = two_contacts({record(1, 1, 0.5)});
  const Report second = two_contacts({record(0, 5, 0.4)});
  first.contacts[0].not_checked = "SOFT = 2";
  const Comparison comparison = compare(first, second, 0);
  EXPECT_TRUE(comparison.contacts[0].not_checked);
  EXPECT_EQ(comparison.contacts[0].only_second, 0u);
  EXPECT_EQ(comparison.contacts[1].only_first, 1u);
  EXPECT_NE(comparison_text(comparison, first, second, 5).find("1 contact not compared"), std::string::npos);
}

TEST(Compare, AContactOfOneSourceAloneIsADifferenceOnlyWithRecords) {
  const Report first = two_contacts({record(0, 5, 0.4)});
  Report second;
  EXPECT_FALSE(compare(first, second, 0).equal());
  EXPECT_TRUE(compare(two_contacts({}), second, 0).equal());
  EXPECT_TRUE(compare(first, second, 0).contacts[0].missing_in_second);
  EXPECT_TRUE(compare(second, first, 0).contacts[0].missing_in_first);
  EXPECT_EQ(compare(second, first, 0).contacts[0].only_second, 1u);
}

TEST(Compare, ReleasedNodesMayBeListedOrNot) {
  Report first = two_contacts({record(0, 5, 0.9), record(0, 4, 0.3)});
  first.penetrations[0].kind = PenetrationKind::released;
  EXPECT_TRUE(compare(first, two_contacts({record(0, 4, 0.3)}), 0).equal());
  EXPECT_TRUE(compare(first, two_contacts({record(0, 4, 0.3), record(0, 5, 0.9)}), 0).equal());
  EXPECT_FALSE(compare(first, two_contacts({record(0, 4, 0.3), record(0, 5, 0.8)}), 0).equal());
  first.penetrations[0].kind = PenetrationKind::edge_zone;
  EXPECT_FALSE(compare(first, two_contacts({record(0, 4, 0.3), record(0, 5, 0.9)}), 0).equal());
}

TEST(Compare, WhatTheSolverDoesNotListCountsBetweenDecksOnly) {
  for (const auto kind : {PenetrationKind::segment, PenetrationKind::mortar, PenetrationKind::edge}) {
    Report first = two_contacts({record(0, 5, 0.9)}), second = two_contacts({});
    first.penetrations[0].kind = kind;
    EXPECT_TRUE(compare(first, first, 0).equal());
    EXPECT_EQ(compare(first, second, 0).contacts[0].only_first, 1u);
    second.source = "messag";
    EXPECT_TRUE(compare(first, second, 0).equal());
    EXPECT_FALSE(compare(first, second, 0).contacts[0].not_checked);
    first.contacts[0].by_segments = true;
    EXPECT_TRUE(compare(first, second, 0).contacts[0].not_checked);
    EXPECT_FALSE(compare(first, first, 0).contacts[0].not_checked);
  }
}

TEST(Compare, AnEdgeAtANodeIsNotTheNode) {
  Report first = two_contacts({record(0, 5, 0.9), record(0, 5, 0.4)});
  first.penetrations[1].kind = PenetrationKind::edge;
  const Comparison both = compare(first, first, 0);
  EXPECT_EQ(both.contacts[0].agree, 2u);
  EXPECT_EQ(compare(first, two_contacts({record(0, 5, 0.9)}), 0).contacts[0].only_first, 1u);
}

TEST(Compare, NumbersWhereNodesAreNotListed) {
  const Report first = two_contacts({record(0, 5, 0.4), record(0, 4, 0.3)});
  Report second = two_contacts({});
  second.contacts[0].reported_penetrations = 2;
  EXPECT_TRUE(compare(first, second, 0).equal());
  EXPECT_TRUE(compare(first, second, 0).contacts[0].counts_only);
  second.contacts[0].reported_penetrations = 5;
  EXPECT_EQ(compare(first, second, 0).contacts[0].only_second, 3u);
  EXPECT_EQ(compare(second, first, 0).contacts[0].only_first, 3u);
}

TEST(Compare, ListedNodesByNameAndTheRestByNumber) {
  const Report first = two_contacts({record(0, 1, 0.5), record(0, 2, 0.4), record(0, 3, 0.3)});
  Report second = two_contacts({record(0, 1, 0.5)});
  second.contacts[0].penetrations = 1;
  second.contacts[0].reported_penetrations = 3;
  const Comparison equal = compare(first, second, 0);
  EXPECT_TRUE(equal.equal());
  EXPECT_EQ(equal.contacts[0].agree, 3U);
  EXPECT_EQ(equal.contacts[0].by_number, 2U);
  EXPECT_FALSE(equal.contacts[0].counts_only);
  EXPECT_TRUE(equal.differences.empty());
  // A listed node that the other source lacks is a difference, whatever the numbers say, and so is another depth.
  second.penetrations = {record(0, 7, 0.5)};
  EXPECT_EQ(compare(first, second, 0).contacts[0].only_second, 1U);
  EXPECT_EQ(compare(first, second, 0).contacts[0].only_first, 1U);
  second.penetrations = {record(0, 1, 0.1)};
  EXPECT_EQ(compare(first, second, 0).contacts[0].depth_differs, 1U);
  // More than anybody could name.
  second.contacts[0].reported_penetrations = 5;
  EXPECT_EQ(compare(first, second, 0).contacts[0].only_second, 2U);
  EXPECT_EQ(compare(second, first, 0).contacts[0].only_first, 2U);
}

TEST(Compare, AgreesWithANaiveComparison) {
  std::mt19937 random(12);
  for (unsigned round = 0; round < 50; ++round) {
    const auto make = [&] {
      std::vector<Penetration> records;
      for (std::uint32_t contact = 0; contact < 2; ++contact)
        for (std::int64_t node = 1; node < 60; ++node)
          if (random() % 2 == 0) records.push_back(record(contact, node, 0.1 * static_cast<double>(1 + random() % 3)));
      return two_contacts(records);
    };
    const Report first = make(), second = make();
    std::map<std::pair<std::uint32_t, std::int64_t>, std::pair<double, double>> depths;
    for (const Penetration& p : first.penetrations) depths[{p.contact, p.node}].first = p.depth;
    for (const Penetration& p : second.penetrations) depths[{p.contact, p.node}].second = p.depth;
    std::map<std::uint32_t, std::array<std::uint64_t, 4>> counts;
    for (const auto& [key, pair] : depths) {
      const auto [a, b] = pair;
      ++counts[key.first][b == 0 ? 2 : a == 0 ? 3 : std::abs(a - b) > 0.05 ? 1 : 0];
    }
    const Comparison comparison = compare(first, second, 0);
    for (std::uint32_t i = 0; i < 2; ++i) {
      const ContactComparison& c = comparison.contacts[i];
      EXPECT_EQ((std::array{c.agree, c.depth_differs, c.only_first, c.only_second}), counts[i]);
    }
  }
}

TEST(Compare, Text) {
  const Report first = two_contacts({record(0, 5, 0.4), record(0, 4, 0.3), record(0, 9, 0.2)});
  Report second = two_contacts({record(0, 5, 0.4), record(0, 4, 0.35)});
  second.input = "messag";
  second.contacts.pop_back();
  EXPECT_EQ(comparison_text(compare(first, second, 0), first, second, 1), R"(A: a.k
B: messag

  contact  type  agree  depth differs  only A  only B  by at most
        7    13      1              1       1       0        0.05
        3    a3      0              0       0       0           0  not in B

contact 7: 2 nodes differ, largest 1
  node    A  B
     9  0.2  -

the two differ, 1 node agrees
)");
}

TEST(Compare, Json) {
  const Report first = two_contacts({record(0, 5, 0.4), record(0, 9, 0.2)});
  Report second = two_contacts({record(0, 5, 0.25)});
  second.source = "messag";
  second.input = "mess\xff";
  const auto json = nlohmann::json::parse(comparison_json(compare(first, second, 0), first, second));
  EXPECT_EQ(json["schema"], "gapcheck-compare/1");
  EXPECT_EQ(json["equal"], false);
  EXPECT_EQ(json["second"]["source"], "messag");
  EXPECT_EQ(json["contacts"][0]["title"], "all parts");
  EXPECT_EQ(json["contacts"][0]["depth_differs"], 1);
  ASSERT_EQ(json["differences"].size(), 2u);
  EXPECT_FALSE(json["differences"][0].contains("second")) << "what a source does not have is left out";
  EXPECT_EQ(json["differences"][1]["second"], 0.25);
}

}  // namespace
}  // namespace gapcheck::report::compare_test
