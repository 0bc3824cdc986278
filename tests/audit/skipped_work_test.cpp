// What an audit leaves out, by its own counters: on scenes of which it is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "audit/audit.hpp"
#include "audit/registry.hpp"
#include "audit/run.hpp"
#include "audit/scene.hpp"

namespace gapcheck::audit_test::skipped_work_test {
namespace {

using audit::AuditOptions;

/// The counters of a run by name. Those that are printed only where they are not 0 are 0 when missing.
class Counters {
 public:
  explicit Counters(const AuditRun& run) {
    EXPECT_TRUE(clean(run)) << describe(run.diagnostics);
    for (const auto& [name, value] : run.report.statistics)
      if (value.find_first_not_of("0123456789") == std::string::npos) counters_[name] = std::stoull(value);
  }
  std::uint64_t operator[](const std::string& name) const {
    const auto found = counters_.find(name);
    EXPECT_TRUE(found != counters_.end() || name.find("another thickness") != std::string::npos) << name;
    return found == counters_.end() ? 0 : found->second;
  }
  [[nodiscard]] std::uint64_t decisions() const {
    return (*this)["decided by the filter"] + (*this)["decided by intervals"] + (*this)["decided exactly"];
  }

 private:
  std::map<std::string, std::uint64_t> counters_;
};

AuditOptions only(std::vector<std::string> rules, std::vector<std::int64_t> contacts = {}) {
  AuditOptions options;
  options.select = std::move(rules);
  options.contacts = std::move(contacts);
  return options;
}

Counters counters(const Scene& scene, const AuditOptions& options = {}) {
  return Counters(run_text(scene.text(), options));
}

/// `plates` plates of 2 × 2 shells of 10 × 10 and 1 thick, `gap` apart; part set i has part i.
Scene stack(int plates, double gap) {
  Scene scene;
  for (int p = 1; p <= plates; ++p) {
    scene.parts.push_back({p, false, 1.0});
    scene.sets.push_back({p, {p}});
    const auto id = [&](int i, int j) { return std::int64_t{100} * p + 3 * j + i + 1; };
    for (int j = 0; j <= 2; ++j)
      for (int i = 0; i <= 2; ++i) scene.nodes.push_back({id(i, j), Vector(10 * i + p, 10 * j + p, gap * p)});
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        scene.elements.push_back(
            {std::int64_t{10} * p + 2 * j + i, p, {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)}});
  }
  return scene;
}

void add_contact(Scene& scene, std::int64_t id, const std::string& keyword, std::int64_t a, std::int64_t b) {
  Scene::Contact contact;
  contact.id = id;
  contact.keyword = keyword;
  contact.set_a = a;
  contact.set_b = b;
  scene.contacts.push_back(contact);
}

/// Rules on decks for whose needs `holds` is true.
AuditOptions rules_with(const std::function<bool(const RuleNeeds&)>& holds) {
  AuditOptions options;
  for (const RuleIdentity& rule : audit::rules())
    if (!rule.of_runs() && !rule.of_ignores() && holds(rule.needs)) options.select.emplace_back(rule.id);
  return options;
}

TEST(SkippedWork, PartsThatLieFarApartAreCulledByTheirBoxes) {
  Scene scene = stack(2, 1000);
  add_contact(scene, 1, "AUTOMATIC_SURFACE_TO_SURFACE", 1, 2);
  for (const AuditOptions& options : {only({"GC101"}), AuditOptions{}}) {
    const Counters c = counters(scene, options);
    EXPECT_EQ(c["contacts searched"], 1u);
    EXPECT_EQ(c["contacts culled by boxes"], 1u);
    EXPECT_EQ(c["searches"], 2u) << "each side's nodes in the other";
    EXPECT_EQ(c["searches culled by boxes"], 2u);
    EXPECT_EQ(c["nodes culled by boxes"], 18u);
    EXPECT_EQ(c["segments culled by boxes"], 8u);
    EXPECT_EQ(c["candidate pairs"], 0u);
    EXPECT_EQ(c.decisions(), 0u);
    EXPECT_EQ(c["contact surfaces built"], 1u);
    EXPECT_EQ(c["surfaces built with another thickness"], 0u);
  }
}

TEST(SkippedWork, PartsThatLieFarApartInOneSurfaceGiveNoPairs) {
  Scene scene = stack(2, 1000);
  add_contact(scene, 1, "AUTOMATIC_SINGLE_SURFACE", 0, 0);
  const Counters c = counters(scene);
  EXPECT_EQ(c["contacts searched"], 1u);
  EXPECT_EQ(c["contacts culled by boxes"], 0u) << "its nodes lie in the boxes of their own segments";
  EXPECT_EQ(c["candidate pairs"], 0u);
  EXPECT_EQ(c.decisions(), 0u);
}

TEST(SkippedWork, OnlyTheContactsThatAreApartAreCulled) {
  Scene scene = stack(3, 0.75);
  for (auto& node : scene.nodes)
    if (node.id > 300) node.x.z() += 1000;
  add_contact(scene, 1, "AUTOMATIC_SURFACE_TO_SURFACE", 1, 2);
  add_contact(scene, 2, "AUTOMATIC_SURFACE_TO_SURFACE", 1, 3);
  add_contact(scene, 3, "TIED_SURFACE_TO_SURFACE_OFFSET", 2, 3);
  const Counters c = counters(scene);
  EXPECT_EQ(c["contacts searched"], 3u);
  EXPECT_EQ(c["contacts culled by boxes"], 2u);
  EXPECT_GT(c["candidate pairs"], 0u);
  EXPECT_EQ(c.decisions(), c["candidate pairs"]) << "every candidate is decided once";
}

TEST(SkippedWork, WithoutContactsNoSurfaceIsBuiltByAnyRule) {
  const Counters c = counters(stack(2, 0.75));
  EXPECT_EQ(c["rules run"], rules_with([](const RuleNeeds&) { return true; }).select.size());
  EXPECT_EQ(c["contact surfaces built"], 0u);
  EXPECT_EQ(c["surfaces built with another thickness"], 0u);
  EXPECT_EQ(c["contacts searched"], 0u);
  EXPECT_EQ(c["searches"], 0u);
  EXPECT_EQ(c["candidate pairs"], 0u);
  EXPECT_EQ(c.decisions(), 0u);
  EXPECT_EQ(c["element pairs with boxes that meet"], 0u);
}

TEST(SkippedWork, OnlyTheChosenContactIsBuilt) {
  Scene scene = stack(4, 0.75);
  add_contact(scene, 1, "AUTOMATIC_SURFACE_TO_SURFACE", 1, 2);
  add_contact(scene, 2, "AUTOMATIC_SURFACE_TO_SURFACE", 2, 3);
  add_contact(scene, 3, "AUTOMATIC_NODES_TO_SURFACE", 4, 3);
  EXPECT_EQ(counters(scene, only({"GC101"}, {3}))["contact surfaces built"], 1u);
  const AuditRun run = run_text(scene.text(), only({}, {3}));
  const Counters c(run);
  EXPECT_EQ(c["contact surfaces built"], 1u) << "no rule builds the others";
  EXPECT_EQ(c["contacts searched"], 1u);
  EXPECT_EQ(c["searches"], 2u) << "one, and one more for the nodes that it moves";
  ASSERT_EQ(run.report.contacts.size(), 3u);
  EXPECT_EQ(run.report.contacts[2].tracked_nodes, 9u);
  EXPECT_EQ(run.report.contacts[2].segments, 4u);
  for (const std::size_t other : {0u, 1u}) EXPECT_EQ(run.report.contacts[other].segments, 0u);
  const auto& statistics = run.report.statistics;
  EXPECT_EQ(std::count_if(statistics.begin(), statistics.end(),
                          [](const auto& line) { return line.second.starts_with("GC415: "); }),
            1)
      << "parts in no contact would take all of them, and the report says that they were not looked for";
}

TEST(SkippedWork, OneRuleDoesNothingForOthers) {
  Scene scene = stack(2, 0.75);
  add_contact(scene, 1, "AUTOMATIC_SINGLE_SURFACE", 0, 0);
  scene.contacts[0].sst = 0.5;    // there are rules that would look at other thicknesses
  scene.nodes.back().x.z() -= 2;  // through the other plate
  const Counters alone = counters(scene, only({"GC101"}));
  EXPECT_EQ(alone["rules run"], 1u);
  EXPECT_EQ(alone["rules that asked for no surface and no search"], 0u);
  EXPECT_EQ(alone["contact surfaces built"], 1u);
  EXPECT_EQ(alone["searches"], 1u);
  EXPECT_EQ(alone["surfaces built with another thickness"], 0u);
  EXPECT_EQ(alone["element pairs with boxes that meet"], 0u) << "the crossings are other rules'";

  const Counters all = counters(scene);
  EXPECT_EQ(all["rules run"], rules_with([](const RuleNeeds&) { return true; }).select.size());
  EXPECT_EQ(all["searches"], 1u) << "one for all of them";
  EXPECT_GT(all["surfaces built with another thickness"], 0u);
  EXPECT_GT(all["element pairs with boxes that meet"], 0u);
}

TEST(SkippedWork, RulesOnCardsAskForNoSurface) {
  Scene scene = stack(2, 0.75);
  add_contact(scene, 1, "AUTOMATIC_SINGLE_SURFACE", 0, 0);
  const Counters c = counters(scene, only({"GC501", "GC502", "unknown-contact"}));
  EXPECT_EQ(c["rules run"], 3u);
  EXPECT_EQ(c["rules that asked for no surface and no search"], 3u);
  EXPECT_EQ(c["contact surfaces built"], 0u);
  EXPECT_EQ(c["searches"], 0u);
}

TEST(SkippedWork, RulesAskForNothingThatTheyDoNotDeclare) {
  const AuditOptions model_alone = rules_with([](const RuleNeeds& needs) { return needs == Need::model; });
  const AuditOptions no_search = rules_with([](const RuleNeeds& needs) {
    return !needs.has(Need::node_penetrations) && !needs.has(Need::segment_penetrations) &&
           !needs.has(Need::mortar_penetrations) && !needs.has(Need::edge_penetrations) &&
           !needs.has(Need::moved_nodes) && !needs.has(Need::intended_overlaps) && !needs.has(Need::ties);
  });
  const AuditOptions no_crossings = rules_with([](const RuleNeeds& needs) { return !needs.has(Need::crossings); });
  ASSERT_GT(model_alone.select.size(), 10u);
  ASSERT_GT(no_search.select.size(), model_alone.select.size());
  std::size_t decks = 0;
  for (const auto& entry : std::filesystem::directory_iterator(GAPCHECK_ROOT "/data")) {
    if (entry.path().extension() != ".k") continue;
    ++decks;
    const std::string deck = entry.path().string();
    SCOPED_TRACE(deck);
    const Counters cards(run_file(deck, model_alone));
    EXPECT_EQ(cards["rules run"], model_alone.select.size());
    EXPECT_EQ(cards["rules that asked for no surface and no search"], model_alone.select.size());
    EXPECT_EQ(cards["contact surfaces built"], 0u);
    const Counters surfaces(run_file(deck, no_search));
    EXPECT_EQ(surfaces["rules run"], no_search.select.size());
    EXPECT_EQ(surfaces["searches"], 0u);
    EXPECT_EQ(surfaces["surfaces built with another thickness"], 0u);
    EXPECT_EQ(Counters(run_file(deck, no_crossings))["element pairs with boxes that meet"], 0u);
  }
  EXPECT_GT(decks, 20u);
}

TEST(SkippedWork, UnknownKeywordsAreSkippedByTheByte) {
  const std::string first = "$ what nobody reads\n         1         2\n0.0,1.0\n", second = "anything at all\n";
  const std::string known = stack(1, 0).text();
  const std::string begin = known.substr(0, known.find('\n') + 1), rest = known.substr(begin.size());
  const std::string deck = begin + "*DEFINE_SD_ORIENTATION\n" + first + "*NO_SUCH_KEYWORD\n" + second +
                           "*DEFINE_SD_ORIENTATION\n" + first + rest;
  const Counters before(run_text(known)), after(run_text(deck));
  EXPECT_EQ(after["bytes read"], deck.size());
  EXPECT_EQ(after["bytes skipped unparsed"] - before["bytes skipped unparsed"], 2 * first.size() + second.size());
  EXPECT_EQ(after["keyword skipped: DEFINE_SD_ORIENTATION"], 2u);
  EXPECT_EQ(after["keyword skipped: NO_SUCH_KEYWORD"], 1u);
}

}  // namespace
}  // namespace gapcheck::audit_test::skipped_work_test
