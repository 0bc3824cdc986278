#include "report/baseline/baseline.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "report/format/formats.hpp"
#include "report/sample.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report::baseline_test {
namespace {

using enum BaselineState;

const LookedFor all = [](const KnownFinding&) { return true; };

/// `before` written to a file and read back, then compared with `now`.
BaselineComparison compared(const Report& before, const Report& now) {
  const auto read = read_baseline(baseline_text(known_findings(before)), "baseline");
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.error().message);
  return read.ok() ? compare_with_baseline(now, read.value(), all) : BaselineComparison{};
}

std::string outcome(const Report& before, const Report& now) { return summary(compared(before, now)); }

/// A report with one penetrating node.
Report one_node(double x, double depth, PenetrationKind kind = PenetrationKind::initial) {
  Report report;
  report.source = "deck";
  report.contacts.push_back(make_contact(7, 1, "CONTACT_AUTOMATIC_SINGLE_SURFACE", "13", 50, 32));
  Penetration record;
  record.node = 5;
  record.original = {x, 0, 0};
  record.depth = depth;
  record.contact_distance = 1;
  record.kind = kind;
  report.penetrations.push_back(record);
  return report;
}

TEST(Baseline, TheSameReportIsUnchanged) {
  const Report report = sample_report();
  EXPECT_EQ(outcome(report, report), "0 new, 0 worse, 5 unchanged, 0 gone");
  EXPECT_EQ(outcome(report, Report()), "0 new, 0 worse, 0 unchanged, 5 gone");
  EXPECT_EQ(outcome(Report(), report), "5 new, 0 worse, 0 unchanged, 0 gone");
}

TEST(Baseline, WorseIsMoreThanAHundredthOfTheContactDistance) {
  EXPECT_EQ(compared(one_node(10, 0.3), one_node(10, 0.309)).states, std::vector{unchanged});
  EXPECT_EQ(compared(one_node(10, 0.3), one_node(10, 0.311)).states, std::vector{worse});
  EXPECT_EQ(compared(one_node(10, 0.3), one_node(10, 0.1)).states, std::vector{unchanged});
}

TEST(Baseline, AGraverDegreeIsWorse) {
  using enum PenetrationKind;
  EXPECT_EQ(compared(one_node(10, 0.3, initial), one_node(10, 0.3, released)).states, std::vector{worse});
  EXPECT_EQ(compared(one_node(10, 0.3, edge_zone), one_node(10, 0.3, initial)).states, std::vector{worse});
  EXPECT_EQ(compared(one_node(10, 0.3, released), one_node(10, 0.4, initial)).states, std::vector{unchanged});
  EXPECT_EQ(outcome(one_node(10, 0.3, mortar), one_node(10, 0.3, initial)), "1 new, 0 worse, 0 unchanged, 1 gone");
}

TEST(Baseline, AMovedNodeIsTheSameUpToHalfTheContactDistance) {
  EXPECT_EQ(outcome(one_node(10, 0.3), one_node(10.49, 0.3)), "0 new, 0 worse, 1 unchanged, 0 gone");
  EXPECT_EQ(outcome(one_node(10, 0.3), one_node(10.51, 0.3)), "1 new, 0 worse, 0 unchanged, 1 gone");
}

TEST(Baseline, EachKnownFindingAnswersForOne) {
  Report two = one_node(10, 0.3);
  two.penetrations.push_back(two.penetrations[0]);
  two.penetrations[1].node = 6;  // in the same place
  two.penetrations[1].depth = 0.2;
  EXPECT_EQ(outcome(one_node(10, 0.3), two), "1 new, 0 worse, 1 unchanged, 0 gone");
  EXPECT_EQ(outcome(two, two), "0 new, 0 worse, 2 unchanged, 0 gone");
}

TEST(Baseline, TheNearestBelongTogether) {
  // A row of nodes that moves by less than half its pitch: node by node the same ones.
  Report before = one_node(0, 0.1), after = before;
  before.penetrations.clear();
  after.penetrations.clear();
  for (int i = 0; i < 200; ++i) {
    before.penetrations.push_back(one_node(0.25 * i, 0.001 * i).penetrations[0]);
    after.penetrations.push_back(one_node(0.25 * i + 0.11, 0.001 * i + (i == 77 ? 0.02 : 0)).penetrations[0]);
  }
  std::shuffle(after.penetrations.begin(), after.penetrations.end(), std::mt19937(5));
  const BaselineComparison comparison = compared(before, after);
  EXPECT_EQ(summary(comparison), "0 new, 1 worse, 199 unchanged, 0 gone");
  const auto at = std::find(comparison.states.begin(), comparison.states.end(), worse) - comparison.states.begin();
  EXPECT_NEAR(after.penetrations[static_cast<std::size_t>(at)].original.x(), 0.25 * 77 + 0.11, 1e-9);
}

TEST(Baseline, AnotherContactIsAnotherFinding) {
  Report other = one_node(10, 0.3);
  other.contacts[0].id = 8;
  EXPECT_EQ(outcome(one_node(10, 0.3), other), "1 new, 0 worse, 0 unchanged, 1 gone");
}

TEST(Baseline, WordsWithoutNumbersWhereThereIsNoPosition) {
  Report before, after;
  before.findings.push_back(
      make_finding("GC501", "duplicate-id", "node 12 is defined again (first in line 40 of a.k)"));
  after.findings.push_back(
      make_finding("GC501", "duplicate-id", "node 9012 is defined again (first in line 3 of a.k)"));
  EXPECT_EQ(outcome(before, after), "0 new, 0 worse, 1 unchanged, 0 gone");
  after.findings.push_back(after.findings[0]);
  EXPECT_EQ(outcome(before, after), "1 new, 0 worse, 1 unchanged, 0 gone");
  after.findings[1].message = "part 3 is defined again";
  EXPECT_EQ(outcome(before, after), "1 new, 0 worse, 1 unchanged, 0 gone");
}

TEST(Baseline, ThePathOfTheDeckIsNoPartOfWords) {
  Report before, after;
  before.findings.push_back(
      make_finding("GC501", "duplicate-id", "node 12 is defined again (first in line 40 of V/a.k)"));
  after.findings.push_back(
      make_finding("GC501", "duplicate-id", "node 12 is defined again (first in line 3 of /w/a.k)"));
  EXPECT_EQ(outcome(before, after), "0 new, 0 worse, 1 unchanged, 0 gone");
  EXPECT_EQ(baseline_text(known_findings(before)), baseline_text(known_findings(after)));
  const auto earlier = read_baseline(
      "{\"schema\":\"gapcheck-baseline/1\"}\n{\"id\":\"GC501\",\"rule\":\"duplicate-id\","
      "\"severity\":\"error\",\"message\":\"node 12 is defined again (first in line "
      "of V/a.k)\"}\n",
      "b");
  ASSERT_TRUE(earlier.ok());
  EXPECT_EQ(summary(compare_with_baseline(after, earlier.value(), all)), "0 new, 0 worse, 1 unchanged, 0 gone");
}

TEST(Baseline, OfListsThatCountTheRestOnlyTheTotalSays) {
  const auto listing = [](int first, int last, std::uint64_t rest) {
    Report report;
    for (int i = first; i < last; ++i) {
      report.findings.push_back(make_finding("GC506", "sliver-segment", fmt::format("shell {}", i)));
      report.findings.back().point = Vector(100.0 * i, 0, 0);
    }
    report.findings.push_back(make_finding("GC506", "sliver-segment", fmt::format("{} more", rest)));
    report.findings.back().count = rest;
    return report;
  };
  EXPECT_EQ(outcome(listing(0, 10, 90), listing(5, 15, 90)), "0 new, 0 worse, 11 unchanged, 0 gone");
  EXPECT_EQ(outcome(listing(0, 10, 90), listing(5, 15, 92)), "2 new, 1 worse, 8 unchanged, 2 gone");
}

TEST(Baseline, TheTextIsTheSameForAnyOrder) {
  Report report = random_report(500, 3, 4);
  const std::string text = baseline_text(known_findings(report));
  auto known = known_findings(report);
  std::shuffle(known.begin(), known.end(), std::mt19937(1));
  EXPECT_EQ(baseline_text(known), text);
  const auto read = read_baseline(text, "b");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(baseline_text(read.value()), text);  // nothing is lost on the way
}

TEST(Baseline, HostileFilesAreErrorsWithALine) {
  const std::string head = "{\"schema\":\"gapcheck-baseline/1\"}\n";
  const std::string good = "{\"id\":\"GC101\",\"rule\":\"r\",\"severity\":\"note\",\"position\":[0,0,0]}\n";
  EXPECT_TRUE(read_baseline(head + good, "b").ok());
  EXPECT_TRUE(read_baseline(head, "b").ok());
  const std::vector<std::pair<std::string, std::uint32_t>> bad{
      {"", 0},
      {"\n", 1},
      {"{\"schema\":\"gapcheck-baseline/2\"}\n", 1},
      {"[1]\n", 1},
      {head + good + "{\n", 3},
      {head + "[]\n", 2},
      {head + std::string(100000, '[') + "\n", 2},
      {head + std::string(2000000, ' ') + "\n", 2},
      {head + "{\"id\":1,\"rule\":\"r\",\"severity\":\"note\",\"position\":[0,0,0]}\n", 2},
      {head + "{\"id\":\"GC101\",\"rule\":\"r\",\"severity\":\"bad\",\"position\":[0,0,0]}\n", 2},
      {head + "{\"id\":\"GC101\",\"rule\":\"r\",\"severity\":\"note\"}\n", 2},
      {head + "{\"id\":\"GC101\",\"rule\":\"r\",\"severity\":\"note\",\"position\":[0,0]}\n", 2},
      {head + "{\"id\":\"GC101\",\"rule\":\"r\",\"severity\":\"note\",\"position\":[0,0,1e999]}\n", 2},
      {head + "{\"id\":\"GC101\",\"rule\":\"r\",\"severity\":\"note\",\"position\":[0,0,0],\"penetration\":-1}\n", 2},
      {head + "{\"id\":\"GC101\",\"rule\":\"r\",\"severity\":\"note\",\"position\":[0,0,0],\"contact\":1.5}\n", 2},
      {head + "{\"id\":\"GC101\",\"rule\":\"r\",\"severity\":\"note\",\"position\":[0,0,0],\"count\":-4}\n", 2},
      {head + "{\"id\":\"GC101\",\"rule\":\"r\",\"severity\":\"note\",\"message\":\"\xff\"}\n", 2},
  };
  for (const auto& [text, line] : bad) {
    const auto read = read_baseline(text, "b");
    ASSERT_FALSE(read.ok()) << text.substr(0, 200);
    EXPECT_EQ(read.error().line, line) << text.substr(0, 200);
    EXPECT_EQ(read.error().file, "b");
  }
}

TEST(Baseline, AnyNumberIsFine) {
  Report report = one_node(1e300, 1e-320);
  report.penetrations[0].contact_distance = 1e300;
  for (const double x : {-1e300, 5e-324, -0.0, HUGE_VAL, std::nan("")}) {
    report.penetrations.push_back(one_node(x, x).penetrations[0]);
    report.penetrations.back().contact_distance = x;
  }
  EXPECT_EQ(outcome(report, report), "0 new, 0 worse, 6 unchanged, 0 gone");
}

TEST(Baseline, ManyInOnePlaceTakeNoTime) {
  Report before = one_node(0, 0.1), after = before;
  before.penetrations.assign(20000, before.penetrations[0]);
  after.penetrations.assign(20000, one_node(0.1, 0.1).penetrations[0]);
  const BaselineComparison comparison = compared(before, after);
  EXPECT_EQ(comparison.states.size(), 20000U);
  EXPECT_GT(comparison.count(unchanged), 0U);
  EXPECT_EQ(comparison.count(unchanged) + comparison.count(fresh), 20000U);
  EXPECT_EQ(comparison.count(fresh), comparison.gone.size()) << "what has no partner here has none there";
}

TEST(Baseline, FormatsSayIt) {
  const Report before = one_node(10, 0.3);
  Report now = sample_report();  // contact 7: three nodes; two findings
  now.penetrations.push_back(now.penetrations[2]);
  now.penetrations[3].original = {10, 0, 0};
  now.penetrations[3].depth = 0.3;
  const auto written = [&](const auto& write) {
    std::string text;
    write([&text](std::string_view piece) { return text += piece, true; });
    return text;
  };
  now.baseline = compared(before, now);
  ASSERT_EQ(now.baseline->states, (std::vector{fresh, fresh, fresh, unchanged, fresh, fresh}));
  now.baseline->gone = known_findings(before);
  const auto json_report = nlohmann::json::parse(json(now));
  EXPECT_EQ(json_report["summary"]["baseline"], nlohmann::json::parse(R"({"new":5,"worse":0,"unchanged":1,"gone":1})"));
  EXPECT_EQ(json_report["findings"][3]["baseline"], "unchanged");
  EXPECT_EQ(json_report["gone"][0]["id"], "GC101");
  const auto log = nlohmann::json::parse(written([&](const Sink& sink) { sarif(now, "1", {}, sink); }));
  const auto& results = log["runs"][0]["results"];
  ASSERT_EQ(results.size(), 7U);
  EXPECT_EQ(results[0]["baselineState"], "new");
  EXPECT_EQ(results[3]["baselineState"], "unchanged");
  EXPECT_EQ(results[6]["baselineState"], "absent");
  EXPECT_EQ(nlohmann::json::parse(written([&](const Sink& sink) { gitlab(now, sink); })).size(), 5U);
  const std::string annotations = written([&](const Sink& sink) { github(now, 100, sink); });
  EXPECT_EQ(std::count(annotations.begin(), annotations.end(), '\n'), 6);
  EXPECT_NE(annotations.find("1 findings that the baseline knows"), annotations.npos);
  EXPECT_NE(written([&](const Sink& sink) { csv(now, sink); }).find(",unchanged\r\n"), std::string::npos);
  EXPECT_NE(text(now, {}).find("against the baseline: 5 new, 0 worse, 1 unchanged, 1 gone"), std::string::npos);
  EXPECT_EQ(totals(now).warnings, 2U);
  EXPECT_EQ(counting_totals(now).warnings, 1U);
}

TEST(Baseline, LinesThatCountAreToldApartByWhatTheyCount) {
  const auto parts = [](std::vector<std::uint64_t> counts) {
    Report report = one_node(10, 0.3);
    for (const std::uint64_t count : counts) {
      Finding f = make_finding("GC302", "thickness-limited", fmt::format("part 7: {} elements", count));
      f.contact = 7;
      f.count = count;
      f.point = Vector(static_cast<double>(report.findings.size()), 0, 0);
      report.findings.push_back(f);
    }
    return report;
  };
  EXPECT_EQ(outcome(parts({72, 6, 4}), parts({4, 72, 6})), "0 new, 0 worse, 4 unchanged, 0 gone");
  EXPECT_EQ(outcome(parts({72, 6, 4}), parts({4, 73, 6})), "0 new, 1 worse, 3 unchanged, 0 gone");
  EXPECT_EQ(outcome(parts({72, 6, 4}), parts({5, 71, 6})), "0 new, 1 worse, 3 unchanged, 0 gone");
}

TEST(Baseline, WhatIsIgnoredIsNeitherGoneNorNew) {
  const Report before = one_node(10, 0.3);
  Report now = before;
  now.ignored.penetrations.swap(now.penetrations);
  now.ignored.source = {0};
  now.ignored.sources = {{"deck.k", 3, "", true, 1}};
  const BaselineComparison comparison = compared(before, now);
  EXPECT_EQ(summary(comparison), "0 new, 0 worse, 0 unchanged, 0 gone");
  EXPECT_EQ(comparison.ignored_states, std::vector{unchanged});
  EXPECT_EQ(outcome(Report(), now), "0 new, 0 worse, 0 unchanged, 0 gone");
  EXPECT_TRUE(known_findings(now).empty()) << "it is not written";
}

TEST(Baseline, IgnoredFindingsTakeNothingFromOthers) {
  // Two nodes in one place, the deeper one ignored; and in another place one that nothing hides.
  Report now = one_node(10, 0.3);
  now.ignored.penetrations = one_node(10, 0.4).penetrations;
  now.ignored.source = {0};
  now.ignored.sources = {{"deck.k", 3, "", true, 1}};
  EXPECT_EQ(outcome(now, now), "0 new, 0 worse, 1 unchanged, 0 gone");
  Report before = now;
  before.penetrations.push_back(before.ignored.penetrations[0]);
  before.ignored = {};
  EXPECT_EQ(compared(before, now).states, std::vector{unchanged}) << "the deeper entry is the shown one's";
  EXPECT_EQ(outcome(before, now), "0 new, 0 worse, 1 unchanged, 0 gone");
  // Moved with its plate, nearer to where the other one was.
  Report moved = now;
  moved.penetrations[0].original = {10.2, 0, 0};
  moved.ignored.penetrations[0].original = {10.1, 0, 0};
  EXPECT_EQ(outcome(now, moved), "0 new, 0 worse, 1 unchanged, 0 gone");
  // In the very place of a known one: a new neighbour is not taken for it.
  moved.ignored.penetrations[0].original = {10, 0, 0};
  EXPECT_EQ(outcome(now, moved), "1 new, 0 worse, 0 unchanged, 0 gone");
}

TEST(Baseline, IgnoredFindingsTakeNoWordsAndTotalsFromOthers) {
  const auto listing = [](int first, std::uint64_t rest) {
    Report report;
    for (int i = first; i < first + 6; ++i) {
      report.findings.push_back(make_finding("GC506", "sliver-segment", fmt::format("shell {}", i)));
      report.findings.back().point = Vector(100.0 * i, 0, 0);
    }
    report.findings.push_back(make_finding("GC506", "sliver-segment", fmt::format("{} more", rest)));
    report.findings.back().count = rest;
    report.findings.push_back(make_finding("GC501", "duplicate-id", fmt::format("node {} again", first)));
    report.ignored.sources = {{"deck.k", 3, "", true, 2}};
    report.ignored.source = {0, 0};
    report.ignored.findings = {report.findings[0], report.findings[7]};
    report.ignored.findings[1].message = fmt::format("node {} again", first - 1);
    report.findings.erase(report.findings.begin());
    return report;
  };
  EXPECT_EQ(outcome(listing(0, 90), listing(0, 90)), "0 new, 0 worse, 7 unchanged, 0 gone");
  EXPECT_EQ(outcome(listing(0, 90), listing(20, 90)), "0 new, 0 worse, 7 unchanged, 0 gone");
  EXPECT_EQ(outcome(listing(0, 90), listing(20, 91)), "1 new, 1 worse, 5 unchanged, 1 gone");
}

TEST(Baseline, WhatIsGoneHasTheFingerprintThatItHad) {
  Report before = sample_report();
  before.tie_failures = {TieFailure{.node = 5, .position = Vector(1234.5678, 2, 3)}};
  Report now = Report();
  now.baseline = compared(before, now);
  ASSERT_EQ(now.baseline->gone.size(), 6U);
  const auto prints = [](const Report& report) {
    std::string text;
    sarif(report, "1", {}, [&text](std::string_view piece) { return text += piece, true; });
    const auto log = nlohmann::json::parse(text);
    std::vector<std::string> list;
    for (const auto& result : log["runs"][0]["results"]) list.push_back(result["partialFingerprints"]["gapcheck/v1"]);
    std::sort(list.begin(), list.end());
    return list;
  };
  EXPECT_EQ(prints(now), prints(before));
}

Report one_tie(double x, double segment_size, double far = 0) {
  Report report;
  report.source = "deck";
  report.contacts.push_back(make_contact(7, 1, "CONTACT_TIED_NODES_TO_SURFACE", "6", 50, 32));
  report.tie_failures = {TieFailure{.node = 5, .segment_size = segment_size, .position = Vector(x, 0, 0)}};
  if (far > 0) report.tie_failures.push_back({.node = 6, .segment_size = segment_size, .position = Vector(far, 0, 0)});
  return report;
}

TEST(Baseline, AMovedTieIsTheSameUpToATenthOfItsSegment) {
  const auto moved = [](double to, double size) { return outcome(one_tie(10, size, 10000), one_tie(to, size, 10000)); };
  EXPECT_EQ(moved(10.49, 5), "0 new, 0 worse, 2 unchanged, 0 gone");
  EXPECT_EQ(moved(10.51, 5), "1 new, 0 worse, 1 unchanged, 1 gone") << "a model of ten metres does not widen it";
  EXPECT_EQ(moved(15, -1), "0 new, 0 worse, 2 unchanged, 0 gone") << "a thousandth of the diagonal";
}

TEST(Baseline, VeryDifferentContactDistancesInOneCrowdTakeNoTime) {
  const auto crowd = [](double shift) {
    Report report = one_node(5000, 0.3);
    report.penetrations[0].contact_distance = 1e6;
    for (int i = 0; i < 50'000; ++i) {
      Penetration p = report.penetrations[0];
      p.original = {0.1 * (i % 250) + shift, 0.1 * (i / 250), 0};
      p.contact_distance = 0.05;
      p.depth = 0.01;
      report.penetrations.push_back(p);
    }
    return report;
  };
  EXPECT_EQ(outcome(crowd(0), crowd(0.02)), "0 new, 0 worse, 50001 unchanged, 0 gone");
}

TEST(Baseline, KnownFindingsPassInJunit) {
  Report report = sample_report();
  report.baseline = compared(report, report);
  const Severity limit = Severity::note;
  std::string text;
  junit(report, &limit, 5, [&text](std::string_view piece) { return text += piece, true; });
  EXPECT_EQ(text.find("<failure"), text.npos);
  EXPECT_NE(text.find("known from the baseline"), text.npos);
  report.baseline->states[0] = worse;
  text.clear();
  junit(report, &limit, 5, [&text](std::string_view piece) { return text += piece, true; });
  EXPECT_NE(text.find("<failure message=\"1 found\""), text.npos);
}

}  // namespace
}  // namespace gapcheck::report::baseline_test
