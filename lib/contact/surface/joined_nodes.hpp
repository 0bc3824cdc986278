#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/mesh/coincident_nodes.hpp"
#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::contact {

/// For each pair, 1 if something holds its nodes together or prevents them from separating: a common element (springs
/// and beams included), a common rigid link, both rigid, or one of these contacts that ties, tracks one and has the
/// other as a reference node.
[[nodiscard]] std::vector<std::uint8_t> joined(const model::Model& model, SurfaceStore& surfaces,
                                               std::span<const ContactIndex> contacts,
                                               std::span<const CoincidentNodes> pairs);

}  // namespace gapcheck::contact
