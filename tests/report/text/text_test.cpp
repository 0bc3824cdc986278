#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>
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

TEST(Text, ShortReport) {
  const std::string expected = R"(plates.k
  50 nodes, 32 shells, 2 parts, 2 contacts

If this deck runs:
  The contact lets go of the nodes: they pass through freely (1 node in contact 7, GC102)
  The solver moves the nodes out, or starts with a force on them (1 node in contact 7, GC101)

errors
  GC102 released-node: contact 7: part 1 in part 2: 1 node, deepest 0.9 of 1, node 14 in element 500  mesh.k:1234
  GC501 duplicate-id: node 12 is defined again  mesh.k:40
  GC503 empty-surface: contact 2: SURFB has no segments
warnings
  GC101 initial-penetration: contact 7: in part 2: 1 node, deepest 0.3 of 1, node 16 in element 500
notes
  GC106 edge-zone-penetration: contact 7: part 1 in part 2: 1 node, deepest 0.6 of 1, node 15  mesh.k:1234

contact 7 "plates" (13): 50 tracked nodes, 32 segments: 1 penetration, 1 released node, deepest 0.9 at node 14, 1 node in the edge zone
contact 2 (a3): not judged: SOFT = 2 is checked segment by segment

by rule
  GC102 released-node 1, GC501 duplicate-id 1, GC503 empty-surface 1, GC101 initial-penetration 1,
  GC106 edge-zone-penetration 1

plates.k: 3 errors, 1 warning, 1 note in 2 contacts, 1 not judged
)";
  EXPECT_EQ(text(sample_report(), {}), expected);
}

TEST(Text, AllOfIt) {
  const std::string expected = R"(
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
  not judged: SOFT = 2 is checked segment by segment

total  1 penetration, 1 released node, 1 node in the edge zone; deepest 0.9
)";
  const std::string all = text(sample_report(), {.all = true});
  EXPECT_NE(all.find(expected), std::string::npos) << all;
}

TEST(Text, TopLimitsTheTablesAndListDoesNot) {
  const Report report = random_report(500, 1, 4);
  static const std::regex row(R"( (face|edge|corner) +(moved|kept|forced|released|reported|not listed|-))");
  const auto listed = [&](const TextOptions& options) {
    const std::string all = text(report, options);
    return std::distance(std::sregex_iterator(all.begin(), all.end(), row), std::sregex_iterator());
  };
  EXPECT_EQ(listed({.top = 5, .all = true}), 15);  // five penetrating nodes, five edges, five nodes in the edge zone
  EXPECT_EQ(listed({.top = 0, .all = true}), 0);
  EXPECT_EQ(listed({.top = 1'000'000, .all = true}), 500);
  EXPECT_EQ(listed({.list = true}), 500);
}

TEST(Text, QuietIsTheLastLine) {
  const Report report = sample_report();
  EXPECT_EQ(text(report, {.quiet = true}), "plates.k: 3 errors, 1 warning, 1 note in 2 contacts, 1 not judged\n");
  EXPECT_EQ(last_line(text(report, {})) + '\n', text(report, {.quiet = true}));
}

TEST(Text, CleanDeck) {
  Report report = sample_report();
  report.penetrations.clear();
  report.findings.clear();
  EXPECT_EQ(text(report, {.quiet = true}), "plates.k: nothing found in 2 contacts, 1 not judged\n");
  EXPECT_EQ(lines_with(text(report, {}), "no penetrations"), 1u);
}

TEST(Text, JudgedTiesAreNotUnchecked) {
  Report report = sample_report();
  report.penetrations.clear();
  report.findings.clear();
  report.contacts[1].not_checked.clear();
  report.contacts[1].ties_judged = true;
  const std::string tied = text(report, {});
  EXPECT_EQ(tied.find("not judged"), std::string::npos) << tied;
  EXPECT_NE(tied.find(": 4 tracked nodes, 1 segment: 0 nodes tied\n"), std::string::npos) << tied;
}

TEST(Text, FindingsOfARuleInOneLine) {
  Report report = sample_report();
  report.findings.assign(13, report.findings[0]);
  EXPECT_EQ(lines_with(text(report, {}), "is defined again (and 12 more)"), 1u);
  EXPECT_EQ(lines_with(text(report, {}), "is defined again"), 1u);
  EXPECT_EQ(lines_with(text(report, {.list = true}), ": node 12 is defined again"), 14u);
}

/// Reports with many rules, contacts and pairs of parts.
Report crowded_report(unsigned seed) {
  Report report = random_report(3000, 60, seed);
  std::mt19937 random(seed);
  for (Penetration& record : report.penetrations) record.part = random() % 100, record.element_part = random() % 100;
  for (int i = 0; i < 500; ++i) {
    Finding finding = make_finding("GC" + std::to_string(400 + random() % 80), "rule-" + std::to_string(random() % 80),
                                   "something is wrong");
    finding.rule = "rule-of-" + finding.id;
    finding.severity = static_cast<Severity>(random() % 3);
    finding.contact = static_cast<std::int64_t>(random() % 60);
    finding.part = static_cast<std::int64_t>(random() % 20);
    finding.consequence = "Something goes wrong";
    report.findings.push_back(std::move(finding));
  }
  return report;
}

TEST(Text, FortyLinesForAnyDeck) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Report report = crowded_report(seed);
    for (const GroupBy by : {GroupBy::severity, GroupBy::rule, GroupBy::contact, GroupBy::part, GroupBy::file}) {
      const std::string all = text(report, {.group_by = by});
      EXPECT_LE(lines_with(all, ""), 40u) << all;
      EXPECT_GE(lines_with(all, ""), 35u) << all;  // the room is used
    }
  }
}

TEST(Text, LinesOfTheShortReportCountEverything) {
  const Report report = crowded_report(7);
  const std::string all = text(report, {});
  std::size_t sum = 0;
  // Each line: its own number and "and N more like this".
  static const std::regex more(R"(and (\d+) more like this)"), rest(R"(… and (\d+) more \(--all\))"),
      nodes(R"(: (\d+) (?:node|edge)s?, deepest)"), others(R"(something is wrong(?: \(and (\d+) more\))?)");
  const std::string findings = all.substr(all.find("\nerrors\n"), all.find("\ncontact ") - all.find("\nerrors\n"));
  const auto add = [&](const std::regex& pattern, std::size_t each) {
    for (std::sregex_iterator match(findings.begin(), findings.end(), pattern), end; match != end; ++match)
      sum += each + ((*match)[1].matched ? std::stoul((*match)[1]) : 0);
  };
  add(more, 0), add(rest, 0), add(nodes, 0), add(others, 1);
  EXPECT_EQ(sum, 3500u) << all;
}

TEST(Text, ATerminalsWidthIsRespected) {
  Report report = sample_report();
  report.contacts[0].title = std::string(90, 'x');
  report.findings[0].message = std::string(300, 'y');
  const std::string all = text(report, {.width = 100});
  std::istringstream stream(all);
  for (std::string line; std::getline(stream, line);)
    EXPECT_LE(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }), 100) << line;
  EXPECT_EQ(lines_with(all, "xxx…"), 1u) << all;
  EXPECT_EQ(lines_with(all, "yyy…  mesh.k:40"), 1u) << all;  // the place is kept
}

TEST(Text, TopIsAlsoABoundForTheLinesOfARule) {
  const Report report = crowded_report(3);
  EXPECT_EQ(lines_with(text(report, {.per_rule = 1}), "GC102 released-node: "), 1u);
  EXPECT_GT(lines_with(text(report, {.all = true}), "GC102 released-node: "), 100u);
}

TEST(Text, KnownFindingsAreCountedAndNotPrinted) {
  Report report = sample_report();
  report.baseline.emplace().states = {BaselineState::unchanged, BaselineState::fresh, BaselineState::unchanged,
                                      BaselineState::unchanged, BaselineState::unchanged};
  const std::string all = text(report, {});
  EXPECT_EQ(lines_with(all, "released-node: "), 0u) << all;
  EXPECT_EQ(lines_with(all, "  GC106 edge-zone-penetration: contact 7"), 1u) << all;
  EXPECT_EQ(lines_with(all, "4 unchanged"), 2u) << all;
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

TEST(Text, PortabilityOnDemandOnly) {
  Report report = sample_report();
  EXPECT_EQ(lines_with(text(report, {}), "portability"), 0u);
  report.portability = Portability{{"A program", "Another"}, {}};
  EXPECT_EQ(lines_with(text(report, {}),
                       "portability: by its documents, A program, Another reads all keywords, options and fields"),
            1u);
  report.portability->notes = {{"A program", PortabilityKind::keyword, false, "CONTACT_X", 1, "a.k", 3, "https://a"},
                               {"A program", PortabilityKind::option, false, "MPP", 2, "b\x1b.k", 4, "https://a"},
                               {"Another", PortabilityKind::field, true, "SOFT", 3, "", 0, "https://b"}};
  const std::string all = text(report, {});
  EXPECT_NE(all.find("\nportability: contact input that other programs do not read, according to their documents\n"
                     "  A program\n"
                     "    *CONTACT_X: not read, 1 contact, at a.k:3\n"
                     "    option MPP: not read, 2 contacts, first at b?.k:4\n"
                     "  Another\n"
                     "    SOFT: read, but as something else, 3 contacts\n"),
            std::string::npos)
      << all;
  EXPECT_EQ(lines_with(text(report, {.quiet = true}), "portability"), 0u);
  report.contacts.clear(), report.penetrations.clear(), report.tie_failures.clear();
  report.portability->notes.clear();
  EXPECT_EQ(lines_with(text(report, {}), "portability: there are no contacts to compare"), 1u);
}

TEST(Text, ManyPortabilityNotesAreCut) {
  Report report = sample_report();
  report.portability = Portability{{"A program"}, {}};
  for (int i = 0; i < 50; ++i)
    report.portability->notes.push_back(
        {"A program", PortabilityKind::field, false, "F" + std::to_string(i), 1, "a.k", 1, "https://a"});
  EXPECT_EQ(lines_with(text(report, {}), ": not read, 1 contact"), 20u);
  EXPECT_EQ(lines_with(text(report, {}), "… and 30 more; --all shows them"), 1u);
  EXPECT_EQ(lines_with(text(report, {.all = true}), ": not read, 1 contact"), 50u);
}

TEST(Text, ManyPartPairsAreCut) {
  Report report = random_report(100, 1, 5);
  for (std::size_t i = 0; i < 100; ++i) {
    report.penetrations[i].part = static_cast<std::int64_t>(i) + 1;
    report.penetrations[i].kind = PenetrationKind::initial;
  }
  EXPECT_EQ(lines_with(text(report, {.all = true}), "… and 80 more"), 1u);
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
