#pragma once
#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include "contact/mesh/mesh_index.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

struct Segments;

/// The corners of a segment without order: equal for segments with the same nodes.
using SegmentKey = model::SegmentNodes;
struct SegmentKeyHash {
  std::size_t operator()(const SegmentKey& key) const noexcept;
};
[[nodiscard]] SegmentKey segment_key(model::SegmentNodes nodes);

/// Keys of the shell segments of a surface.
[[nodiscard]] std::unordered_set<SegmentKey, SegmentKeyHash> shell_keys(const Segments& segments);

/// The element that a segment of a segment set belongs to.
struct SegmentElement {
  std::uint32_t element = no_position;  ///< no_position: none found
  model::ElementKind kind = model::ElementKind::shell;
};

/// For each segment the shell, solid or thick shell with these nodes; shells take precedence over solids, the first in
/// the deck over later ones.
[[nodiscard]] std::vector<SegmentElement> find_segment_elements(const model::Mesh& mesh,
                                                                std::span<const model::SegmentNodes> segments,
                                                                MeshIndex& index);

}  // namespace gapcheck::contact
