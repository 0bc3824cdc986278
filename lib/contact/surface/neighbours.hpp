#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/mesh/node_slots.hpp"
#include "contact/surface/surface.hpp"

namespace gapcheck::contact {

/// Which segments of a surface meet at each node. Built once per surface, linear in its size (for large surfaces and
/// with `whole_solids`: in that of the mesh).
class Neighbours {
 public:
  /// `whole_solids`: also knows the solids that have a face without segment (covered by shells) at each node. `cut`: of
  /// the same surface, segments that a box leaves out.
  Neighbours(const Segments& segments, const model::Mesh& mesh, bool whole_solids = false,
             const Segments* cut = nullptr);
  /// Positions of the segments at a node, ascending.
  [[nodiscard]] std::span<const SegmentIndex> at(NodeIndex node) const {
    const std::uint32_t slot = slots_.slot(node);
    if (slot == no_position) return {};
    return {list_.data() + start_[slot], list_.data() + start_[slot + 1]};
  }
  /// True if an element of the node shares a node with the segment: the ring around a segment in which a single-surface
  /// contact checks no penetration. Elements are the segments of this surface, those that a box cuts, and solids with
  /// all their nodes.
  [[nodiscard]] bool in_ring(NodeIndex node, SegmentIndex segment) const;
  /// The same of the segment's own corners, and of the node's elements that are not shells.
  [[nodiscard]] bool in_ring_without_shells(NodeIndex node, SegmentIndex segment) const;
  /// True if no other segment has the edge.
  [[nodiscard]] bool free_edge(SegmentIndex segment, NodeIndex a, NodeIndex b) const;

 private:
  [[nodiscard]] bool meets_cut(NodeIndex node, const model::SegmentNodes& corners) const;
  [[nodiscard]] bool meets_solid(NodeIndex node, const model::SegmentNodes& corners) const;

  const Segments* segments_;
  const model::Mesh* mesh_;
  std::vector<std::pair<NodeIndex, model::SegmentNodes>> cut_;  ///< ascending by node
  NodeSlots slots_;
  std::vector<std::uint32_t> start_;  ///< by slot of the node
  std::vector<SegmentIndex> list_;
  std::vector<std::uint32_t> solid_start_, solid_list_;  // as above, of mesh.solids; empty: not asked for
};

}  // namespace gapcheck::contact
