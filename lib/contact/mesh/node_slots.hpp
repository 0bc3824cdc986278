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
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    size_ = nodes_.size();
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Slots ascend with the nodes.
  [[nodiscard]] NodeIndex node(std::uint32_t slot) const { return sparse_ ? nodes_[slot] : NodeIndex{slot}; }
  /// no_position for nodes without one.
  [[nodiscard]] std::uint32_t slot(NodeIndex node) const {
    if (!sparse_) return node.value < size_ ? node.value : no_position;
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), node);
    return found != nodes_.end() && *found == node ? static_cast<std::uint32_t>(found - nodes_.begin()) : no_position;
  }

 private:
  bool sparse_ = false;
  std::size_t size_ = 0;
  std::vector<NodeIndex> nodes_;  // ascending; sparse only
};

}  // namespace gapcheck::contact
