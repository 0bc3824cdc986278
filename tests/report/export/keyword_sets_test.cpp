#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "report/export/exports.hpp"
#include "report/item/describe.hpp"
#include "report/sample.hpp"

namespace gapcheck::report::keyword_sets_test {
namespace {

using Segment = std::array<std::int64_t, 4>;

/// A set as gapcheck's own rooms read it.
struct ReadSet {
  std::string title;
  std::set<std::int64_t> nodes;
  std::set<Segment> segments;
};

/// The file behind a deck that defines all its nodes: node and segment sets by id.
std::map<std::int64_t, std::array<ReadSet, 2>> read_back(const std::string& text, const std::set<std::int64_t>& nodes) {
  std::string deck = "*KEYWORD LONG=Y\n*NODE\n";
  for (const std::int64_t id : nodes) {
    const std::string number = std::to_string(id);
    deck += std::string(20 - number.size(), ' ') + number + "\n";
  }
  Diagnostics diagnostics;
  const auto parsed = keyword::read_deck_text(deck + text, "sets.k", {}, diagnostics);
  EXPECT_TRUE(parsed.ok());
  const auto model = model::read_model(parsed.value(), diagnostics);
  for (const Diagnostic& diagnostic : diagnostics.sorted())
    ADD_FAILURE() << diagnostic.line << ": " << diagnostic.message;
  EXPECT_TRUE(model.ok());
  for (const model::Fault& fault : model.value().faults) ADD_FAILURE() << fault.message;
  const auto& id = model.value().mesh.nodes.id;
  std::map<std::int64_t, std::array<ReadSet, 2>> sets;
  for (const auto& [key, set] : model.value().sets.nodes) {
    ReadSet& read = sets[key][0];
    read.title = set.title;
    for (const NodeIndex node : set.members) read.nodes.insert(id[node.value]);
    EXPECT_EQ(read.nodes.size(), set.members.size());
  }
  for (const auto& [key, set] : model.value().sets.segments) {
    ReadSet& read = sets[key][1];
    read.title = set.title;
    for (const model::SegmentNodes& nodes_of : set.members) {
      Segment segment{};
      for (std::size_t i = 0; i < 4; ++i) segment[i] = id[nodes_of[i].value];
      read.segments.insert(segment);
    }
  }
  return sets;
}

std::set<std::int64_t> all_nodes(const Report& report) {
  std::set<std::int64_t> nodes;
  for (const Penetration& record : report.penetrations) {
    nodes.insert(record.node);
    nodes.insert(record.segment.begin(), record.segment.end());
  }
  for (const TieFailure& failure : report.tie_failures) nodes.insert(failure.node);
  for (const Finding& finding : report.findings) {
    nodes.insert(finding.node);
    nodes.insert(finding.members.nodes.begin(), finding.members.nodes.end());
    for (const Segment& segment : finding.members.segments) nodes.insert(segment.begin(), segment.end());
  }
  nodes.erase(nodes.begin(), nodes.lower_bound(1));
  return nodes;
}

/// Slow twin: nodes and segments of the records of one rule in one contact.
void expect_records(const Report& report) {
  const auto sets = read_back(keyword_sets(report, 0), all_nodes(report));
  std::int64_t id = report.highest_set + 1;
  for (std::uint32_t contact = 0; contact < report.contacts.size(); ++contact)
    for (std::size_t kind = 0; kind < penetration_kinds; ++kind) {
      std::set<std::int64_t> nodes;
      std::set<Segment> segments;
      for (const Penetration& record : report.penetrations) {
        if (record.contact != contact || static_cast<std::size_t>(record.kind) != kind) continue;
        nodes.insert(record.node);
        segments.insert(record.segment);
      }
      if (nodes.empty()) continue;
      const auto found = sets.find(id++);
      ASSERT_NE(found, sets.end());
      EXPECT_EQ(found->second[0].nodes, nodes);
      EXPECT_EQ(found->second[1].segments, segments);
      const std::string rule(rule_of(static_cast<PenetrationKind>(kind)).id);
      EXPECT_TRUE(found->second[0].title.starts_with(rule + " ")) << found->second[0].title;
      EXPECT_NE(found->second[0].title.find(" contact " + std::to_string(report.contacts[contact].id) + ": " +
                                            std::to_string(nodes.size()) + " node"),
                std::string::npos)
          << found->second[0].title;
    }
}

TEST(KeywordSets, HoldTheNodesAndSegmentsOfTheRecords) {
  for (unsigned seed = 1; seed < 10; ++seed) {
    Report report = random_report(400, 3, seed);
    report.findings.clear();
    report.highest_set = 41;
    expect_records(report);
  }
}

TEST(KeywordSets, Columns) {
  Report report = sample_report();
  report.findings.clear();
  report.highest_set = 12;
  report.penetrations[0].kind = report.penetrations[2].kind = PenetrationKind::initial;
  report.penetrations[1].kind = PenetrationKind::edge;
  report.penetrations[1].segment = {3, 4, 4, 4};
  report.penetrations[2].segment = {5, 6, 7, 7};
  EXPECT_EQ(keyword_sets(report, 0),
            "*KEYWORD LONG=S\n"
            "$ Nodes and segments of the findings in plates.k\n"
            "$ The sets of one rule in one contact have the same id.\n"
            "*SET_NODE_LIST_TITLE\n"
            "GC101 initial-penetration contact 7: 2 nodes, deepest 0.9; plates\n"
            "        13\n"
            "        14        16\n"
            "*SET_SEGMENT_TITLE\n"
            "GC101 initial-penetration contact 7: 2 segments, deepest 0.9; plates\n"
            "        13\n"
            "         5         6         7         7\n"
            "     22124     22164     22165     22125\n"
            "*SET_NODE_LIST_TITLE\n"
            "GC109 edge-penetration contact 7: 3 nodes, deepest 0.6; plates\n"
            "        14\n"
            "         3         4        15\n"
            "*END\n");
  EXPECT_NE(keyword_sets(report, 900).find("\n       900\n"), std::string::npos) << "the user's own first id";
}

TEST(KeywordSets, WhatOtherFindingsList) {
  Report report;
  report.source = "deck";
  report.contacts.push_back(make_contact(7, 1, "CONTACT_X", "13", 0, 0));
  Finding crossed = make_finding("GC103", "crossed-elements", "");
  crossed.contact = 7;
  crossed.members.segments = {{1, 2, 3, 4}, {5, 6, 7, 7}};
  Finding counted = make_finding("GC304", "thickness-exceeds-mesh", "");
  counted.contact = 7;
  counted.count = 10;
  counted.members.segments = {{1, 2, 3, 4}};
  Finding nodes = make_finding("GC507", "duplicate-nodes", "");
  nodes.node = 8;
  nodes.members.nodes = {8, 9};
  report.findings = {crossed, counted, nodes, make_finding("GC401", "missing-card", "")};
  report.tie_failures.push_back({.contact = 0, .node = 20, .reason = TieReason::not_found});
  const std::string text = keyword_sets(report, 1);
  const auto sets = read_back(text, all_nodes(report));
  ASSERT_EQ(sets.size(), 4U) << text;
  EXPECT_EQ(sets.at(1)[0].nodes, (std::set<std::int64_t>{1, 2, 3, 4, 5, 6, 7})) << "corners of both elements";
  EXPECT_EQ(sets.at(1)[0].title, "GC103 crossed-elements contact 7: 7 nodes");
  EXPECT_EQ(sets.at(1)[1].segments, (std::set<Segment>{{1, 2, 3, 4}, {5, 6, 7, 7}}));
  EXPECT_EQ(sets.at(2)[0].nodes, (std::set<std::int64_t>{20}));
  EXPECT_EQ(sets.at(3)[1].segments.size(), 1U);
  EXPECT_EQ(sets.at(4)[0].nodes, (std::set<std::int64_t>{8, 9}));
  EXPECT_EQ(sets.at(4)[0].title, "GC507 duplicate-nodes: 2 nodes");
  EXPECT_NE(text.find("$ GC304: 9 more are counted in the report and in no set\n"), std::string::npos) << text;
  EXPECT_NE(text.find("$ 1 findings name no node and no segment"), std::string::npos) << text;
}

TEST(KeywordSets, TitlesCannotBreakTheFile) {
  for (const std::string& title :
       {std::string("x\n*END\n*NODE"), std::string("&parameter <1+2>"), std::string(300, 'x'), std::string("\t\r\n"),
        "1234567890123456" + std::string("\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4")}) {
    Report report = sample_report();
    report.findings.clear();
    report.contacts[0].title = title;
    report.input = "a\n*END\n.k";
    const std::string text = keyword_sets(report, 5);
    const auto sets = read_back(text, all_nodes(report));
    EXPECT_EQ(sets.size(), 3U) << text;
    for (const auto& [id, both] : sets)
      for (const ReadSet& set : both) {
        EXPECT_LE(set.title.size(), 80U);
        EXPECT_TRUE(set.title.starts_with("GC10")) << set.title;
        EXPECT_EQ(set.title.find_first_of("&<>"), std::string::npos) << set.title;
        EXPECT_NE(static_cast<unsigned char>(set.title.back()), 0xC3) << "half a character";
      }
  }
}

TEST(KeywordSets, LargeIdsMakeLongFields) {
  for (const std::int64_t large : {std::int64_t{9'999'999'999}, std::int64_t{10'000'000'000}, std::int64_t{1} << 59}) {
    Report report = sample_report();
    report.findings.clear();
    report.penetrations[0].node = large;
    const std::string text = keyword_sets(report, 1);
    EXPECT_EQ(text.starts_with("*KEYWORD LONG=Y\n"), large > 9'999'999'999);
    const auto sets = read_back(text, all_nodes(report));
    ASSERT_EQ(sets.size(), 3U);
    EXPECT_TRUE(sets.at(2)[0].nodes.contains(large)) << text;
  }
}

TEST(KeywordSets, IdsNoDeckHas) {
  Report report = sample_report();
  report.penetrations[0].node = std::numeric_limits<std::int64_t>::min();
  report.penetrations[1].segment = {1, 2, 3, -4};
  report.highest_set = std::numeric_limits<std::int64_t>::max();
  const std::string text = keyword_sets(report, 0);
  EXPECT_NE(text.find("1 more have numbers that are no ids"), std::string::npos) << text;
  report.findings.clear();
  const auto sets = read_back(text, all_nodes(report));
  EXPECT_FALSE(sets.empty());
  for (const auto& [id, both] : sets) EXPECT_LT(id, 10);
}

TEST(KeywordSets, EmptyReport) {
  EXPECT_TRUE(read_back(keyword_sets({}, 0), {}).empty());
  Report log = sample_report();
  log.source = "messag";
  log.findings.clear();
  EXPECT_NE(keyword_sets(log, 0).find("\n     22166\n"), std::string::npos)
      << "above all ids: no deck says what is free";
}

}  // namespace
}  // namespace gapcheck::report::keyword_sets_test
