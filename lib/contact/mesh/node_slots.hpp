#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/ids.hpp"

namespace gapcheck::contact {

/// Numbers the nodes of a surface for parallel arrays: small surfaces get their own numbering, so thousands of them in
/// one large mesh cost only their own size; for large ones the number is the node's own position.
class NodeSlots {
 public:
  /// True if a surface with this many nodes (repeated ones included) is small compared with the mesh.
  [[nodiscard]] static bool few(std::size_t named, std::size_t mesh_nodes) { return named < mesh_nodes / 16; }

  /// All nodes of the mesh.
  explicit NodeSlots(std::size_t mesh_nodes) : size_(mesh_nodes) {}
  /// The nodes given, in any order, repeated or not.
  explicit NodeSlots(std::vector<NodeIndex> nodes) : sparse_(true), nodes_(std::move(nodes)) {
    if (!number_in_table()) {
      std::sort(nodes_.begin(), nodes_.end());
      nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    }
    size_ = nodes_.size();
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Slots ascend with the nodes.
  [[nodiscard]] NodeIndex node(std::uint32_t slot) const { return sparse_ ? nodes_[slot] : NodeIndex{slot}; }
  /// no_position for nodes without one.
  [[nodiscard]] std::uint32_t slot(NodeIndex node) const {
    if (!sparse_) return node.value < size_ ? node.value : no_position;
    if (!table_.empty()) {
      const std::uint32_t place = node.value - first_;  // of a node before the first: far beyond the end
      return place < table_.size() ? table_[place] : no_position;
    }
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), node);
    return found != nodes_.end() && *found == node ? static_cast<std::uint32_t>(found - nodes_.begin()) : no_position;
  }

 private:
  /// Nodes of a part mostly follow one another: a table of their range finds slots at once, and sorts. False: the nodes
  /// are too far apart.
  bool number_in_table() {
    constexpr std::size_t places_each = 4;
    if (nodes_.empty()) return false;
    const auto [least, greatest] = std::minmax_element(nodes_.begin(), nodes_.end());
    const std::size_t range = std::size_t{greatest->value} - least->value + 1;
    if (range > places_each * nodes_.size()) return false;
    first_ = least->value;
    table_.assign(range, no_position);
    for (const NodeIndex node : nodes_) table_[node.value - first_] = 0;
    std::uint32_t slot = 0;
    for (std::uint32_t place = 0; place < range; ++place) {
      if (table_[place] == no_position) continue;
      nodes_[slot] = NodeIndex{first_ + place};
      table_[place] = slot++;
    }
    nodes_.resize(slot);
    return true;
  }

  bool sparse_ = false;
  std::size_t size_ = 0;
  std::vector<NodeIndex> nodes_;      // ascending; sparse only
  std::uint32_t first_ = 0;           // of the nodes
  std::vector<std::uint32_t> table_;  // by node - first_: its slot or no_position; empty: none
};

}  // namespace gapcheck::contact
