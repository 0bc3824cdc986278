#include "audit/fix/moving_nodes.hpp"

namespace gapcheck::audit {

void MovingNodes::set(const std::vector<std::uint8_t>& marked, const JoinedNodes& joined) {
  nodes_.clear();
  leaders_.clear();
  for (const NodeIndex node : positions<NodeIndex>(marked.size())) {
    if (marked[node.value] == 0) continue;
    // The leader is the first of its nodes.
    const NodeIndex leader = joined.leader(node);
    slot_[node.value] = leader == node ? static_cast<std::uint32_t>(leaders_.size()) : slot_[leader.value];
    if (leader == node) leaders_.push_back(node);
    nodes_.push_back(node);
  }
}

}  // namespace gapcheck::audit
