#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "contact/mesh/rigid_nodes.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

/// Which nodes are tied to what by the tied contacts seen so far, and what they need to know of the whole model.
/// The model must outlive it.
class TiedPairs {
 public:
  explicit TiedPairs(const model::Model& model) : model_(model) {}
  void add(NodeIndex node, PartIndex part) { ++pairs_[key(node, part)]; }
  /// Takes back one add(): a tie has failed.
  void remove(NodeIndex node, PartIndex part);
  /// A constraint of this contact (position in Model::contacts) has the node: no other constraint can take it.
  void constrain(NodeIndex node, std::uint32_t contact);
  [[nodiscard]] bool tied(NodeIndex node, PartIndex part) const { return pairs_.contains(key(node, part)); }
  /// Position of the contact whose constraint has the node.
  [[nodiscard]] std::optional<std::uint32_t> constrained_by(NodeIndex node) const;
  [[nodiscard]] std::size_t size() const { return pairs_.size(); }
  /// Built when first asked for.
  [[nodiscard]] const RigidNodes& rigid();
  /// Nodes at the other ends of the beams at a node, as pairs (node, other end). Built when first asked for.
  [[nodiscard]] std::span<const std::pair<NodeIndex, NodeIndex>> beams_at(NodeIndex node);

 private:
  static std::uint64_t key(NodeIndex node, PartIndex part) { return std::uint64_t{node.value} << 32 | part.value; }
  static constexpr std::uint32_t free = std::numeric_limits<std::uint32_t>::max();

  const model::Model& model_;
  std::unordered_map<std::uint64_t, std::uint32_t> pairs_;  // with the number of ties
  std::vector<std::uint32_t> holder_;  // by node: contact; empty: nothing is constrained
  std::optional<RigidNodes> rigid_;
  std::vector<std::pair<NodeIndex, NodeIndex>> beams_;  // both ways, ascending
  bool beams_known_ = false;
};

}  // namespace gapcheck::contact
