#include "results/log/write_messag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <regex>

#include "results/fixtures.hpp"
#include "results/read.hpp"

namespace gapcheck::results::write_messag_test {
namespace {

/// The value that five printed digits stand for.
double printed(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4E", value);
  return std::strtod(text, nullptr);
}

Vector printed(const Vector& v) { return {printed(v.x()), printed(v.y()), printed(v.z())}; }

Report random_report(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Report report;
  report.contacts.resize(3);
  for (std::size_t i = 0; i < 3; ++i) report.contacts[i].id = static_cast<std::int64_t>(i) * 7 + 1;
  for (int i = 0; i < 50; ++i) {
    Penetration p;
    p.contact = static_cast<std::uint32_t>(random() % 3);
    p.node = i + 1 + static_cast<std::int64_t>(random() % 3) * 100'000'000'000;
    p.segment_number = 1 + static_cast<std::uint32_t>(random() % 1000);
    p.segment = {9, 8, 7, random() % 2 == 0 ? 7 : 6};
    p.depth = std::abs(unit(random)) * std::pow(10.0, static_cast<int>(random() % 9) - 4);
    p.contact_distance = p.depth + std::abs(unit(random));
    p.s = random() % 3 == 0 ? 1 : unit(random);
    p.t = random() % 3 == 0 ? -1 : unit(random);
    p.original = Vector(unit(random), unit(random), unit(random)) * 100;
    p.outcome = random() % 2 == 0 ? Outcome::moved : Outcome::kept;
    p.moved_to = p.outcome == Outcome::moved ? Vector(p.original + Vector(0, 0, 1 + p.depth)) : p.original;
    report.penetrations.push_back(p);
  }
  constexpr std::array reasons{TieReason::sep,       TieReason::offset,  TieReason::too_far, TieReason::too_short,
                               TieReason::not_found, TieReason::rigslav, TieReason::rigmast, TieReason::conflict};
  for (int i = 0; i < 24; ++i) {
    TieFailure t;
    t.contact = static_cast<std::uint32_t>(i / 8);
    t.node = 1000 + i;
    t.reason = reasons[static_cast<std::size_t>(i) % 8];
    t.segment_number = static_cast<std::uint32_t>(random() % 3);
    t.distance = random() % 2 == 0 ? -1 : std::abs(unit(random));
    report.tie_failures.push_back(t);
  }
  return report;
}

TEST(WriteMessag, ReadingBackGivesThePrintedDigits) {
  std::mt19937 random(2);
  for (int round = 0; round < 20; ++round) {
    const Report report = random_report(random);
    const Read read = read_text(write_messag(report));
    ASSERT_FALSE(read.errors) << first_error(read);
    ASSERT_EQ(read.report.penetrations.size(), report.penetrations.size());
    for (const Penetration& found : read.report.penetrations) {
      const auto same = std::find_if(report.penetrations.begin(), report.penetrations.end(), [&](const Penetration& p) {
        return p.node == found.node && report.contacts[p.contact].id == read.report.contacts[found.contact].id;
      });
      ASSERT_NE(same, report.penetrations.end()) << found.node;
      EXPECT_EQ(found.segment, same->segment);
      EXPECT_EQ(found.segment_number, same->segment_number);
      EXPECT_EQ(found.depth, printed(same->depth));
      EXPECT_EQ(found.contact_distance, printed(same->depth) + printed(same->remaining()));
      EXPECT_EQ(found.s, printed(same->s));
      EXPECT_EQ(found.t, printed(same->t));
      EXPECT_EQ(found.original, printed(same->original));
      EXPECT_EQ(found.moved_to, printed(same->moved_to));
      EXPECT_EQ(found.outcome, same->outcome == Outcome::moved ? Outcome::moved : Outcome::reported);
    }
    ASSERT_EQ(read.report.tie_failures.size(), report.tie_failures.size());
    for (const TieFailure& found : read.report.tie_failures) {
      const auto same = std::find_if(report.tie_failures.begin(), report.tie_failures.end(),
                                     [&](const TieFailure& t) { return t.node == found.node; });
      ASSERT_NE(same, report.tie_failures.end());
      EXPECT_EQ(name(found.reason), name(same->reason));
      EXPECT_EQ(found.segment_number, same->segment_number);
      EXPECT_EQ(found.distance, same->distance < 0 ? -1 : printed(same->distance));
    }
    EXPECT_TRUE(read.report.run->messages.empty());
  }
}

// Every outcome comes back: what was released, and where IGNORE = 2 recommends to put a node.
TEST(WriteMessag, ReleasedNodesAndRecommendedPositionsComeBack) {
  Report report;
  report.contacts.resize(1);
  report.contacts[0].id = 3;
  Penetration kept;
  kept.node = 5;
  kept.segment_number = 2;
  kept.segment = {11, 12, 13, 14};
  kept.depth = 0.25;
  kept.contact_distance = 1;
  kept.original = Vector(1, 2, 0.75);
  kept.point = Vector(1, 2, 0);
  kept.moved_to = Vector(1, 2, 1.0005);
  kept.outcome = Outcome::kept;
  Penetration released = kept;
  released.node = 6;
  released.depth = 0.9;
  released.original = released.moved_to = Vector(1, 2, 0.1);
  released.kind = PenetrationKind::released;
  released.outcome = Outcome::released;
  report.penetrations = {released, kept};
  const Report read = read_text(write_messag(report)).report;
  ASSERT_EQ(read.penetrations.size(), 2u);
  EXPECT_EQ(read.penetrations[0].node, 6);
  EXPECT_EQ(read.penetrations[0].kind, PenetrationKind::released);
  EXPECT_EQ(read.penetrations[0].outcome, Outcome::released);
  EXPECT_EQ(read.penetrations[0].depth, 0.9);
  EXPECT_EQ(read.penetrations[1].node, 5);
  EXPECT_TRUE(read.penetrations[1].recommended());
  EXPECT_EQ(read.penetrations[1].moved_to, kept.moved_to);
  EXPECT_EQ(read.contacts[0].released, 1u);
  ASSERT_TRUE(read.contacts[0].initial_summary);
  EXPECT_EQ(read.contacts[0].initial_summary->nodes, 2u);
  EXPECT_EQ(read.contacts[0].reported_penetrations, 2u) << "as many as are listed";
}

TEST(WriteMessag, LayoutOfTheSolver) {
  const std::string& solver = fixtures::smp_penetrations;
  // The fixture was cut from a longer file, without the summaries.
  const std::string written =
      std::regex_replace(write_messag(read_text(solver).report),
                         std::regex(" summary of initial penetration[^\n]*\n(   (number|min|max)[^\n]*\n)+"), "");
  const std::size_t begin = solver.find(" \n ***"), end = solver.find(" contracting");
  EXPECT_NE(written.find(solver.substr(begin, end - begin)), std::string::npos) << written;
}

TEST(WriteMessag, NothingFoundIsALogAllTheSame) {
  const Read read = read_text(write_messag({}));
  EXPECT_TRUE(read.diagnostics.empty());
  EXPECT_TRUE(read.report.penetrations.empty());
}

TEST(WriteMessag, ExponentsOfThreeDigits) {
  Report report;
  report.contacts.resize(1);
  report.contacts[0].id = 1;
  Penetration p;
  p.node = 1;
  p.segment = {1, 2, 3, 4};
  p.depth = 2.5e-120;
  p.contact_distance = 1e130;
  report.penetrations = {p};
  const std::string text = write_messag(report);
  EXPECT_NE(text.find("= -2.5000-120\n"), std::string::npos) << text;
  EXPECT_EQ(read_text(text).report.penetrations.at(0).depth, 2.5e-120);
}

TEST(WriteMessag, OtherKindsAreNotListed) {
  Report report = read_text(fixtures::smp_penetrations).report;
  ASSERT_EQ(report.penetrations.size(), 2U);
  report.penetrations[1].kind = PenetrationKind::released;
  for (const auto kind :
       {PenetrationKind::edge_zone, PenetrationKind::segment, PenetrationKind::mortar, PenetrationKind::edge}) {
    report.penetrations[0].kind = kind;
    EXPECT_EQ(write_messag(report).find("40565"), std::string::npos);
  }
}

}  // namespace
}  // namespace gapcheck::results::write_messag_test
