#pragma once
#include <cstdint>

#include "reference/scene.hpp"

namespace gapcheck::reference {

/// Two to four small parts close to one another (plates of quads and triangles, flat, curved or turned, some with
/// flipped normals; blocks of bricks, bare or coated with shells that share their nodes; chains of beams) and one to
/// three contacts of any type with any of the cards' values that matter. Coordinates are multiples of 2^-20. The same
/// scene for the same seed.
[[nodiscard]] Scene random_scene(std::uint64_t seed);

}  // namespace gapcheck::reference
