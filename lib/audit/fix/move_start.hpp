#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "audit/fix/freedoms.hpp"

namespace gapcheck::audit {

/// Moves below this share of the largest are rounding.
inline constexpr double move_rounding = 1e-9;

/// Where nodes start, and how freely they may move from there.
struct MoveStart {
  const std::vector<Vector>& deck;  ///< coordinates by node
  std::vector<Vector> x;            ///< the same with tied nodes on their segments
  Freedoms freedoms;
  /// Holds a node where the deck has it.
  void hold_in_deck(NodeIndex node, HoldReason why) {
    x[node.value] = deck[node.value];
    freedoms.hold(node, why);
  }
};

/// How far any of the nodes is from one position to the other.
[[nodiscard]] inline double largest_difference(const std::vector<Vector>& a, const std::vector<Vector>& b,
                                               std::span<const NodeIndex> nodes) {
  double largest = 0;
  for (const NodeIndex n : nodes) largest = std::max(largest, (a[n.value] - b[n.value]).norm());
  return largest;
}

}  // namespace gapcheck::audit
