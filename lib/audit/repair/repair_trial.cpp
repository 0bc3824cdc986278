#include "audit/repair/repair_trial.hpp"

#include <algorithm>
#include <numeric>

#include "audit/repair/repair_cards.hpp"
#include "audit/untangle/crossing_pairs.hpp"

namespace gapcheck::audit {
namespace {

/// The first error of a deck that was read again.
Status first_error(const Diagnostics& diagnostics) {
  for (const Diagnostic& each : diagnostics.sorted())
    if (each.severity == Severity::error) return each;
  return {};
}

Result<model::Model> read(const Reread& reread, const std::map<std::string, std::string>& texts,
                          Result<keyword::Deck>& deck) {
  Diagnostics diagnostics;
  deck = reread(texts, diagnostics);
  if (!deck) return deck.error();
  auto model = model::read_model(deck.value(), diagnostics);
  if (!model) return model;
  if (const Status status = first_error(diagnostics); !status.ok()) return status.error();
  return model;
}

}  // namespace

RepairParts parts_of(const model::Model& model, const Penetration& record) {
  return {model.contact(ContactIndex{record.contact}).id.value, std::min(record.part, record.element_part),
          std::max(record.part, record.element_part)};
}

std::uint64_t DeckState::all_too_far() const {
  return std::accumulate(too_far.begin(), too_far.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& contact) { return sum + contact.second; });
}

contact::InitialState find_penetrations(const model::Model& model) {
  contact::InitialOptions options;
  options.nodes_stay = true;
  options.repeated = false;
  options.segments = options.mortar = options.edges = true;
  contact::SurfaceStore surfaces(model);
  contact::InitialCounters counters;
  return contact::initialise_contacts(model, surfaces, options, counters);
}

DeckState judge_deck(const model::Model& model, const contact::InitialState& found) {
  DeckState state;
  for (const model::Contact& contact : model.contacts) state.contacts.push_back({contact.id.value, contact.keyword});
  for (const Penetration& record : found.penetrations) {
    if (!to_be_repaired(record.kind)) continue;
    const bool kept = record.outcome == Outcome::kept;
    AppliedRepairs::Contact& contact = state.contacts[record.contact];
    const RepairParts parts = parts_of(model, record);
    if (!kept) state.nodes.push_back({record.contact, record.node, parts});
    for (DeckState::Count* count : {&state.pairs[parts], &state.all}) ++(kept ? count->forgiven : count->left);
    ++(kept ? contact.forgiven : contact.after);
  }
  for (const contact::JudgedNode& node : found.judged) {
    if (node.tied()) state.tied.push_back(model.mesh.nodes.id[node.node.value]);
    if (node.reason == TieReason::too_far) ++state.too_far[model.contact(node.contact).id.value];
  }
  std::sort(state.tied.begin(), state.tied.end());
  std::sort(state.nodes.begin(), state.nodes.end());
  state.crossings = crossing_pairs(model).size();
  return state;
}

Result<RepairedDeck> RepairTrial::of(const RepairSettings& settings) const {
  DeckEdits edits(deck_);
  if (const Status status = write_cards(deck_, model_, settings, edits); !status.ok()) return status.error();
  RepairedDeck repaired;
  const std::vector<ChangedLines> changed = edits.changed();
  repaired.texts = changed_texts(deck_, changed);
  repaired.lines = edits.listed();
  for (const ChangedLines& file : changed) repaired.changed[deck_.file(file.file).path] += file.edits.size();
  if (settings.move)
    if (const Status status = move(repaired); !status.ok()) return status.error();
  Result<keyword::Deck> deck = plain_error("");
  auto model = read(reread_, repaired.texts, deck);
  if (!model) return model.error();
  repaired.state = judge_deck(model.value(), find_penetrations(model.value()));
  return repaired;
}

/// Moves the nodes of the deck with the texts so far, which change again.
Status RepairTrial::move(RepairedDeck& repaired) const {
  Diagnostics diagnostics;
  const auto deck = reread_(repaired.texts, diagnostics);
  if (!deck) return deck.error();
  FixOptions options = options_;
  options.proposals = false;
  auto fix = fix_penetrations(deck.value(), options, diagnostics);
  if (!fix) return fix.error();
  if (Status status = first_error(diagnostics); !status.ok()) return status;
  repaired.moves = std::move(fix.value().report);
  auto texts = changed_texts(deck.value(), fix.value().files);
  for (const ChangedLines& file : fix.value().files)
    repaired.changed[deck.value().file(file.file).path] += file.edits.size();
  // The deck that was read again has views into the texts so far.
  for (auto& [path, text] : texts) repaired.texts[path] = std::move(text);
  return {};
}

}  // namespace gapcheck::audit
