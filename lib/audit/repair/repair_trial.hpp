#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "audit/fix/fix.hpp"
#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "contact/initial.hpp"
#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "records/repair_plan.hpp"

namespace gapcheck::audit {

/// Reads a deck again with other texts in place of some of its files, by their paths as read.
using Reread =
    std::function<Result<keyword::Deck>(const std::map<std::string, std::string>& texts, Diagnostics& diagnostics)>;

/// What contacts, judged all together on the deck's coordinates, find in a deck.
struct DeckState {
  struct Count {
    std::uint64_t left = 0;      ///< penetrations that are moved, pushed or released
    std::uint64_t forgiven = 0;  ///< that stay without force
  };
  /// A node, or the corner of a segment or end of an edge, that is moved, pushed or released.
  struct Node {
    std::uint32_t contact = 0;  ///< position in the model's list
    std::int64_t node = 0;
    RepairParts parts;
    auto operator<=>(const Node&) const = default;
  };
  std::map<RepairParts, Count> pairs;  ///< the part with the smaller id first
  std::vector<Node> nodes;             ///< ascending
  Count all;
  std::vector<AppliedRepairs::Contact> contacts;  ///< counts in `after` and `forgiven`
  std::uint64_t crossings = 0;                    ///< pairs of elements
  std::vector<std::int64_t> tied;                 ///< nodes, ascending, once for each tie
  std::map<std::int64_t, std::uint64_t> too_far;  ///< nodes of tied contacts that are too far away, by contact id
  [[nodiscard]] std::uint64_t all_too_far() const;
};

/// True for all records but notes: nodes, segments and edges (GC101, GC102, GC107 to GC109).
[[nodiscard]] constexpr bool to_be_repaired(PenetrationKind kind) { return kind != PenetrationKind::edge_zone; }

/// What contacts, judged all together on the model's coordinates, find at the start.
[[nodiscard]] contact::InitialState find_penetrations(const model::Model& model);

/// The parts of a record, the smaller id first.
[[nodiscard]] RepairParts parts_of(const model::Model& model, const Penetration& record);

/// Judges a model. `found`: what find_penetrations() finds in it.
[[nodiscard]] DeckState judge_deck(const model::Model& model, const contact::InitialState& found);

/// A repaired deck.
struct RepairedDeck {
  std::map<std::string, std::string> texts;  ///< of the files that change, by path
  DeckState state;
  FixReport moves;                               ///< where nodes were moved
  std::vector<RepairLine> lines;                 ///< except those of moved nodes
  std::map<std::string, std::uint64_t> changed;  ///< lines by path
};

/// Tries repairs: writes them into the text of the deck's files, reads it again as it would be written, moves nodes if
/// they say so, and judges the result. All references must outlive it.
class RepairTrial {
 public:
  /// `model`: of this deck. `options`: for moves.
  RepairTrial(const keyword::Deck& deck, const model::Model& model, const FixOptions& options, const Reread& reread)
      : deck_(deck), model_(model), options_(options), reread_(reread) {}
  /// Errors: a card that cannot be changed, or a deck that cannot be read any more.
  [[nodiscard]] Result<RepairedDeck> of(const RepairSettings& settings) const;

 private:
  Status move(RepairedDeck& repaired) const;
  const keyword::Deck& deck_;
  const model::Model& model_;
  const FixOptions& options_;
  const Reread& reread_;
};

}  // namespace gapcheck::audit
