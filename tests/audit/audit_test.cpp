// What the options of an audit do, on the two plates whose 18 nodes penetrate by 0.3 of 1.
#include "audit/audit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "audit/rules/rule_deck.hpp"
#include "audit/run.hpp"

namespace gapcheck::audit_test::audit_test {
namespace {

using audit::AuditOptions;

/// Default options but for one field.
template <class Field, class Value>
AuditOptions with(Field AuditOptions::*field, Value value) {
  AuditOptions options;
  options.*field = Field(std::move(value));
  return options;
}

using Ids = std::vector<std::int64_t>;
using Names = std::vector<std::string>;

AuditRun run_data(const std::string& name, const AuditOptions& options) {
  AuditRun run = run_file(std::string(GAPCHECK_ROOT) + "/data/" + name + ".k", options);
  EXPECT_TRUE(clean(run));
  return run;
}

std::size_t found(const std::string& name, const AuditOptions& options) {
  return run_data(name, options).report.penetrations.size();
}

std::size_t plates(const AuditOptions& options) { return found("two_plates", options); }

TEST(AuditOptions, DefaultsFindEverything) { EXPECT_EQ(plates({}), 18u); }

TEST(AuditOptions, PenetrationTolerance) {
  EXPECT_EQ(plates(with(&AuditOptions::ptol, 0.29)), 18u);
  EXPECT_EQ(plates(with(&AuditOptions::ptol, 0.31)), 0u);
  // Zero is a tolerance too: touching plates penetrate by the rounding of their decimals.
  EXPECT_EQ(found("clean", {}), 0u);
  EXPECT_EQ(found("clean", with(&AuditOptions::ptol, 0)), 18u) << "nine nodes of each plate lie over the other one";
}

TEST(AuditOptions, RemainingDistance) {
  EXPECT_EQ(plates(with(&AuditOptions::rtol, 0.71)), 18u);
  EXPECT_EQ(plates(with(&AuditOptions::rtol, 0.69)), 0u);
}

TEST(AuditOptions, Ratio) {
  EXPECT_EQ(plates(with(&AuditOptions::ratio, 0.29)), 18u);
  EXPECT_EQ(plates(with(&AuditOptions::ratio, 0.31)), 0u);
}

TEST(AuditOptions, Parts) {
  // A part takes part with its nodes and with its segments.
  EXPECT_EQ(plates(with(&AuditOptions::parts, Ids{2})), 18u);
  EXPECT_EQ(plates(with(&AuditOptions::parts, Ids{3})), 0u);
  const auto rows = [](const Report& report, std::int64_t part) {
    std::set<std::pair<std::int64_t, std::int64_t>> list;  // contact, node
    for (const auto& p : report.penetrations)
      if (part == 0 || p.part == part || p.element_part == part) list.emplace(p.contact, p.node);
    return list;
  };
  // Parts 1 and 2 penetrate each other, and 3 and 4.
  RuleDeck deck;
  for (int part = 1; part <= 4; ++part)
    deck.shell_part(part, 1).plate(100 * part, part, 2, 2, Vector(0, 0, part < 3 ? 0.7 * part : 20 + 0.7 * part), 5, 5);
  const std::string text = deck.contact(1, "AUTOMATIC_SINGLE_SURFACE", "0,0,5,0").text();
  const Report all = run_text(text).report;
  EXPECT_EQ(all.penetrations.size(), 36u);
  EXPECT_EQ(rows(all, 1).size(), 18u);
  EXPECT_EQ(rows(run_text(text, with(&AuditOptions::parts, Ids{1})).report, 0), rows(all, 1));
  EXPECT_EQ(rows(run_text(text, with(&AuditOptions::parts, Ids{2, 3})).report, 0), rows(all, 0));
}

TEST(AuditOptions, ContactsLeftOutMoveNothing) {
  // Contact 20 finds its nodes only after contact 10 has moved them.
  EXPECT_EQ(found("contact_chain", {}), 18u);
  EXPECT_EQ(found("contact_chain", with(&AuditOptions::contacts, Ids{10})), 9u);
  EXPECT_EQ(found("contact_chain", with(&AuditOptions::contacts, Ids{20})), 0u);
  // All contacts stay listed.
  EXPECT_EQ(run_data("contact_chain", with(&AuditOptions::contacts, Ids{20})).report.contacts.size(), 2u);
}

std::string statistic(const AuditRun& run, std::string_view wanted) {
  for (const auto& [name, value] : run.report.statistics)
    if (name == wanted) return value;
  return "missing";
}

TEST(AuditOptions, FilesOfAnEarlierDeckAreCountedWhereThereAreAny) {
  EXPECT_EQ(statistic(run_data("two_plates", {}), "files read"), "1");
  EXPECT_EQ(statistic(run_data("two_plates", {}), "files read before in this call"), "missing");
}

TEST(AuditOptions, RulesThatNeedNoSearchStartNone) {
  const AuditRun references = run_data("two_plates", with(&AuditOptions::select, Names{"GC501", "GC502"}));
  EXPECT_EQ(statistic(references, "searches"), "0");
  EXPECT_EQ(statistic(references, "contact surfaces built"), "0");
  // The rules of the mesh look at what is in contact, once for all of them.
  const AuditRun mesh = run_data("two_plates", with(&AuditOptions::select, Names{"GC5"}));
  EXPECT_EQ(statistic(mesh, "searches"), "0");
  EXPECT_EQ(statistic(mesh, "contact surfaces built"), "1");
}

TEST(AuditOptions, SelectAndIgnore) {
  const std::string deck = "free_edge_node";  // two of GC101, two of GC106
  EXPECT_EQ(found(deck, {}), 4u);
  EXPECT_EQ(found(deck, with(&AuditOptions::select, Names{"GC101"})), 2u);
  EXPECT_EQ(found(deck, with(&AuditOptions::select, Names{"edge-zone-penetration"})), 2u);
  EXPECT_EQ(found(deck, with(&AuditOptions::select, Names{"GC1"})), 4u);
  EXPECT_EQ(found(deck, with(&AuditOptions::select, Names{"GC5"})), 0u);
  EXPECT_EQ(found(deck, with(&AuditOptions::ignore, Names{"GC106"})), 2u);
  AuditOptions both = with(&AuditOptions::select, Names{"GC1"});
  both.ignore = {"GC101"};
  EXPECT_EQ(found(deck, both), 2u);
}

TEST(AuditReport, IsSortedByContactDepthAndNode) {
  for (const char* name : {"two_plates_tilted", "two_plates_crossing", "contact_chain", "thickness_optt"}) {
    const auto& list = run_data(name, {}).report.penetrations;
    ASSERT_FALSE(list.empty());
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end(), [](const Penetration& a, const Penetration& b) {
      if (a.contact != b.contact) return a.contact < b.contact;
      return a.depth != b.depth ? a.depth > b.depth : a.node < b.node;
    })) << name;
  }
}

TEST(AuditReport, SummariesCountTheRecords) {
  for (const char* name : {"two_plates", "two_plates_crossing", "free_edge_node", "contact_chain"}) {
    const AuditRun run = run_data(name, {});
    ASSERT_EQ(run.report.contacts.size(), std::string(name) == "contact_chain" ? 2u : 1u);
    for (std::size_t c = 0; c < run.report.contacts.size(); ++c) {
      const auto count = [&](PenetrationKind kind) {
        return static_cast<std::uint64_t>(
            std::count_if(run.report.penetrations.begin(), run.report.penetrations.end(),
                          [&](const Penetration& p) { return p.contact == c && p.kind == kind; }));
      };
      const auto& contact = run.report.contacts[c];
      EXPECT_EQ(contact.penetrations, count(PenetrationKind::initial)) << name;
      EXPECT_EQ(contact.released, count(PenetrationKind::released)) << name;
      EXPECT_EQ(contact.edge_zone, count(PenetrationKind::edge_zone)) << name;
      double deepest = 0;
      for (const Penetration& p : run.report.penetrations)
        if (p.contact == c && p.kind == PenetrationKind::initial) deepest = std::max(deepest, p.depth);
      EXPECT_EQ(contact.max_penetration, deepest) << name;
    }
  }
}

TEST(AuditReport, KnowsFileAndLineOfNodes) {
  const AuditRun run = run_data("include_parameter", {});
  ASSERT_EQ(run.report.penetrations.size(), 18u);
  for (const auto& p : run.report.penetrations) {
    ASSERT_LT(p.file, run.report.files.size());
    EXPECT_TRUE(run.report.files[p.file].ends_with("plates_mesh.k")) << run.report.files[p.file];
    // Nodes stand one by one from line 4 of the include on: 16 of part 1, then 16 of part 2.
    const std::uint32_t place =
        p.node < 2000 ? static_cast<std::uint32_t>(p.node - 1001) : static_cast<std::uint32_t>(p.node - 2001 + 16);
    EXPECT_EQ(p.line, 4 + place);
  }
}

}  // namespace
}  // namespace gapcheck::audit_test::audit_test
