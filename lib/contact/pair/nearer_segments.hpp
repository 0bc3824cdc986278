#pragma once
#include <vector>

#include "contact/pair/closest_segment.hpp"

namespace gapcheck::contact {

/// Adds to `measured` the oriented segments that are nearer to a node than one that it is behind, however far they look
/// behind themselves: the search finds only those that look as far as the node. `allowed`: whether a pair counts.
void add_nearer_segments(const PairScene& scene, const PairFilter& allowed, const std::vector<Hit>& hits,
                         std::vector<Hit>& measured);

}  // namespace gapcheck::contact
