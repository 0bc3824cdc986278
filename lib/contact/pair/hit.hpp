#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/pair/pair.hpp"

namespace gapcheck::contact {

/// A segment that a tracked node penetrates.
struct Hit {
  SlotIndex slot;
  SegmentIndex segment;
  double distance = 0;   ///< negative behind an oriented segment
  bool in_band = false;  ///< false: only outside every segment's band
};

/// Segments and faces count as equally near to a node within this share of the distance.
inline constexpr double equally_near = 1e-9;

/// The hit that counts among all hits of one tracked node: in-band hits come first, then the smallest distance; of
/// equally near segments the first. A node lies inside a body only if it is behind the body's nearest facet, since a
/// node outside on another side may also be behind a farther one: hits behind others do not count. `measured`: the
/// node's pairs with oriented facets that are not hits. If the node presses on one of the segments, those
/// along which it only slides (PairScene::slides) count in neither list. Nothing: no hit counts.
[[nodiscard]] std::optional<Hit> choose_hit(const PairScene& scene, std::span<const Hit> hits,
                                            std::span<const Hit> measured);

/// Drops hits that cannot change the choice of choose_hit() for any node, now or with further pairs: farther ones in
/// front. Keeps no order. So a node that penetrates thousands of segments needs memory for a few.
void drop_farther(const PairScene& scene, std::vector<Hit>& hits);

}  // namespace gapcheck::contact
