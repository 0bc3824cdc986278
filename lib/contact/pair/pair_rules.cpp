#include "contact/pair/pair_rules.hpp"

namespace gapcheck::contact {
namespace {

/// By tracked node: it is a corner of a shell or solid facet. Segment-based contact checks only these, if there are
/// any.
std::vector<bool> corners_of(const Segments& segments, const TrackedNodes& nodes, std::size_t mesh_nodes) {
  const NodeSlots slots = slots_of(segments, mesh_nodes);
  std::vector<bool> corner(slots.size(), false), tracked(nodes.size(), false);
  for (std::size_t s = 0; s < segments.size(); ++s)
    if (segments.kind[s] != SegmentKind::line)
      for (const NodeIndex n : segments.nodes[s]) corner[slots.slot(n)] = true;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::uint32_t slot = slots.slot(nodes.node[i]);
    tracked[i] = slot != no_position && corner[slot];
  }
  return tracked;
}

}  // namespace

PairRules::PairRules(const PairScene& scene, const ContactSide& tracked, const Exclusions& exclusions,
                     const TiedPairs& ties)
    : scene_(scene),
      exclusions_(exclusions),
      ties_(ties),
      single_(scene.type.treatment == Treatment::single_surface),
      own_part_(scene.type.pairing != Pairing::mortar || scene.settings.ignore >= 0) {
  if (scene.type.by_segments() && !tracked.names_nodes)
    corners_ = corners_of(tracked.selection.segments, scene.nodes, scene.model.mesh.nodes.size());
}

PairRule PairRules::operator()(SlotIndex slot, SegmentIndex segment) const {
  const NodeIndex node = node_of(slot);
  if (single_ && (counts_beside_own(segment) ? scene_.neighbours.in_ring_without_shells(node, segment)
                                             : scene_.neighbours.in_ring(node, segment)))
    return PairRule::neighbour;
  if (!corners_.empty() && !corners_[slot.value]) return PairRule::no_corner;
  const PartIndex part = part_of(scene_.model.mesh, scene_.segments, segment.value);
  if (!own_part_ && part == scene_.nodes.part[slot.value]) return PairRule::own_part;
  if (!exclusions_.empty() && exclusions_.excluded(scene_.nodes.part[slot.value], part)) return PairRule::excluded;
  if (ties_.size() > 0 && ties_.tied(node, part)) return PairRule::tied;
  return PairRule::counts;
}

}  // namespace gapcheck::contact
