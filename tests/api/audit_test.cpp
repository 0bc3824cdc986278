// The public audit gives what the internal one gives, to the bit, and refuses what cannot be meant.
#include "audit/audit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <future>
#include <gapcheck/audit.hpp>
#include <gapcheck/write.hpp>
#include <limits>
#include <string>
#include <vector>

#include "api/new_folder.hpp"
#include "records/record_rules.hpp"
#include "report/write/writers.hpp"

namespace gapcheck::api_test::audit_test {
namespace {

namespace fs = std::filesystem;

gapcheck::Report internal(const std::string& deck, const audit::AuditOptions& options = {}) {
  Diagnostics diagnostics;
  auto report = audit::audit_deck(deck, options, diagnostics);
  EXPECT_TRUE(report.ok()) << deck;
  return report.ok() ? std::move(report).value() : gapcheck::Report{};
}

void expect_bits(double a, double b) { EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b)); }

void expect_point(std::span<const double> rows, std::size_t i, const Vector& expected) {
  for (std::size_t k = 0; k < 3; ++k) expect_bits(rows[3 * i + k], expected[static_cast<int>(k)]);
}

void expect_same(const api::Penetrations& got, std::size_t i, const Penetration& p) {
  SCOPED_TRACE("node " + std::to_string(p.node));
  EXPECT_EQ(got.contact[i], p.contact);
  EXPECT_EQ(got.node[i], p.node);
  EXPECT_EQ(got.part[i], p.part);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(got.segment[4 * i + k], p.segment[k]);
  EXPECT_EQ(got.segment_number[i], p.segment_number);
  EXPECT_EQ(got.element[i], p.element);
  EXPECT_EQ(got.element_part[i], p.element_part);
  expect_bits(got.depth[i], p.depth);
  expect_bits(got.contact_distance[i], p.contact_distance);
  expect_bits(got.local[2 * i], p.s);
  expect_bits(got.local[2 * i + 1], p.t);
  expect_point(got.position, i, p.original);
  expect_point(got.closest, i, p.point);
  expect_point(got.moved_to, i, p.moved_to);
  EXPECT_EQ(api::rule_id(got.kind[i]), rule_of(p.kind).id);
  EXPECT_EQ(api::name(got.outcome[i]), name(p.outcome));
  EXPECT_EQ(api::name(got.feature[i]), name(p.feature));
  EXPECT_EQ(api::name(got.node_rule[i]), name(p.node_rule));
  EXPECT_EQ(api::name(got.segment_rule[i]), name(p.segment_rule));
  EXPECT_EQ(got.file[i], p.file);
  EXPECT_EQ(got.line[i], p.line);
}

void expect_same(const api::Ties& got, std::size_t i, const TieFailure& t) {
  EXPECT_EQ(got.contact[i], t.contact);
  EXPECT_EQ(got.node[i], t.node);
  EXPECT_EQ(got.part[i], t.part);
  EXPECT_EQ(api::name(got.reason[i]), name(t.reason));
  EXPECT_EQ(api::rule_id(got.reason[i]), rule_of(t.reason).id);
  EXPECT_EQ(api::untied(got.reason[i]), untied(t.reason));
  expect_bits(got.distance[i], t.distance);
  expect_bits(got.allowed[i], t.allowed);
  EXPECT_EQ(got.by_node_set[i] == 1, t.by_node_set);
  EXPECT_EQ(got.line[i], t.line);
  if (t.position)
    expect_point(got.position, i, *t.position);
  else
    EXPECT_TRUE(std::isnan(got.position[3 * i]));
}

void expect_same(const api::Report& got, const gapcheck::Report& expected) {
  EXPECT_EQ(got.source, expected.source);
  EXPECT_EQ(got.files, expected.files);
  EXPECT_EQ(got.model.nodes, expected.model.nodes);
  EXPECT_EQ(got.model.solids, expected.model.solids);
  EXPECT_EQ(got.ignored, expected.ignored.size());
  ASSERT_EQ(got.contacts.size(), expected.contacts.size());
  for (std::size_t i = 0; i < got.contacts.size(); ++i) {
    EXPECT_EQ(got.contacts[i].id, expected.contacts[i].id);
    EXPECT_EQ(got.contacts[i].keyword, expected.contacts[i].keyword);
    EXPECT_EQ(got.contacts[i].penetrations, expected.contacts[i].penetrations);
    EXPECT_EQ(got.contacts[i].untied, expected.contacts[i].untied);
    EXPECT_EQ(got.contacts[i].not_checked, expected.contacts[i].not_checked);
    EXPECT_EQ(got.contacts[i].line, expected.contacts[i].line);
  }
  ASSERT_EQ(got.penetrations.size(), expected.penetrations.size());
  for (std::size_t i = 0; i < got.penetrations.size(); ++i) expect_same(got.penetrations, i, expected.penetrations[i]);
  ASSERT_EQ(got.ties.size(), expected.tie_failures.size());
  for (std::size_t i = 0; i < got.ties.size(); ++i) expect_same(got.ties, i, expected.tie_failures[i]);
  ASSERT_EQ(got.findings.size(), expected.findings.size());
  for (std::size_t i = 0; i < got.findings.size(); ++i) {
    EXPECT_EQ(got.findings[i].id, expected.findings[i].id);
    EXPECT_EQ(got.findings[i].message, expected.findings[i].message);
    EXPECT_EQ(got.findings[i].line, expected.findings[i].line);
  }
  const report::Totals totals = report::totals(expected);
  EXPECT_EQ(got.totals.errors, totals.errors);
  EXPECT_EQ(got.totals.warnings, totals.warnings);
  EXPECT_EQ(got.totals.notes, totals.notes);
  ASSERT_EQ(got.predicted.has_value(), expected.predicted.has_value());
  if (got.predicted) expect_bits(got.predicted->contact, expected.predicted->contact_timestep);
}

TEST(ApiAudit, EveryDeckGivesWhatTheRoomsGive) {
  std::size_t decks = 0, penetrations = 0, ties = 0;
  for (const char* folder : {"", "workshop"})
    for (const auto& entry : fs::directory_iterator(fs::path(GAPCHECK_ROOT) / "data" / folder)) {
      if (entry.path().extension() != ".k") continue;
      SCOPED_TRACE(entry.path().string());
      const auto report = api::audit_deck(entry.path().string());
      ASSERT_TRUE(report.ok()) << report.error().message;
      EXPECT_TRUE(report.value().complete);
      expect_same(report.value(), internal(entry.path().string()));
      ++decks;
      penetrations += report.value().penetrations.size();
      ties += report.value().ties.size();
    }
  EXPECT_GT(decks, 50u);
  EXPECT_GT(penetrations, 300u);
  EXPECT_GT(ties, 10u);
}

TEST(ApiAudit, TwoPlates) {
  const auto result = api::audit_deck(data("two_plates.k"));
  ASSERT_TRUE(result.ok());
  const api::Report& report = result.value();
  EXPECT_EQ(report.penetrations.size(), 18u);
  EXPECT_EQ(report.totals.warnings, 18u);
  EXPECT_EQ(report.penetrations.node[0], 1006);
  EXPECT_NEAR(report.penetrations.depth[0], 0.3, 1e-12);
  EXPECT_EQ(report.penetrations.position[1], 5);
  EXPECT_EQ(report.contacts[0].keyword, "CONTACT_AUTOMATIC_SINGLE_SURFACE");
}

TEST(ApiAudit, OptionsAreThoseOfTheRooms) {
  audit::AuditOptions internal_options;
  internal_options.select = {"GC101", "released-node"};
  internal_options.ptol = 0.35;
  internal_options.parts = {1};
  internal_options.exact = true;
  api::AuditOptions options;
  options.select = internal_options.select;
  options.ptol = 0.35;
  options.parts = {1};
  options.exact = true;
  options.jobs = 1;
  const auto report = api::audit_deck(data("two_plates_tilted.k"), options);
  ASSERT_TRUE(report.ok());
  EXPECT_GT(report.value().penetrations.size(), 0u);
  EXPECT_LT(report.value().penetrations.size(), 20u);
  expect_same(report.value(), internal(data("two_plates_tilted.k"), internal_options));
}

TEST(ApiAudit, SeveritiesAndLimits) {
  api::AuditOptions options;
  options.severities = {{"initial-penetration", api::Severity::error}};
  const auto grave = api::audit_deck(data("two_plates.k"), options);
  ASSERT_TRUE(grave.ok());
  EXPECT_EQ(grave.value().totals.errors, 18u);
  options = {};
  options.ratio = 0.5;
  const auto none = api::audit_deck(data("two_plates.k"), options);
  ASSERT_TRUE(none.ok());
  EXPECT_EQ(none.value().penetrations.size(), 0u);
  options = {};
  options.rtol = 0.1;
  const auto remaining = api::audit_deck(data("two_plates.k"), options);
  ASSERT_TRUE(remaining.ok());
  EXPECT_EQ(remaining.value().penetrations.size(), 0u);
}

TEST(ApiAudit, TheMeshIsThatOfTheRooms) {
  audit::AuditOptions internal_options;
  internal_options.mesh = true;
  api::AuditOptions options;
  options.mesh = true;
  for (const char* name : {"shell_on_solid.k", "beam_on_shell.k", "triangle.k"}) {
    const auto report = api::audit_deck(data(name), options);
    ASSERT_TRUE(report.ok());
    ASSERT_TRUE(report.value().mesh.has_value()) << name;
    const api::Mesh& mesh = *report.value().mesh;
    const ElementMesh expected = *internal(data(name), internal_options).mesh;
    ASSERT_EQ(mesh.size(), expected.size());
    ASSERT_EQ(mesh.points.size(), 3 * expected.x.size());
    for (std::size_t i = 0; i < expected.x.size(); ++i) expect_point(mesh.points, i, expected.x[i]);
    const auto same = [](const auto& got, const auto& wanted) {
      return std::equal(got.begin(), got.end(), wanted.begin(), wanted.end());
    };
    EXPECT_TRUE(same(mesh.node, expected.node_ids) && same(mesh.corners, expected.corners));
    EXPECT_TRUE(same(mesh.ends, expected.ends) && same(mesh.element, expected.element_ids));
    EXPECT_TRUE(same(mesh.part, expected.part_ids) && same(mesh.contact, expected.contact_ids));
    EXPECT_TRUE(same(mesh.thickness, expected.thickness));
    std::uint64_t begin = 0;
    for (std::size_t i = 0; i < mesh.size(); begin = mesh.ends[i++]) {
      const std::size_t corners[] = {4, 8, 8, 2, 1};
      EXPECT_EQ(mesh.ends[i] - begin, corners[static_cast<std::size_t>(mesh.kind[i])]);
    }
  }
  const auto without = api::audit_deck(data("triangle.k"));
  ASSERT_TRUE(without.ok());
  EXPECT_FALSE(without.value().mesh.has_value());
}

TEST(ApiAudit, AWatchSeesEveryStepAndChangesNothing) {
  std::vector<std::string> steps;
  std::size_t all = 0;
  api::AuditOptions options;
  options.watch = [&](const api::AuditStep& step) {
    EXPECT_EQ(step.done, steps.size());
    all = step.all;
    steps.emplace_back(step.name);
    return true;
  };
  const auto watched = api::audit_deck(data("two_plates.k"), options);
  ASSERT_TRUE(watched.ok());
  EXPECT_EQ(steps.size(), all);
  EXPECT_GT(steps.size(), 70u);
  EXPECT_EQ(steps.front(), "read");
  EXPECT_EQ(steps[1], "model");
  EXPECT_EQ(steps[2], "GC101");
  EXPECT_EQ(steps.back(), "records");
  expect_same(watched.value(), internal(data("two_plates.k")));
  const auto alone = api::audit_deck(data("two_plates.k"));
  ASSERT_TRUE(alone.ok());
  EXPECT_EQ(api::write(watched.value(), api::Format::csv), api::write(alone.value(), api::Format::csv));
}

TEST(ApiAudit, AWatchStopsAtAnyStep) {
  for (const char* last : {"read", "model", "GC101", "GC510", "records"}) {
    std::string seen;
    api::AuditOptions options;
    options.watch = [&](const api::AuditStep& step) { return (seen = step.name) != last; };
    const auto report = api::audit_deck(data("two_plates.k"), options);
    ASSERT_FALSE(report.ok()) << last;
    EXPECT_EQ(report.error().message, "the audit was stopped");
    EXPECT_EQ(seen, last);
  }
}

TEST(ApiAudit, ADeckInMemory) {
  const auto report = api::audit_text(content(data("two_plates.k")), "memory.k");
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report.value().penetrations.size(), 18u);
  EXPECT_EQ(report.value().input, "memory.k");
}

TEST(ApiAudit, UnreadableDecksAreErrors) {
  const NewFolder folder;
  for (const auto& [path, words] :
       {std::pair{folder / "none.k", "cannot be opened"}, std::pair{folder.path(), "is a directory"},
        std::pair{folder.file("empty.k", ""), "is empty"}}) {
    const auto report = api::audit_deck(path);
    ASSERT_FALSE(report.ok()) << path;
    EXPECT_FALSE(report);
    EXPECT_EQ(report.error().file, path);
    EXPECT_EQ(report.error().line, 0u);
    EXPECT_NE(report.error().message.find(words), std::string::npos) << report.error().message;
  }
}

TEST(ApiAudit, FaultsOfTheTextLeaveAReport) {
  const NewFolder folder;
  const std::string deck =
      folder.file("deck.k", "*KEYWORD\n*INCLUDE\nmissing.k\n*NODE\n1,0.,0.,0.\n2,what,0.,0.\n*END\n");
  const auto report = api::audit_deck(deck);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_FALSE(report.value().complete);
  ASSERT_GE(report.value().diagnostics.size(), 2u);
  EXPECT_EQ(report.value().diagnostics[0].severity, api::Severity::error);
  EXPECT_EQ(report.value().diagnostics[0].file, deck);
  EXPECT_GT(report.value().diagnostics[0].line, 0u);
}

TEST(ApiAudit, MissingIncludesCanBeSkippedOrFound) {
  const NewFolder folder, elsewhere;
  const std::string deck = folder.file("deck.k", "*KEYWORD\n*INCLUDE\nnodes.k\n*END\n");
  api::AuditOptions options;
  options.includes.skip_missing = true;
  const auto skipped = api::audit_deck(deck, options);
  ASSERT_TRUE(skipped.ok());
  EXPECT_TRUE(skipped.value().complete);
  EXPECT_FALSE(skipped.value().diagnostics.empty());
  const std::string nodes = elsewhere.file("nodes.k", "*KEYWORD\n*NODE\n1,0.,0.,0.\n*END\n");
  options = {};
  options.includes.directories = {elsewhere.path()};
  const auto found = api::audit_deck(deck, options);
  ASSERT_TRUE(found.ok());
  EXPECT_TRUE(found.value().complete);
  EXPECT_EQ(found.value().model.nodes, 1u) << nodes;
}

TEST(ApiAudit, OptionsThatCannotBeMeantAreErrors) {
  const auto message = [](const auto& change) {
    api::AuditOptions options;
    change(options);
    const auto report = api::audit_deck(data("two_plates.k"), options);
    return report.ok() ? std::string("accepted") : report.error().message;
  };
  EXPECT_EQ(message([](auto& o) { o.select = {"GC1", "GC7"}; }), "select: 'GC7' is not a rule on decks");
  EXPECT_EQ(message([](auto& o) { o.ignore = {"energy-ratio"}; }), "ignore: 'energy-ratio' is not a rule on decks");
  EXPECT_EQ(message([](auto& o) { o.severities = {{"GC1", api::Severity::note}}; }), "severities: 'GC1' is not a rule");
  EXPECT_EQ(message([](auto& o) { o.ptol = -1; }), "ptol: -1 is not a number of 0 or more");
  EXPECT_EQ(message([](auto& o) { o.rtol = std::numeric_limits<double>::quiet_NaN(); }),
            "rtol: nan is not a number of 0 or more");
  EXPECT_EQ(message([](auto& o) { o.ratio = std::numeric_limits<double>::infinity(); }),
            "ratio: inf is not a number of 0 or more");
  EXPECT_EQ(message([](auto& o) { o.millimetre = 0; }), "millimetre: 0 is not a length");
  EXPECT_EQ(message([](auto& o) { o.contacts = {1, 99}; }), "contact 99: the deck has no such contact");
  EXPECT_EQ(message([](auto& o) { o.parts = {1, 99}; }), "part 99: the deck has no such part");
  EXPECT_EQ(message([](auto& o) { o.contacts = {1}; }), "accepted");
}

TEST(ApiAudit, ViewsLiveAsLongAsACopy) {
  auto first = std::make_unique<api::Result<api::Report>>(api::audit_deck(data("two_plates.k")));
  ASSERT_TRUE(first->ok());
  const api::Report copy = first->value();
  first.reset();
  EXPECT_EQ(copy.penetrations.node[17], 2011);
  EXPECT_EQ(copy.penetrations.segment.size(), 72u);
}

TEST(ApiAudit, ThreadsDoNotDisturbEachOther) {
  const std::vector<std::string> decks{data("two_plates.k"), data("tied_then_contact.k"), data("solid_on_solid.k"),
                                       data("two_plates.k")};
  std::vector<std::future<std::string>> texts;
  for (const std::string& deck : decks)
    texts.push_back(std::async(std::launch::async, [&deck] {
      const auto report = api::audit_deck(deck);
      return report.ok() ? api::write(report.value(), api::Format::text) : report.error().message;
    }));
  for (std::size_t i = 0; i < decks.size(); ++i)
    EXPECT_EQ(texts[i].get(), report::text(internal(decks[i]), {})) << decks[i];
}

TEST(ApiAudit, RulesHaveTheirPages) {
  const std::vector<api::Rule> rules = api::rules();
  EXPECT_GT(rules.size(), 70u);
  EXPECT_TRUE(std::is_sorted(rules.begin(), rules.end(), [](const auto& a, const auto& b) { return a.id < b.id; }));
  EXPECT_EQ(rules[0].name, "initial-penetration");
  EXPECT_FALSE(rules[0].of_runs);
  for (const api::Rule& rule : rules) EXPECT_EQ(rule.of_runs, rule.id.starts_with("GC6")) << rule.id;
  for (const api::Rule& rule : rules) EXPECT_FALSE(rule.page.empty()) << rule.id;
}

}  // namespace
}  // namespace gapcheck::api_test::audit_test
