#include "contact/pair/record_pair.hpp"

#include <algorithm>

namespace gapcheck::contact {

std::optional<RecordPair> find_pair(const ContactSurfaces& surfaces, const model::Mesh& mesh,
                                    const Penetration& record) {
  const auto node = mesh.nodes.lookup.find(record.node);
  if (!node || record.segment_number == 0) return std::nullopt;
  RecordPair pair;
  pair.segment = SegmentIndex{record.segment_number - 1};
  const auto fits = [&](bool node_on_b, bool segment_on_b) {
    const TrackedNodes& nodes = (node_on_b ? surfaces.b : surfaces.a).nodes;
    const Segments& segments = (segment_on_b ? surfaces.b : surfaces.a).selection.segments;
    if (pair.segment.value >= segments.size()) return false;
    for (std::size_t i = 0; i < 4; ++i)
      if (mesh.nodes.id[segments.nodes[pair.segment.value][i].value] != record.segment[i]) return false;
    const auto slot = std::lower_bound(nodes.node.begin(), nodes.node.end(), NodeIndex{*node});
    if (slot == nodes.node.end() || slot->value != *node) return false;
    pair.node_on_b = node_on_b;
    pair.segment_on_b = segment_on_b;
    pair.slot = to_index<SlotIndex>(static_cast<std::size_t>(slot - nodes.node.begin()));
    return true;
  };
  const bool found = surfaces.two_sided() ? fits(false, true) || fits(true, false) : fits(false, false);
  return found ? std::optional(pair) : std::nullopt;
}

}  // namespace gapcheck::contact
