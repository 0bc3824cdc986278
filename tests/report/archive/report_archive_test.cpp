#include "report/archive/report_archive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "report/sample.hpp"

namespace gapcheck::report::archive_test {
namespace {

constexpr std::string_view consequence = "It goes wrong";

std::string_view consequence_of(std::string_view id) { return id == "GC501" ? consequence : ""; }

TieFailure untied_node() {
  TieFailure failure;
  failure.contact = 1;
  failure.node = 99;
  failure.distance = 0.1;
  failure.allowed = std::numeric_limits<double>::denorm_min();
  failure.reason = TieReason::conflict;
  failure.by_node_set = true;
  failure.position = Vector(1, -0.0, std::nextafter(3.0, 4.0));
  return failure;
}

/// Every kind of content that an audit can have.
Report full_report() {
  Report report = sample_report();
  report.as_if = {"SST=0.5"};
  report.unknown_parts = {-3};
  report.settings = "gapcheck.toml";
  report.page = "pages/a.html";
  report.severities = {{"GC101", Severity::error}, {"GC5", Severity::note}};
  report.penetrations[0].s = std::numeric_limits<double>::quiet_NaN();
  report.tie_failures = {untied_node()};
  Finding placed = make_finding("GC501", "duplicate-id", std::string("nul \0 and line\nbreak", 19));
  placed.consequence = consequence;
  placed.point = Vector(1, 2, 3);
  placed.key = 7;
  report.findings.push_back(placed);
  report.ignored.findings = {placed};
  report.ignored.penetrations = {report.penetrations[1]};
  report.ignored.source = {0, 1};
  report.ignored.sources = {{"a.k", 3, "welded", true, 1}, {"gapcheck.toml", 9, "", false, 1}};
  BaselineComparison compared;
  compared.states.resize(report.penetrations.size() + report.tie_failures.size() + report.findings.size(),
                         BaselineState::worse);
  compared.ignored_states = {BaselineState::fresh, BaselineState::unchanged};
  KnownFinding gone;
  gone.id = "GC201";
  gone.position = Vector(4, 5, 6);
  compared.gone = {gone};
  report.baseline = compared;
  PortabilityNote note;
  note.program = "Altair Radioss";
  note.kind = PortabilityKind::field;
  note.other_meaning = true;
  note.name = "SOFSCL";
  report.portability = Portability{{"Altair Radioss"}, {note}};
  report.predicted = Timesteps{1e-7, 2e-7, {{1, 'B', "a3", no_timestep_limit, 5, 6}}};
  report.statistics = {{"files read", "3"}};
  report.timing = {1, 2, 3, 4, 5};
  report.highest_set = 12;
  return report;
}

Report sound(std::string_view bytes) {
  auto report = unarchived(bytes, consequence_of);
  EXPECT_TRUE(report);
  return report ? std::move(report).value() : Report();
}

TEST(ReportArchive, ReportsComeBackToTheLastBit) {
  const Report report = full_report();
  const std::string bytes = archived(report);
  const Report back = sound(bytes);
  EXPECT_TRUE(archived(back) == bytes);
  // Equal bytes say nothing about what is written nowhere, so some of it by hand.
  EXPECT_EQ(back.penetrations.size(), 3);
  EXPECT_TRUE(std::isnan(back.penetrations[0].s));
  EXPECT_EQ(back.penetrations[0].outcome, Outcome::released);
  EXPECT_EQ(back.penetrations[1].feature, Feature::edge);
  EXPECT_TRUE(std::signbit((*back.tie_failures[0].position)[1]));
  EXPECT_EQ(back.tie_failures[0].allowed, std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(back.findings.back().message, std::string("nul \0 and line\nbreak", 19));
  EXPECT_EQ(back.findings.back().consequence, consequence);
  EXPECT_EQ(back.ignored.findings.back().consequence, consequence);
  EXPECT_EQ(back.ignored.sources[0].reason, "welded");
  EXPECT_EQ(back.baseline->states[0], BaselineState::worse);
  EXPECT_EQ(back.portability->notes[0].kind, PortabilityKind::field);
  EXPECT_EQ(back.predicted->surface_timesteps[0].side, 'B');
  EXPECT_EQ(back.severities.at("GC101"), Severity::error);
  EXPECT_EQ(back.highest_set, 12);
  EXPECT_EQ(back.contacts[1].not_checked, report.contacts[1].not_checked);
}

TEST(ReportArchive, BytesThatEndEarlyOrGoOnAreRefused) {
  const std::string bytes = archived(full_report());
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(unarchived(std::string_view(bytes).substr(0, length), consequence_of)) << length;
  EXPECT_FALSE(unarchived(bytes + '\0', consequence_of));
}

TEST(ReportArchive, PositionsAndEnumerationsOutOfRangeAreRefused) {
  const auto refused = [](const auto& change) {
    Report report = full_report();
    change(report);
    return !unarchived(archived(report), consequence_of);
  };
  EXPECT_FALSE(refused([](Report&) {}));
  EXPECT_TRUE(refused([](Report& r) { r.penetrations[2].contact = 2; }));
  EXPECT_TRUE(refused([](Report& r) { r.penetrations[2].file = 2; }));
  EXPECT_TRUE(refused([](Report& r) { r.tie_failures[0].contact = 2; }));
  EXPECT_TRUE(refused([](Report& r) { r.ignored.source[1] = 2; }));
  EXPECT_TRUE(refused([](Report& r) { r.ignored.source.pop_back(); }));
  EXPECT_TRUE(refused([](Report& r) { r.baseline->states.pop_back(); }));
  EXPECT_TRUE(refused([](Report& r) { r.baseline->ignored_states.pop_back(); }));
  EXPECT_TRUE(refused([](Report& r) { r.predicted->surface_timesteps[0].contact = 2; }));
  EXPECT_TRUE(refused([](Report& r) { r.penetrations[0].kind = static_cast<PenetrationKind>(6); }));
  EXPECT_TRUE(refused([](Report& r) { r.tie_failures[0].reason = static_cast<TieReason>(8); }));
  EXPECT_TRUE(refused([](Report& r) { r.findings[0].severity = static_cast<Severity>(3); }));
}

TEST(ReportArchive, AnyBytesAreTakenOrRefused) {
  const std::string bytes = archived(full_report());
  std::mt19937 random(1);
  std::size_t taken = 0;
  constexpr int rounds = 20000;
  for (int round = 0; round < rounds; ++round) {
    std::string changed = bytes;
    for (int i = 0; i < 3; ++i) changed[random() % changed.size()] = static_cast<char>(random());
    if (const auto report = unarchived(changed, consequence_of)) {
      ++taken;
      // Not always the changed bytes: a map puts its keys in order.
      const std::string again = archived(report.value());
      EXPECT_TRUE(archived(sound(again)) == again);
    }
  }
  EXPECT_GT(taken, 0);
  EXPECT_LT(taken, rounds);
}

}  // namespace
}  // namespace gapcheck::report::archive_test
