#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/mesh/coincident_nodes.hpp"
#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::contact {

/// For each pair, 1 if something holds its nodes together or leaves them no freedom to part: a common element (springs
/// and beams included), a common rigid link, both rigid, or a tied contact that tracks one and has the other as a
/// reference node. `contacts`: positions in Model::contacts.
[[nodiscard]] std::vector<std::uint8_t> joined(const model::Model& model, SurfaceStore& surfaces,
                                               std::span<const std::uint32_t> contacts,
                                               std::span<const CoincidentNodes> pairs);

}  // namespace gapcheck::contact
