#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/result.hpp"
#include "base/vector.hpp"

namespace gapcheck::results {

/// What the views need of a mesh: where nodes are and which part they belong to. Filled from a d3plot or a deck.
struct MeshSource {
  std::unordered_map<std::int64_t, Vector> coordinates;  ///< node id → initial coordinates
  std::unordered_map<std::int64_t, std::int64_t> parts;  ///< node id → part id of its first element (shells before solids)
};

}  // namespace gapcheck::results
