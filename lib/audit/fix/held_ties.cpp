#include "audit/fix/held_ties.hpp"

#include <algorithm>

#include "base/quad.hpp"
#include "geometry/closest_point.hpp"

namespace gapcheck::audit {

std::vector<HeldTie> held_ties(std::span<const contact::JudgedNode> judged, contact::SurfaceStore& surfaces,
                               const std::vector<Vector>& x) {
  std::vector<HeldTie> ties;
  for (const contact::JudgedNode& node : judged) {
    if (!node.tied() || node.segment == none<SegmentIndex>) continue;
    const contact::ContactSurfaces& sides = surfaces.at(node.contact);
    const auto& segments = (sides.two_sided() ? sides.b : sides.a).selection.segments;
    if (node.segment.value >= segments.size()) continue;
    HeldTie tie{node.node, segments.nodes[node.segment.value], {}};
    const auto& n = tie.corners;
    const geometry::Facet facet{{x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]}, n[2] == n[3]};
    const auto c = geometry::closest_point(facet, x[node.node.value]);
    tie.share = quad_weights(c.s, c.t);
    ties.push_back(tie);
  }
  return ties;
}

HeldTie held_tie(const model::HangingNode& hanging) {
  const auto& [a, b] = hanging.between;
  return {hanging.node, {a, b, b, b}, {0.5, 0.5, 0, 0}};
}

std::vector<HeldTie> ties_of(std::vector<HeldTie> ties, std::vector<std::uint8_t>& moving) {
  const auto concerned = [&](const HeldTie& tie) {
    return moving[tie.node.value] != 0 ||
           std::any_of(tie.corners.begin(), tie.corners.end(), [&](NodeIndex n) { return moving[n.value] != 0; });
  };
  // Each pass adds at least one tie, or is the last; chains of ties are short.
  auto open = ties.begin();
  for (bool found = true; found;) {
    const auto next = std::stable_partition(open, ties.end(), concerned);
    found = next != open;
    for (; open != next; ++open) {
      moving[open->node.value] = 1;
      for (const NodeIndex n : open->corners) moving[n.value] = 1;
    }
  }
  ties.erase(open, ties.end());
  return ties;
}

}  // namespace gapcheck::audit
