#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <regex>
#include <sstream>

#include "report/sample.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::report::text_test {
namespace {

std::size_t lines_with(const std::string& text, const std::string& part) {
  std::istringstream stream(text);
  std::size_t count = 0;
  for (std::string line; std::getline(stream, line);) count += line.find(part) != std::string::npos;
  return count;
}

std::string last_line(const std::string& text) {
  const auto end = text.find_last_not_of('\n');
  const auto start = text.rfind('\n', end);
  return text.substr(start == std::string::npos ? 0 : start + 1, end - start);
}

TEST(Text, WholeReport) {
  const std::string expected = R"(plates.k
  50 nodes, 32 shells, 2 parts, 2 contacts

contact 7 "plates"  type 13  CONTACT_AUTOMATIC_SINGLE_SURFACE  plates.k:34
  50 tracked nodes, 32 segments: 1 penetration, 1 released node, deepest 0.9 at node 14, 1 node in the edge zone

  penetrating nodes
    node  part  element  part  penetration  remaining  distance  ratio       s       t  feature  outcome   moved to
      14     1      500     2          0.9        0.1         1  0.900  -0.240  -0.080  face     released
      16     -      500     2          0.3        0.7         1  0.300  -0.240  -0.080  face     moved     12 20 1.0006

  by part
    part of node  part of segment  nodes  deepest  distance  thickness from
               1                2      1      0.9         1  SST/MST
               -                2      1      0.3         1  node: SST/MST, segment: OPTT of *PART_CONTACT

  nodes in the edge zone
    node  part                  element  part  penetration  remaining  distance  ratio      s       t  feature  outcome     moved to
      15     1  22124-22164-22165-22125     2          0.6        0.4         1  0.600  1.000  -0.080  edge     not listed

contact 2  type a3  CONTACT_AUTOMATIC_SURFACE_TO_SURFACE
  not checked: SOFT = 2 is checked segment by segment

GC501 duplicate-id 1 error
  mesh.k:40: node 12 is defined again

GC503 empty-surface 1 error
  contact 2: SURFB has no segments

total  1 penetration, 1 released node, 1 node in the edge zone; deepest 0.9

plates.k: 3 errors, 1 warning, 1 note in 2 contacts, 1 not checked
)";
  EXPECT_EQ(text(sample_report(), {}), expected);
}

TEST(Text, TopLimitsTheTablesAndListDoesNot) {
  const Report report = random_report(500, 1, 4);
  static const std::regex row(R"( (face|edge|corner) +(moved|kept|forced|released|reported|not listed|-))");
  const auto listed = [&](const TextOptions& options) {
    const std::string all = text(report, options);
    return std::distance(std::sregex_iterator(all.begin(), all.end(), row), std::sregex_iterator());
  };
  EXPECT_EQ(listed({.top = 5}), 15);  // five penetrating nodes, five edges, five nodes in the edge zone
  EXPECT_EQ(listed({.top = 0}), 0);
  EXPECT_EQ(listed({.top = 1'000'000}), 500);
  EXPECT_EQ(listed({.list = true}), 500);
}

TEST(Text, QuietIsTheLastLine) {
  const Report report = sample_report();
  EXPECT_EQ(text(report, {.quiet = true}), "plates.k: 3 errors, 1 warning, 1 note in 2 contacts, 1 not checked\n");
  EXPECT_EQ(last_line(text(report, {})) + '\n', text(report, {.quiet = true}));
}

TEST(Text, CleanDeck) {
  Report report = sample_report();
  report.penetrations.clear();
  report.findings.clear();
  EXPECT_EQ(text(report, {.quiet = true}), "plates.k: nothing found in 2 contacts, 1 not checked\n");
  EXPECT_EQ(lines_with(text(report, {}), "no penetrations"), 1u);
}

TEST(Text, JudgedTiesAreNotUnchecked) {
  Report report = sample_report();
  report.penetrations.clear();
  report.findings.clear();
  report.contacts[1].not_checked.clear();
  report.contacts[1].ties_judged = true;
  const std::string tied = text(report, {});
  EXPECT_EQ(tied.find("not checked"), std::string::npos) << tied;
  EXPECT_NE(tied.find("\n  0 nodes tied\n"), std::string::npos) << tied;
}

TEST(Text, TenFindingsOfARuleInFull) {
  Report report = sample_report();
  report.findings.assign(13, report.findings[0]);
  EXPECT_EQ(lines_with(text(report, {}), "is defined again"), 10u);
  EXPECT_EQ(lines_with(text(report, {}), "… and 3 more"), 1u);
  EXPECT_EQ(lines_with(text(report, {.list = true}), "is defined again"), 13u);
}

TEST(Text, ColourAddsNothingButEscapes) {
  const Report report = sample_report();
  std::string colored = text(report, {.color = true});
  EXPECT_NE(colored, text(report, {}));
  for (auto start = colored.find('\x1b'); start != std::string::npos; start = colored.find('\x1b'))
    colored.erase(start, colored.find('m', start) + 1 - start);
  EXPECT_EQ(colored, text(report, {}));
}

TEST(Text, ControlCharactersOfTheDeckDoNotReachTheTerminal) {
  Report report = sample_report();
  report.input = "a\x1b[2J.k";
  report.contacts[0].title = "b\x1b]0;x\x07";
  report.contacts[1].not_checked = "c\r\n";
  report.findings[0].message = "d\x7f";
  const std::string all = text(report, {.stats = true});
  EXPECT_TRUE(
      std::none_of(all.begin(), all.end(), [](char c) { return (c >= 0 && c < 0x20 && c != '\n') || c == 0x7f; }));
}

TEST(Text, StatisticsOnlyOnDemand) {
  Report report = sample_report();
  report.statistics = {{"decided by the filter", "1234"}};
  EXPECT_EQ(lines_with(text(report, {}), "decided by the filter"), 0u);
  EXPECT_EQ(lines_with(text(report, {.stats = true}), "decided by the filter  1234"), 1u);
}

TEST(Text, ManyPartPairsAreCut) {
  Report report = random_report(100, 1, 5);
  for (std::size_t i = 0; i < 100; ++i) {
    report.penetrations[i].part = static_cast<std::int64_t>(i) + 1;
    report.penetrations[i].kind = PenetrationKind::initial;
  }
  EXPECT_EQ(lines_with(text(report, {}), "… and 80 more"), 1u);
}

TEST(Totals, CountEveryRecordAndFinding) {
  const Totals sum = totals(random_report(1000, 2, 6));
  EXPECT_EQ(sum.errors + sum.warnings + sum.notes, 1000u);
  const Totals sample = totals(sample_report());
  EXPECT_EQ(sample.errors, 3u);
  EXPECT_EQ(sample.warnings, 1u);
  EXPECT_EQ(sample.notes, 1u);
}

}  // namespace
}  // namespace gapcheck::report::text_test
