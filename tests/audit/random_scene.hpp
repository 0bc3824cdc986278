#pragma once
#include <cstdint>

#include "audit/scene.hpp"

namespace gapcheck::audit_test {

/// Two to five plates (quads or triangles) and blocks of bricks close to one another, with one to three contacts.
/// Coordinates are multiples of 2^-20. The same scene for the same seed.
[[nodiscard]] Scene random_scene(std::uint64_t seed);

}  // namespace gapcheck::audit_test
