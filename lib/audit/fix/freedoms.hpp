#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "audit/fix/joined_nodes.hpp"
#include "model/model.hpp"
#include "records/fix.hpp"

namespace gapcheck::audit {

/// Ids of parts or nodes that must not move: first to last.
struct Lock {
  bool nodes = false;
  std::int64_t first = 0, last = 0;
};

/// How freely nodes may move: by node and axis the inverse of its weight. Joined nodes share one weight and are held
/// together.
struct Freedoms {
  std::vector<Vector> mobility;    ///< 0: held in this direction
  std::vector<HoldReason> reason;  ///< why it is held, wholly or in some direction
  JoinedNodes joined;
  /// Holds a node and those joined to it (as `constrained`).
  void hold(NodeIndex node, HoldReason why);
  [[nodiscard]] bool held(NodeIndex node) const { return mobility[node.value].isZero(); }
};

/// The weight of a node is its share of the areas of its elements (shells: a third or quarter; solids: a quarter of a
/// facet, V^(2/3); beams: a quarter of the square of the length), each times the priority of its part; nodes without
/// any have the mean of the others. Locked nodes, those of rigid bodies (parts, nodal rigid bodies, extra nodes), and
/// those with a prescribed motion are held, those with *BOUNDARY_SPC or a constraint code in its directions (in all,
/// where it is in a local system). `priorities`: part id and factor, positive; parts that are not named have 1. `held`:
/// by node, 1 for others that must stay; empty: none. `joined`: of this model. Linear in the model's size.
[[nodiscard]] Freedoms find_freedoms(const model::Model& model, const std::vector<Lock>& locks,
                                     const std::vector<std::pair<std::int64_t, double>>& priorities,
                                     std::span<const std::uint8_t> held = {}, JoinedNodes joined = {});

}  // namespace gapcheck::audit
