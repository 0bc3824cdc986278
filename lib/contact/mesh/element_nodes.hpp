#pragma once
#include <cstdint>
#include <vector>

#include "model/entity/mesh.hpp"

namespace gapcheck::contact {

/// Beside Nodes: 1 for every node that an element has, point masses, springs and particles included.
[[nodiscard]] std::vector<std::uint8_t> element_nodes(const model::Mesh& mesh);

}  // namespace gapcheck::contact
