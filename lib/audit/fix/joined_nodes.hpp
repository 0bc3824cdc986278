#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "keyword/deck.hpp"
#include "model/model.hpp"
#include "model/read/links.hpp"

namespace gapcheck::audit {

/// Nodes whose distance something other than a common element fixes: they move as one or not at all. These are the
/// nodes of each spot weld (*CONSTRAINED_SPOTWELD, _GENERALIZED_WELD_SPOT), rivet (*CONSTRAINED_RIVET), node set
/// (*CONSTRAINED_NODE_SET, whichever directions it names), and of each beam or solid of spot weld material. Not rigid
/// bodies: they are held.
class JoinedNodes {
 public:
  JoinedNodes() = default;  ///< all move alone
  /// `welds`: whether spot welds, rivets and weld elements join; node sets always do.
  JoinedNodes(const model::Model& model, const std::vector<model::NodeLink>& links, bool welds = true);
  /// The first of the nodes that move with a node; the node itself if it moves alone.
  [[nodiscard]] NodeIndex leader(NodeIndex node) const { return leader_.empty() ? node : leader_[node.value]; }
  /// The nodes that move with a leader, including itself, ascending; empty if it moves alone.
  [[nodiscard]] std::span<const NodeIndex> followers(NodeIndex leader) const;
  /// The leaders of more than one node, ascending.
  [[nodiscard]] const std::vector<NodeIndex>& leaders() const { return leaders_; }
  /// True if a keyword, not only a weld element, joins the node to others.
  [[nodiscard]] bool by_keyword(NodeIndex node) const { return !named_.empty() && named_[node.value] != 0; }

 private:
  std::vector<NodeIndex> leader_;    ///< by node; empty: all move alone
  std::vector<std::uint8_t> named_;  ///< by node; beside leader_
  std::vector<NodeIndex> leaders_, list_;
  std::vector<std::uint32_t> start_;  ///< followers of leaders_[i]: list_[start_[i]] … list_[start_[i + 1] - 1]
};

/// Nodes that must stay, since unread keywords name them (*CONSTRAINED_…, *BOUNDARY_…).
struct UnreadConstraints {
  std::vector<std::uint8_t> held;     ///< by node: 1; empty: none
  std::vector<std::string> keywords;  ///< that hold nodes, ascending
  std::vector<std::string> unknown;   ///< that may hold unknown nodes, ascending
};
[[nodiscard]] UnreadConstraints unread_constraints(const keyword::Deck& deck, const model::Model& model);

}  // namespace gapcheck::audit
