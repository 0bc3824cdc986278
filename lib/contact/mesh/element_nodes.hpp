#pragma once
#include <cstdint>
#include <vector>

#include "model/entity/mesh.hpp"

namespace gapcheck::contact {

/// Parallel to Nodes: 1 for every node that belongs to an element, including point masses, springs and particles.
[[nodiscard]] std::vector<std::uint8_t> element_nodes(const model::Mesh& mesh);

}  // namespace gapcheck::contact
