#include "report/export/exports.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "report/export/exports_groups.hpp"
#include "report/sample.hpp"

namespace gapcheck::report::exports_test {
namespace {

std::optional<Vector> nowhere(std::int64_t) { return std::nullopt; }

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The file as gapcheck's own rooms read it. Nodes that only the model has are the one kind of fault.
model::Model parsed(const std::string& text) {
  Diagnostics diagnostics;
  const auto deck = keyword::read_deck_text(text, "check-c.key", {}, diagnostics);
  EXPECT_TRUE(deck.ok()) << text;
  if (!deck.ok()) return {};
  auto model = model::read_model(deck.value(), diagnostics);
  EXPECT_TRUE(model.ok());
  for (const Diagnostic& diagnostic : diagnostics.sorted())
    ADD_FAILURE() << diagnostic.line << ": " << diagnostic.message;
  if (!model.ok()) return {};
  for (const model::Fault& fault : model.value().faults) {
    EXPECT_EQ(fault.kind, model::Fault::Kind::unknown_reference) << fault.message;
    EXPECT_NE(fault.message.find("set"), std::string::npos) << fault.message;
  }
  EXPECT_TRUE(model.value().skipped_keywords.empty() || model.value().skipped_keywords.begin()->first == "KEYWORD" ||
              model.value().skipped_keywords.begin()->first == "END");
  return std::move(model).value();
}

/// Beams of the file: part title, both ends.
struct Line {
  std::string title;
  Vector from, to;
};

std::vector<Line> beams_of(const std::string& text) {
  const model::Model model = parsed(text);
  std::vector<Line> result;
  for (std::size_t i = 0; i < model.mesh.beams.size(); ++i) {
    const auto& nodes = model.mesh.beams.nodes[i];
    const model::Part& part = model.part(model.mesh.beams.part[i]);
    EXPECT_TRUE(part.section && part.material);
    result.push_back({part.title, model.mesh.nodes.x[nodes[0].value], model.mesh.nodes.x[nodes[1].value]});
  }
  return result;
}

/// Slow twin: the beams that the file must hold, sorted as the file is.
std::vector<std::pair<std::string, const Penetration*>> expected_beams(const Report& report) {
  std::vector<std::pair<std::string, const Penetration*>> result;
  for (std::uint32_t contact = 0; contact < report.contacts.size(); ++contact)
    for (const auto& [kind, word] :
         {std::pair{PenetrationKind::initial, "pen"}, std::pair{PenetrationKind::released, "below"},
          std::pair{PenetrationKind::edge_zone, "edge"}, std::pair{PenetrationKind::segment, "soft2"},
          std::pair{PenetrationKind::mortar, "mortar"}, std::pair{PenetrationKind::edge, "edges"}})
      for (const Penetration& record : report.penetrations)
        if (record.contact == contact && record.kind == kind)
          result.emplace_back("id" + std::to_string(report.contacts[contact].id) + " " + word, &record);
  return result;
}

void expect_beams(const Report& report) {
  const auto beams = beams_of(keyword_beams(report, nowhere));
  const auto expected = expected_beams(report);
  ASSERT_EQ(beams.size(), expected.size());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const Penetration& record = *expected[i].second;
    EXPECT_TRUE(beams[i].title.starts_with(expected[i].first + ":")) << beams[i].title;
    const double scale = 1 + record.original.norm();
    ASSERT_LT((beams[i].from - record.original).norm(), 1e-9 * scale);
    const Vector way = beams[i].to - beams[i].from;
    ASSERT_NEAR(way.norm(), record.depth, 1e-6);
    Vector expected_way = record.moved_to - record.original;
    if (expected_way.norm() == 0) expected_way = record.original - record.point;
    ASSERT_NEAR(way.dot(expected_way) / expected_way.norm(), record.depth, 1e-6);
  }
}

TEST(KeywordBeams, LengthsAndDirectionsAreThoseOfTheRecords) {
  expect_beams(sample_report());
  for (unsigned seed = 1; seed < 20; ++seed) {
    Report report = random_report(200, 4, seed);
    for (Penetration& record : report.penetrations) record.depth = std::min(record.depth, record.contact_distance);
    for (ContactSummary& contact : report.contacts) contact.title = "any & <title>";
    expect_beams(report);
  }
}

TEST(KeywordBeams, PartsAndSetsHaveSpeakingTitles) {
  Report report = sample_report();
  report.tie_failures.push_back({.contact = 1, .node = 99, .reason = TieReason::too_far});
  report.tie_failures.push_back({.contact = 1, .node = 14, .distance = 0.25, .reason = TieReason::not_found});
  const std::string text = keyword_beams(report, nowhere);
  const model::Model model = parsed(text);
  std::vector<std::string> parts, sets;
  for (const model::Part& part : model.parts) parts.push_back(part.title);
  for (const auto& [id, set] : model.sets.nodes) sets.push_back(set.title);
  EXPECT_EQ(parts, (std::vector<std::string>{"id7 pen: plates", "id7 below: plates", "id7 edge: plates"}));
  EXPECT_EQ(sets, (std::vector<std::string>{"id7 pen: plates", "id7 below: plates", "id7 edge: plates",
                                            "id2 far: CONTACT_AUTOMATIC_SURFACE_TO_SURFACE",
                                            "id2 notfound: CONTACT_AUTOMATIC_SURFACE_TO_SURFACE"}));
}

TEST(KeywordBeams, SetsHoldTheTrackedNodes) {
  Report report = random_report(500, 2, 3);
  for (Penetration& record : report.penetrations) record.node = 1 + record.node % 60;
  // The model defines the nodes; here all of them stand behind the file's own.
  std::string text = keyword_beams(report, nowhere);
  text.resize(text.rfind("*END"));
  text += "*NODE\n";
  for (int id = 1; id <= 60; ++id) text += std::string(id < 10 ? 7 : 6, ' ') + std::to_string(id) + "\n";
  const model::Model model = parsed(text);
  EXPECT_TRUE(model.faults.empty());
  const auto groups = export_groups(report);
  ASSERT_EQ(groups.size(), model.sets.nodes.size());
  auto set = model.sets.nodes.begin();
  for (const ExportGroup& group : groups) {
    std::set<std::int64_t> expected, found;
    for (const Penetration* record : group.penetrations) expected.insert(record->node);
    for (const NodeIndex node : set->second.members) found.insert(model.mesh.nodes.id[node.value]);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(set->second.members.size(), expected.size());
    ++set;
  }
}

TEST(KeywordBeams, ColumnsOfTheStandardFormat) {
  Report report = sample_report();
  report.penetrations.erase(report.penetrations.begin(), report.penetrations.begin() + 2);
  report.penetrations[0].original = {-1234.5678901234567, 1e-17 / 3, 2e7 / 3};
  report.penetrations[0].moved_to = report.penetrations[0].original + Vector(0, 0, 2);
  EXPECT_EQ(keyword_beams(report, nowhere),
            "*KEYWORD\n"
            "$ Penetrations as beams: from each tracked node to the contact surface.\n"
            "$ The sets hold the tracked nodes themselves; these are defined in the model only.\n"
            "$ 1 beams, 1 records\n"
            "*NODE\n"
            "   22166 -1234.567890123 3.333333333e-186666666.66666667\n"
            "   22167 -1234.567890123 3.333333333e-186666666.96666667\n"
            "*ELEMENT_BEAM\n"
            "   22166   22166   22166   22167\n"
            "*SECTION_BEAM\n"
            "     22166         3\n"
            "       1.0\n"
            "*MAT_ELASTIC\n"
            "     22166    1.0E-9       1.0       0.3\n"
            "*PART\n"
            "id7 pen: plates\n"
            "     22166     22166     22166\n"
            "*SET_NODE_LIST_TITLE\n"
            "id7 pen: plates\n"
            "     22166\n"
            "        16\n"
            "*END\n");
}

TEST(KeywordBeams, LargeIdsMakeLongFields) {
  for (const std::int64_t id : {std::int64_t{99'999'990}, std::int64_t{123'456'789'012}, std::int64_t{1} << 58}) {
    Report report = sample_report();
    for (std::size_t i = 0; i < report.penetrations.size(); ++i)
      report.penetrations[i].node = id + static_cast<std::int64_t>(i);
    const std::string text = keyword_beams(report, nowhere);
    const bool is_long = id > 99'999'990;
    EXPECT_EQ(text.starts_with("*KEYWORD LONG=Y\n"), is_long);
    const auto lines = lines_of(text);
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      if (lines[i] != "*NODE" && lines[i] != "*ELEMENT_BEAM") continue;
      const std::size_t width = lines[i] == "*NODE" ? (is_long ? 80 : 56) : (is_long ? 80 : 32);
      for (std::size_t k = i + 1; lines[k][0] != '*'; ++k) EXPECT_EQ(lines[k].size(), width) << lines[k];
    }
    const model::Model model = parsed(text);
    EXPECT_EQ(model.mesh.nodes.id.front(), id + 3);
    expect_beams(report);
  }
}

TEST(KeywordBeams, IdsNoDeckHasDoNotOverflow) {
  Report report = sample_report();
  report.penetrations[0].node = std::numeric_limits<std::int64_t>::max();
  report.penetrations[1].node = std::numeric_limits<std::int64_t>::min();
  EXPECT_EQ(first_free_id(report), 22166);
  EXPECT_FALSE(keyword_beams(report, nowhere).empty());
  EXPECT_FALSE(medina_protocol(report, nowhere, std::numeric_limits<std::int64_t>::max()).empty());
}

TEST(KeywordBeams, EmptyReportIsAValidFile) {
  const model::Model model = parsed(keyword_beams({}, nowhere));
  EXPECT_EQ(model.mesh.nodes.size(), 0U);
  EXPECT_TRUE(model.parts.empty());
  EXPECT_EQ(animator_session({}, false), "");
  EXPECT_EQ(animator_session({}, true), "");
  EXPECT_EQ(medina_protocol({}, nowhere, 1), "");
}

/// One record as a solver file gives it: no closest point, and no coordinates unless `original` is set.
Report solver_report() {
  Report report = sample_report();
  report.source = "messag";
  report.penetrations.resize(1);
  Penetration& record = report.penetrations[0];
  record.kind = PenetrationKind::initial;
  record.segment = {1, 2, 3, 4};
  record.s = record.t = 0;
  record.depth = 0.75;
  record.contact_distance = 1;
  record.original = record.point = record.moved_to = Vector::Zero();
  return report;
}

/// A unit square in the plane z = 5 and a tracked node (14) at height `z` above its centre.
NodePosition square(double z) {
  return [z](std::int64_t node) -> std::optional<Vector> {
    const std::map<std::int64_t, Vector> nodes{
        {1, {0, 0, 5}}, {2, {1, 0, 5}}, {3, {1, 1, 5}}, {4, {0, 1, 5}}, {14, {0.5, 0.5, 5 + z}}};
    const auto found = nodes.find(node);
    return found == nodes.end() ? std::nullopt : std::optional(found->second);
  };
}

Vector way_of(const Report& report, const NodePosition& position) {
  const auto line = penetration_line(report, report.penetrations[0], position);
  return line ? Vector(line->surface - line->node) : Vector::Zero();
}

TEST(PenetrationLine, TakesWhatTheMeshKnows) {
  const Report report = solver_report();
  EXPECT_TRUE(way_of(report, square(0.25)).isApprox(Vector(0, 0, 0.75)));
  EXPECT_TRUE(way_of(report, square(-0.25)).isApprox(Vector(0, 0, -0.75)));
  EXPECT_TRUE(way_of(report, square(0)).isApprox(Vector(0, 0, 0.75)));  // the segment's normal
  EXPECT_EQ(way_of(report, nowhere), Vector::Zero());
  EXPECT_EQ(way_of(report, nullptr), Vector::Zero());
}

TEST(PenetrationLine, PointAtTheNodeIsNoPoint) {
  Report report = solver_report();
  Penetration& record = report.penetrations[0];
  record.original = record.point = record.moved_to = {0.5, 0.5, 4.75};
  EXPECT_TRUE(way_of(report, square(0)).isApprox(Vector(0, 0, -0.75)));
  record.point = {0.5, 0.5, 5};
  EXPECT_TRUE(way_of(report, nowhere).isApprox(Vector(0, 0, -0.75)));
  record.moved_to = {0.5, 0.5, 6};
  EXPECT_TRUE(way_of(report, nowhere).isApprox(Vector(0, 0, 0.75)));
}

TEST(PenetrationLine, LeavesASolidTowardsItsFace) {
  Report report = sample_report();
  report.penetrations.resize(1);
  Penetration& record = report.penetrations[0];
  record.original = record.moved_to = {1, 1, -0.5};
  record.point = {1, 1, 0};
  record.depth = 0.5;
  record.contact_distance = 0;
  const auto line = penetration_line(report, record, nowhere);
  ASSERT_TRUE(line);
  EXPECT_LT((line->surface - record.point).norm(), 1e-15);
}

TEST(PenetrationLine, UnusableNumbersAreNotDrawn) {
  const Report sample = sample_report();
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 0.0, -1.0}) {
    Report report = sample;
    report.penetrations[0].depth = bad;
    EXPECT_FALSE(penetration_line(report, report.penetrations[0], nowhere));
  }
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    Report report = sample;
    report.penetrations[0].original[1] = bad;
    EXPECT_FALSE(penetration_line(report, report.penetrations[0], nowhere));
    report = sample;
    report.penetrations[0].point[1] = bad;
    EXPECT_FALSE(penetration_line(report, report.penetrations[0], nowhere));
  }
}

TEST(KeywordBeams, RecordsThatCannotBeDrawnAreNamed) {
  const Report report = solver_report();
  const std::string text = keyword_beams(report, nowhere);
  const model::Model model = parsed(text);
  EXPECT_EQ(model.mesh.beams.size(), 0U);
  EXPECT_EQ(model.sets.nodes.size(), 1U);
  EXPECT_NE(text.find("$ node 14: penetration 0.75, position or direction not known: no beam\n"), std::string::npos);
}

TEST(ExportGroups, TitlesAreCutAndPrintable) {
  Report report = sample_report();
  report.contacts[0].title = "a\nb\t" + std::string(58, 'x') + "\xc3\xa4\xc3\xa4\xc3\xa4";
  const auto groups = export_groups(report);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].title, "id7 pen: a?b?" + std::string(58, 'x').substr(0, 57));
  report.contacts[0].title = std::string(60, 'x') + "\xc3\xa4\xc3\xa4\xc3\xa4";
  EXPECT_EQ(export_groups(report)[0].title, "id7 pen: " + std::string(60, 'x'));
  report.contacts[0].title = report.contacts[0].keyword = "";
  EXPECT_EQ(export_groups(report)[1].title, "id7 below");
  report.penetrations[0].contact = 1000;
  EXPECT_EQ(export_groups(report).back().title, "id0 below");
}

TEST(AnimatorSession, ListsTheNodes) {
  Report report = sample_report();
  EXPECT_EQ(animator_session(report, false), "ide nod 16\nide nod 14\nide nod 15\n");
  EXPECT_EQ(animator_session(report, true),
            "sel nod 16\ngro \"id7 pen\"\nsel nod 14\ngro \"id7 below\"\nsel nod 15\ngro \"id7 edge\"\n");
  for (int i = 0; i < 11; ++i) report.tie_failures.push_back({.contact = 1, .node = 111 - i});
  report.tie_failures.push_back({.contact = 1, .node = 105});
  report.penetrations.clear();
  EXPECT_EQ(animator_session(report, true),
            "sel nod 101 102 103 104 105 106 107 108 109 110\nsel nod 111\ngro \"id2 notfound\"\n");
}

TEST(MedinaProtocol, NumbersNewNodes) {
  Report report = sample_report();
  report.penetrations.erase(report.penetrations.begin());
  report.tie_failures.push_back({.contact = 1, .node = 14});
  report.tie_failures.push_back({.contact = 1, .node = 15});
  EXPECT_EQ(medina_protocol(report, square(0), 9'999'999),
            "GROUP \"id7 pen\"\n"
            "NODE 16 12 20 0.7\n"
            "NEW_NODE 9999999 12 20 1\n"
            "LINE 16 9999999\n"
            "GROUP \"id7 edge\"\n"
            "NODE 15 11 20 0.4\n"
            "NEW_NODE 10000000 11.557086014531155 20 0.6228344058124622\n"
            "LINE 15 10000000\n"
            "GROUP \"id2 notfound\"\n"
            "NODE 14 0.5 0.5 5\n"
            "NODE 15\n");
}

}  // namespace
}  // namespace gapcheck::report::exports_test
