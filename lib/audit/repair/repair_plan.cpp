#include "audit/repair/repair_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "audit/repair/repair_cards.hpp"
#include "audit/repair/repair_list.hpp"

namespace gapcheck::audit {
namespace {

/// A deck as it is: its model, what contacts find, and the repairs.
struct Start {
  model::Model model;
  DeckState state;
  contact::InitialState found;
  std::vector<RepairPair> pairs;
};

Result<Start> begin(const keyword::Deck& deck, Diagnostics& diagnostics) {
  if (const Status status = check_geometry(deck); !status.ok()) return status.error();
  auto model = model::read_model(deck, diagnostics);
  if (!model) return model.error();
  keyword::note_missing_end(deck, diagnostics);
  model::report_unknown_keywords(model.value(), diagnostics);
  if (diagnostics.has_errors()) return plain_error("the deck has errors; correct them first");
  Start start;
  start.model = std::move(model).value();
  std::set<std::int64_t> ids;
  for (const model::Contact& contact : start.model.contacts)
    if (!ids.insert(contact.id.value).second)
      return Diagnostic{Severity::error, deck.file(contact.place.file).path, contact.place.line,
                        fmt::format("another contact has the id {}; give each its own, since repairs are chosen by id",
                                    contact.id.value)};
  start.found = find_penetrations(start.model);
  start.state = judge_deck(start.model, start.found);
  start.pairs = list_repairs(start.model, start.found);
  return start;
}

void leave_out_moves(std::vector<RepairPair>& pairs) {
  for (RepairPair& pair : pairs)
    std::erase_if(pair.repairs, [](const Repair& repair) { return repair.kind == RepairKind::move; });
}

/// Why a repair cannot be done.
std::string refusal(const Diagnostic& why) {
  return why.file.empty() ? why.message : fmt::format("{}:{}: {}", why.file, why.line, why.message);
}

std::uint64_t more(std::uint64_t now, std::uint64_t before) { return now > before ? now - before : 0; }

std::uint64_t elements(const model::Mesh& mesh) {
  return mesh.shells.size() + mesh.solids.size() + mesh.thick_shells.size() + mesh.beams.size();
}

/// What a repaired deck is like for one pair of parts.
class Judge {
 public:
  Judge(const Start& start, const RepairPair& pair) : start_(start), pair_(pair) {}

  [[nodiscard]] RepairOutcome outcome(const RepairedDeck& deck, const RepairSettings& settings) const {
    const DeckState &now = deck.state, &then = start_.state;
    const DeckState::Count here = count(now);
    RepairOutcome outcome;
    // Only IGNORE itself means that penetrations stay.
    const bool forgives = !settings.ignore.empty();
    outcome.left = pair_.of_ties ? too_far(now) : here.left + (forgives ? 0 : here.forgiven);
    outcome.forgiven = forgives ? here.forgiven : 0;
    outcome.added = new_nodes(now);
    outcome.lost_ties = more(then.tied.size(), now.tied.size());
    for (const RepairParts& tie : settings.tied) outcome.untied += untied(tie.a, now);
    outcome.crossings = more(now.crossings, then.crossings);
    outcome.moved = deck.moves.moved.size();
    for (const MovedNode& node : deck.moves.moved)
      if (of_pair(node.node)) outcome.largest_move = std::max(outcome.largest_move, node.distance());
    if (const std::uint64_t all = elements(start_.model.mesh); all > 0)
      outcome.changed_elements = static_cast<double>(deck.moves.elements_touched) / static_cast<double>(all);
    return outcome;
  }

 private:
  [[nodiscard]] std::uint64_t too_far(const DeckState& state) const {
    const auto found = state.too_far.find(pair_.parts.contact);
    return found == state.too_far.end() ? 0 : found->second;
  }

  [[nodiscard]] DeckState::Count count(const DeckState& state) const {
    const auto found = state.pairs.find(pair_.parts);
    return found == state.pairs.end() ? DeckState::Count{} : found->second;
  }

  /// Nodes that penetrate other parts than the two, and did not penetrate these before in the same contact.
  [[nodiscard]] std::uint64_t new_nodes(const DeckState& state) const {
    const auto& before = start_.state.nodes;
    return static_cast<std::uint64_t>(std::ranges::count_if(state.nodes, [&](const DeckState::Node& now) {
      return now.parts != pair_.parts && !std::ranges::binary_search(before, now);
    }));
  }

  /// Nodes of the part that penetrate the other one and are not tied.
  [[nodiscard]] std::uint64_t untied(std::int64_t tracked, const DeckState& state) const {
    const auto& all = start_.found.penetrations;
    return static_cast<std::uint64_t>(std::count_if(all.begin(), all.end(), [&](const Penetration& record) {
      return to_be_repaired(record.kind) && record.part == tracked && parts_of(start_.model, record) == pair_.parts &&
             !std::binary_search(state.tied.begin(), state.tied.end(), record.node);
    }));
  }

  [[nodiscard]] bool of_pair(std::int64_t id) const {
    if (nodes_.empty()) {
      nodes_.assign(start_.model.mesh.nodes.size(), false);
      const auto take = [&](const auto& elements) {
        for (std::size_t e = 0; e < elements.size(); ++e) {
          const std::int64_t part = start_.model.part(elements.part[e]).id.value;
          if (part != pair_.parts.a && part != pair_.parts.b) continue;
          for (const NodeIndex n : elements.nodes[e])
            if (n.value < nodes_.size()) nodes_[n.value] = true;
        }
      };
      const model::Mesh& mesh = start_.model.mesh;
      take(mesh.shells);
      take(mesh.solids);
      take(mesh.thick_shells);
      take(mesh.beams);
    }
    const auto node = start_.model.mesh.nodes.lookup.find(id);
    return node && nodes_[*node];
  }

  const Start& start_;
  const RepairPair& pair_;
  mutable std::vector<bool> nodes_;  ///< by node: of one of the two parts
};

/// Best first: what solves the pair, then what leaves the model as it is meant, then what costs least in whole
/// percents.
bool better(const Repair& a, const Repair& b) {
  const auto key = [](const Repair& r) {
    const bool solves = r.outcome.solves();
    return std::tuple(!solves, !r.outcome.refused.empty(), solves ? 0 : r.outcome.remaining(),
                      changes_the_model(r.kind), std::round(100 * r.cost), r.kind);
  };
  return key(a) < key(b);
}

/// What costs are shares of: the contact distance, or of solids, which have none, the deepest penetration.
double scale_of(const RepairPair& pair) { return pair.contact_distance > 0 ? pair.contact_distance : pair.deepest; }

class Planner {
 public:
  Planner(const Start& start, const RepairTrial& trial, RepairPlan& plan) : start_(start), trial_(trial), plan_(plan) {}

  void run() {
    for (RepairPair& pair : plan_.pairs) {
      pair.tried = pair.number <= most_repaired_pairs;
      if (!pair.tried) continue;
      const Judge judge(start_, pair);
      for (Repair& repair : pair.repairs) attempt(pair, judge, repair);
      std::ranges::stable_sort(pair.repairs, better);
    }
  }

 private:
  void attempt(const RepairPair& pair, const Judge& judge, Repair& repair) {
    // Nodes are moved for all pairs together.
    std::optional<Result<RepairedDeck>> other;
    const Result<RepairedDeck>* deck = nullptr;
    if (repair.kind == RepairKind::move) {
      if (!moved_) moved_.emplace(tried(repair.settings));
      deck = &*moved_;
    } else {
      deck = &other.emplace(tried(repair.settings));
    }
    if (!deck->ok()) {
      repair.outcome.refused = refusal(deck->error());
      return;
    }
    repair.outcome = judge.outcome(deck->value(), repair.settings);
    repair.lines = deck->value().lines;
    if (repair.kind == RepairKind::move) repair.cost = repair.outcome.largest_move / scale_of(pair);
  }

  Result<RepairedDeck> tried(const RepairSettings& settings) {
    auto deck = trial_.of(settings);
    plan_.trials += deck.ok() ? 1 : 0;
    return deck;
  }

  const Start& start_;
  const RepairTrial& trial_;
  RepairPlan& plan_;
  std::optional<Result<RepairedDeck>> moved_;
};

/// The repair of an id; nullptr if there is none.
const Repair* find(const std::vector<RepairPair>& pairs, const std::string& id) {
  for (const RepairPair& pair : pairs)
    for (const Repair& repair : pair.repairs)
      if (repair.id == id) return &repair;
  return nullptr;
}

/// The contacts before and after, those that a repair adds included.
std::vector<AppliedRepairs::Contact> compared(const DeckState& before, const DeckState& after) {
  std::vector<AppliedRepairs::Contact> contacts = after.contacts;
  for (std::size_t i = 0; i < contacts.size() && i < before.contacts.size(); ++i) {
    contacts[i].before = before.contacts[i].after;
    contacts[i].forgiven_before = before.contacts[i].forgiven;
  }
  return contacts;
}

RepairPlan untried(const Start& start) {
  RepairPlan plan;
  plan.pairs = start.pairs;
  plan.penetrating = start.state.all.left + start.state.all.forgiven;
  plan.too_far = start.state.all_too_far();
  return plan;
}

}  // namespace

Result<RepairPlan> plan_repairs(const keyword::Deck& deck, const FixOptions& options, const Reread& reread,
                                Diagnostics& diagnostics, Tried tried) {
  auto start = begin(deck, diagnostics);
  if (!start) return start.error();
  RepairPlan plan = untried(start.value());
  if (tried == Tried::cards) leave_out_moves(plan.pairs);
  const RepairTrial trial(deck, start.value().model, options, reread);
  Planner(start.value(), trial, plan).run();
  if (plan.pairs.size() > most_repaired_pairs)
    plan.notes.push_back(fmt::format("repairs of the first {} pairs of parts and ties were tried; there are {} more",
                                     most_repaired_pairs, plan.pairs.size() - most_repaired_pairs));
  return plan;
}

Result<RepairPlan> list_written_repairs(const keyword::Deck& deck, Diagnostics& diagnostics) {
  auto start = begin(deck, diagnostics);
  if (!start) return start.error();
  RepairPlan plan = untried(start.value());
  leave_out_moves(plan.pairs);
  if (plan.pairs.size() > most_listed_pairs) plan.pairs.resize(most_listed_pairs);
  DeckEdits edits(deck);
  for (RepairPair& pair : plan.pairs) {
    pair.tried = false;
    for (Repair& repair : pair.repairs) {
      edits.clear();
      if (const Status status = write_cards(deck, start.value().model, repair.settings, edits); status.ok())
        repair.lines = edits.listed();
      else
        repair.outcome.refused = refusal(status.error());
    }
  }
  return plan;
}

Result<Repaired> apply_repairs(const keyword::Deck& deck, std::span<const std::string> ids, const FixOptions& options,
                               const Reread& reread, Diagnostics& diagnostics) {
  auto begun = begin(deck, diagnostics);
  if (!begun) return begun.error();
  const Start& start = begun.value();
  RepairSettings settings;
  for (const std::string& id : ids) {
    const Repair* repair = find(start.pairs, id);
    if (repair == nullptr) return plain_error(fmt::format("there is no repair {}; gapcheck fix --plan lists them", id));
    settings.add(repair->settings);
  }
  auto deck_after = RepairTrial(deck, start.model, options, reread).of(settings);
  if (!deck_after) return deck_after.error();
  RepairedDeck& after = deck_after.value();
  Repaired repaired;
  AppliedRepairs& report = repaired.report;
  report.ids.assign(ids.begin(), ids.end());
  report.forgives = !settings.ignore.empty();
  report.contacts = compared(start.state, after.state);
  report.ties_before = start.state.tied.size();
  report.ties_after = after.state.tied.size();
  report.too_far_before = start.state.all_too_far();
  report.too_far_after = after.state.all_too_far();
  report.moved = after.moves.moved.size();
  report.largest_move = after.moves.largest_move;
  report.lines = std::move(after.lines);
  report.notes = after.moves.notes;
  for (const auto& [path, lines] : after.changed) report.files.push_back({path, "", lines});
  repaired.texts = std::move(after.texts);
  return repaired;
}

}  // namespace gapcheck::audit
