#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "model/entity/sets.hpp"

namespace gapcheck::contact {

/// Two segments with the same corners, in whatever order; a triangle repeats one of them.
struct Coincidence {
  std::uint32_t first = 0;  ///< position of the first segment with these corners
  std::uint32_t again = 0;  ///< position of a later one
};

/// Every segment with the same corners as an earlier one, ascending by `again`. `nodes`: number of nodes in the mesh;
/// corners beyond it match nothing. Linear in segments and nodes.
[[nodiscard]] std::vector<Coincidence> coincident_segments(std::span<const model::SegmentNodes> segments,
                                                           std::size_t nodes);

}  // namespace gapcheck::contact
