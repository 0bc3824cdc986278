#pragma once
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "base/vector.hpp"

namespace gapcheck::contact {

/// A node, and an earlier one in the same place.
struct CoincidentNodes {
  NodeIndex first, second;
};

/// Pairs of nodes that are no further apart than `tolerance`, ascending by the second; each node is paired with the
/// first one near it. Where more than 32 nodes crowd into 64 tolerances, only nodes adjacent in the order of their
/// coordinates are compared, which finds all equal ones. Nodes without finite coordinates are left out. Time: O(n log
/// n) for any input.
[[nodiscard]] std::vector<CoincidentNodes> coincident_nodes(std::span<const NodeIndex> nodes,
                                                            const std::vector<Vector>& x, double tolerance);

}  // namespace gapcheck::contact
