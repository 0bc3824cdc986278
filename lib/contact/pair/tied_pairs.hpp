#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "contact/mesh/rigid_nodes.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

/// Which nodes the tied contacts processed so far tie to what, and what they need to know about the whole model. The
/// model must outlive it.
class TiedPairs {
 public:
  explicit TiedPairs(const model::Model& model) : model_(model) {}
  void add(NodeIndex node, PartIndex part) { ++pairs_[key(node, part)]; }
  /// Undoes one add(): a tie has failed.
  void remove(NodeIndex node, PartIndex part);
  /// A constraint of this contact has the node: no other constraint can take it.
  void constrain(NodeIndex node, ContactIndex contact);
  [[nodiscard]] bool tied(NodeIndex node, PartIndex part) const { return pairs_.contains(key(node, part)); }
  /// The contact whose constraint has the node.
  [[nodiscard]] std::optional<ContactIndex> constrained_by(NodeIndex node) const;
  [[nodiscard]] std::size_t size() const { return pairs_.size(); }
  /// Built when first asked for.
  [[nodiscard]] const RigidNodes& rigid();
  /// Nodes at the other ends of the beams at a node, as pairs (node, other end). Built on first use.
  [[nodiscard]] std::span<const std::pair<NodeIndex, NodeIndex>> beams_at(NodeIndex node);

 private:
  static std::uint64_t key(NodeIndex node, PartIndex part) { return std::uint64_t{node.value} << 32 | part.value; }

  const model::Model& model_;
  std::unordered_map<std::uint64_t, std::uint32_t> pairs_;  // with the number of ties
  std::vector<ContactIndex> holder_;                        // by node; empty: nothing is constrained
  std::optional<RigidNodes> rigid_;
  std::vector<std::pair<NodeIndex, NodeIndex>> beams_;  // both ways, ascending
  bool beams_known_ = false;
};

}  // namespace gapcheck::contact
