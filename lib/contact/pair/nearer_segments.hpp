#pragma once
#include <vector>

#include "contact/pair/closest_segment.hpp"

namespace gapcheck::contact {

/// True if another facet of the same body is nearer to the node of a hit. `other`: the node's pair with that facet.
[[nodiscard]] bool nearer_of_body(const PairScene& scene, const Hit& hit, const Hit& other);

/// The pairs of nodes that are behind a segment with the oriented segments that are nearer to them, however far these
/// look behind themselves: the search finds only those that look as far as the node. Pairs that choose_hit() does not
/// need are left out. `allowed`: whether a pair counts.
[[nodiscard]] std::vector<Hit> nearer_segments(const PairScene& scene, const PairFilter& allowed,
                                               const std::vector<Hit>& hits);

}  // namespace gapcheck::contact
