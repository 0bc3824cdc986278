#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "contact/pair/pair.hpp"

namespace gapcheck::contact {

/// A segment that a tracked node penetrates.
struct Hit {
  std::uint32_t slot = 0;     ///< position in TrackedNodes
  std::uint32_t segment = 0;
  double distance = 0;        ///< negative behind an oriented segment
  bool in_band = false;       ///< false: only outside every segment's band
};

/// Segments and faces count as equally near to a node within this share of the distance.
inline constexpr double equally_near = 1e-9;

/// Of all hits of one tracked node the one that counts: in-band hits go before others, then the smallest distance; of
/// segments equally near the first. A node lies inside a body only if it is behind the body's nearest facet, since
/// behind a farther one also lies what is outside on another side: hits behind others do not count. `measured`: the
/// pairs of the node with oriented facets that are no hits. Nothing: no hit counts.
[[nodiscard]] std::optional<Hit> choose_hit(const PairScene& scene, std::span<const Hit> hits,
                                            std::span<const Hit> measured);

}  // namespace gapcheck::contact
