// What the solver does with the nodes that it finds penetrating in its first cycle is what the audit says: on every
// deck of data/ and on decks by other authors where they are at hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "contact/tie/record_tie.hpp"
#include "keyword/deck.hpp"
#include "results/log/solver_log.hpp"
#include "results/log/write_messag.hpp"
#include "solver/contact/contact_forces.hpp"
#include "solver/tie/tie_constraints.hpp"
#include "solver/tie/tie_forces.hpp"

namespace gapcheck::solver::cycle_zero_test {
namespace {

namespace fs = std::filesystem;

/// A deck, what the audit finds in it, and the solver's contacts in their first cycle.
struct CycleZero {
  explicit CycleZero(const std::string& path) {
    Diagnostics diagnostics;
    auto deck = keyword::read_deck(path, {}, diagnostics);
    if (!deck) {
      ADD_FAILURE() << deck.error().message;
      return;
    }
    auto read = model::read_model(deck.value(), diagnostics);
    if (!read) {
      ADD_FAILURE() << read.error().message;
      return;
    }
    model = std::move(read).value();
    surfaces.emplace(model);
    contact::InitialCounters counters;
    contact::InitialOptions options;
    options.segments = true;
    audit = contact::initialise_contacts(model, *surfaces, options, counters);
  }

  /// The first cycle from coordinates `x` with what the audit has found (`found`: all, or nothing), all at rest.
  void first_cycle(const std::vector<Vector>& x, bool knows) {
    contact::InitialState start = audit;
    start.x = x;
    if (!knows) start.penetrations.clear();
    const std::size_t nodes = x.size();
    state.x = x;
    state.v.assign(nodes, Vector::Zero());
    state.coming = state.manual_step = 1e-6;
    forces.resize(nodes);
    contacts.emplace(model, *surfaces, start, std::vector<bool>(nodes, true));
    contacts->add(state, forces);
  }

  model::Model model;
  std::optional<contact::SurfaceStore> surfaces;
  contact::InitialState audit;
  State state;
  Forces forces;
  std::optional<ContactForces> contacts;
};

using Key = std::pair<std::uint32_t, std::int64_t>;  ///< position of the contact, node id

/// By contact and node: outcome and depth.
using List = std::map<Key, std::pair<Outcome, double>>;

List audit_list(const CycleZero& run) {
  List list;
  for (const Penetration& p : run.audit.penetrations)
    if ((listed_by_solver(p.kind) || p.kind == PenetrationKind::segment) &&
        ContactForces::calculates(run.model.contacts[p.contact]) && p.outcome != Outcome::moved)
      list[{p.contact, p.node}] = {p.outcome, p.depth};
  return list;
}

List solver_list(const CycleZero& run) {
  List list;
  for (std::size_t i = 0; i < run.contacts->states().size(); ++i) {
    const std::uint32_t contact = run.contacts->states()[i].contact.value;
    for (const ContactNode& node : run.contacts->nodes(i)) {
      const Outcome outcome = node.kind == ContactNode::Kind::released ? Outcome::released
                              : node.kind == ContactNode::Kind::kept   ? Outcome::kept
                                                                       : Outcome::forced;
      list[{contact, run.model.mesh.nodes.id[node.node.value]}] = {outcome, node.penetration};
    }
  }
  return list;
}

std::string text(const List& list) {
  std::string all;
  for (const auto& [key, what] : list)
    all += fmt::format("contact {} node {} {} {:.17g}\n", key.first, key.second, name(what.first), what.second);
  return all;
}

/// True if only contacts that the solver calculates have moved nodes: no ties, no edges.
bool all_calculated(const CycleZero& run) {
  for (std::size_t i = 0; i < run.audit.contacts.size(); ++i) {
    const ContactSummary& found = run.audit.contacts[i];
    if (found.ties + found.penetrations > 0 && !ContactForces::calculates(run.model.contacts[i])) return false;
  }
  return true;
}

/// A structure of single nodes of mass 1, so that decks count whose parts the solver does not know.
Structure loose_nodes(const CycleZero& run) {
  const std::size_t nodes = run.audit.x.size();
  Structure structure;
  State& state = structure.state;
  state.x = run.audit.x;
  state.v.assign(nodes, Vector::Zero());
  state.w = state.v;
  state.mass.assign(nodes, 1);
  state.inertia.assign(nodes, 1);
  state.coming = state.manual_step = 1e-6;
  structure.constraints.resize(nodes);
  structure.rigid.resize(nodes);
  return structure;
}

/// What is tied in the first cycle: contact and node ids of a source.
std::set<Key> tied_nodes(const CycleZero& run, const ContactSource& source) {
  std::set<Key> list;
  for (std::size_t i = 0; i < source.states().size(); ++i)
    for (const ContactNode& node : source.nodes(i))
      if (node.kind == ContactNode::Kind::tied)
        list.insert({source.states()[i].contact.value, run.model.mesh.nodes.id[node.node.value]});
  return list;
}

/// The solver ties the nodes that the audit calls tied, by constraints or by springs as it says, and the message file
/// of a run says of the others what the audit says.
void expect_same_ties(const CycleZero& run, contact::SurfaceStore& surfaces) {
  std::set<Key> by_constraint, by_spring;
  Report report;
  report.contacts = run.audit.contacts;
  for (const contact::JudgedNode& judged : run.audit.judged) {
    const model::Contact& contact = run.model.contacts[judged.contact.value];
    const ContactMethod method = choose_method(contact).method;
    const std::int64_t node = run.model.mesh.nodes.id[judged.node.value];
    if (!judged.tied()) report.tie_failures.push_back(contact::record_tie(judged, run.model));
    if (!judged.tied() || (method != ContactMethod::tie && method != ContactMethod::tiebreak)) continue;
    const bool constraint = contact::ties_by_constraint(contact::classify(contact)) && !judged.penalty;
    (constraint ? by_constraint : by_spring).insert({judged.contact.value, node});
  }
  const Structure structure = loose_nodes(run);
  State state = structure.state;
  Diagnostics diagnostics;
  TieForces springs(run.model, surfaces, run.audit, structure);
  TieConstraints constraints(run.model, surfaces, run.audit, structure, diagnostics);
  Forces net, external;
  net.resize(state.x.size());
  external.resize(state.x.size());
  springs.add(state, net);
  constraints.react(state, 5e-7, 1e-6, net, external);
  EXPECT_EQ(tied_nodes(run, constraints), by_constraint);
  EXPECT_EQ(tied_nodes(run, springs), by_spring);

  std::multiset<std::tuple<std::int64_t, std::int64_t, TieReason>> said, meant;
  const Report read = results::read_solver_log_text(results::message_blocks(report), "messag", {}, diagnostics);
  for (const TieFailure& failure : read.tie_failures)
    said.insert({read.contacts.at(failure.contact).id, failure.node, failure.reason});
  for (const TieFailure& failure : report.tie_failures)
    meant.insert({report.contacts.at(failure.contact).id, failure.node, failure.reason});
  EXPECT_EQ(said, meant);
  testing::Test::RecordProperty("tied", static_cast<int>(by_constraint.size() + by_spring.size()));
  testing::Test::RecordProperty("untied", static_cast<int>(meant.size()));
}

void expect_same(const std::string& path) {
  CycleZero run(path);
  if (!run.surfaces) return;
  expect_same_ties(run, *run.surfaces);
  // From the deck's own coordinates: the solver finds all by itself, and moves the nodes where the audit says.
  if (all_calculated(run)) {
    run.first_cycle(run.model.mesh.nodes.x, false);
    EXPECT_EQ(text(solver_list(run)), text(audit_list(run)));
    for (std::size_t i = 0; i < run.state.x.size(); ++i)
      EXPECT_EQ(run.state.x[i], run.audit.x[i]) << "node " << run.model.mesh.nodes.id[i];
  }
  // From where the initialisation has put the nodes: what it kept, forced or released is so in the first cycle.
  run.first_cycle(run.audit.x, true);
  const List found = solver_list(run);
  for (const auto& [key, what] : audit_list(run)) {
    const auto same = found.find(key);
    if (same == found.end()) {
      ADD_FAILURE() << "contact " << key.first << " node " << key.second << " " << name(what.first) << " is not found";
      continue;
    }
    EXPECT_EQ(name(same->second.first), name(what.first)) << key.second;
  }
}

std::vector<std::string> data_decks() {
  std::vector<std::string> names;
  for (const std::string folder : {"", "workshop/"})
    for (const auto& entry : fs::directory_iterator(fs::path(GAPCHECK_ROOT) / "data" / folder))
      if (entry.path().extension() == ".k") names.push_back(folder + entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

class DataDeck : public testing::TestWithParam<std::string> {};
TEST_P(DataDeck, AuditIsCycleZero) { expect_same((fs::path(GAPCHECK_ROOT) / "data" / GetParam()).string()); }
INSTANTIATE_TEST_SUITE_P(CycleZero, DataDeck, testing::ValuesIn(data_decks()), test_name);

class RealDeck : public testing::TestWithParam<std::string> {};
TEST_P(RealDeck, AuditIsCycleZero) {
  const fs::path folder = fs::path(GAPCHECK_ROOT) / ".." / "shared" / "decks";
  if (!fs::exists(folder)) GTEST_SKIP() << "no decks in " << folder << "; put them there to run this test";
  expect_same((folder / GetParam()).lexically_normal().string());
}
INSTANTIATE_TEST_SUITE_P(CycleZero, RealDeck,
                         testing::Values("ball_plate/ball_plate.k", "bird_on_panel/bird.k",
                                         "bird_strike_composite/input.k", "birdball_eroding/birdball.k", "car5/car5.k",
                                         "car6/car6_crash.k", "car6_refined/lsopt_car6/main_v22.k",
                                         "car6_refined/lsopt_car6/main_v222.k", "roll_forming/model.k",
                                         "small_decks/tests/testfiles/run/case-keywords/projectile.k",
                                         "tied_plate_with_run/main.k", "two_body_impact/main.k"),
                         test_name);

}  // namespace
}  // namespace gapcheck::solver::cycle_zero_test
