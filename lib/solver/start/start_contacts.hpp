#pragma once
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "contact/initial.hpp"
#include "records/start.hpp"
#include "solver/interface/contact_source.hpp"
#include "solver/start/start_moves.hpp"

namespace gapcheck::solver {

/// Sums up what the contacts of a model do before the first step, contact by contact and pair of parts by pair of
/// parts. All references must outlive it.
class StartContacts {
 public:
  StartContacts(const model::Model& model, const contact::InitialState& initial)
      : model_(model), initial_(initial), contacts_(model.contacts.size()), viewed_(model.contacts.size(), false) {}

  /// What a contact of the run does in its first cycle.
  void add_first_cycle(const ContactView& view);
  /// What the initialisation says about the contacts without a first cycle.
  void add_others();
  /// Moves of nodes, in their order.
  void add_moves(std::span<const NodeStep> steps);

  /// In deck order.
  [[nodiscard]] std::vector<StartContact> contacts() const;
  /// By contact and parts.
  [[nodiscard]] std::vector<StartPair> pairs() const;
  /// Nodes that penetrate, by contact, deepest first, then by node.
  [[nodiscard]] std::vector<StartNode> nodes() const;
  /// Nodes that a contact has moved, by contact and by pair, as these are listed.
  [[nodiscard]] const std::vector<std::vector<NodeIndex>>& moved_by_contact() const { return moved_by_contact_; }
  [[nodiscard]] const std::vector<std::vector<NodeIndex>>& moved_by_pair() const { return moved_by_pair_; }

 private:
  /// Position of a contact, and ids of two parts.
  using Key = std::tuple<std::uint32_t, std::int64_t, std::int64_t>;
  /// Calls `change` for the counts of the contact and of the pair.
  template <class Change>
  void count(const Key& key, const Change& change);
  /// Counts and lists a node that penetrates.
  void add(const StartNode& node);
  [[nodiscard]] std::int64_t id_of(PartIndex part) const {
    return part == none<PartIndex> ? 0 : model_.part(part).id.value;
  }

  const model::Model& model_;
  const contact::InitialState& initial_;
  std::vector<StartContact> contacts_;
  std::vector<bool> viewed_;  ///< by contact: it has a first cycle
  std::map<Key, StartCounts> pairs_;
  std::vector<StartNode> nodes_;
  std::vector<std::vector<NodeIndex>> moved_by_contact_, moved_by_pair_;
};

}  // namespace gapcheck::solver
