#pragma once
#include <cstdint>
#include <vector>

#include "audit/fix/joined_nodes.hpp"

namespace gapcheck::audit {

/// The nodes that a solution may move. Joined nodes move as one: with their leader.
class MovingNodes {
 public:
  explicit MovingNodes(std::size_t mesh_nodes) : slot_(mesh_nodes) {}
  /// `marked`: by node, 1 for those that move; of joined nodes all or none.
  void set(const std::vector<std::uint8_t>& marked, const JoinedNodes& joined);

  /// Ascending.
  [[nodiscard]] const std::vector<NodeIndex>& nodes() const { return nodes_; }
  /// Those that move on their own, with all that follow them; ascending.
  [[nodiscard]] const std::vector<NodeIndex>& leaders() const { return leaders_; }
  /// Position of a moving node's leader in leaders().
  [[nodiscard]] std::uint32_t slot(NodeIndex node) const { return slot_[node.value]; }

 private:
  std::vector<NodeIndex> nodes_, leaders_;
  std::vector<std::uint32_t> slot_;  ///< by node of the mesh
};

}  // namespace gapcheck::audit
