#include <algorithm>

#include "base/large_array.hpp"
#include "base/quad.hpp"
#include "contact/mesh/node_slots.hpp"
#include "contact/surface/surface.hpp"

namespace gapcheck::contact {
namespace {

/// Largest thickness seen so far at each node of a surface.
class NodeThickness {
 public:
  explicit NodeThickness(NodeSlots slots) : slots_(std::move(slots)), entry_(large_array<Entry>(slots_.size())) {}

  /// The node takes part, with unknown thickness.
  void track(NodeIndex node) { entry_[slots_.slot(node)].tracked = true; }
  void offer(NodeIndex node, double half, ThicknessRule rule, PartIndex part) {
    offer(entry_[slots_.slot(node)], half, rule, part);
  }
  void track_and_offer(NodeIndex node, double half, ThicknessRule rule, PartIndex part) {
    Entry& entry = entry_[slots_.slot(node)];
    entry.tracked = true;
    offer(entry, half, rule, part);
  }
  [[nodiscard]] bool tracked(NodeIndex node) const {
    const std::uint32_t slot = slots_.slot(node);
    return slot != no_position && entry_[slot].tracked;
  }
  [[nodiscard]] const NodeSlots& slots() const { return slots_; }

  /// `alone`: thickness of nodes to which no element gave one.
  [[nodiscard]] TrackedNodes collect(const Thickness& alone) const {
    TrackedNodes all;
    const auto count = std::count_if(entry_.begin(), entry_.end(), [](const Entry& e) { return e.tracked; });
    const auto room = static_cast<std::size_t>(count);
    reserve_in_parallel(all.node, room);
    reserve_in_parallel(all.half, room);
    reserve_in_parallel(all.rule, room);
    reserve_in_parallel(all.part, room);
    for (std::uint32_t n = 0; n < entry_.size(); ++n) {
      const Entry& e = entry_[n];
      if (!e.tracked) continue;
      all.node.push_back(slots_.node(n));
      all.half.push_back(e.given ? e.half : alone.value / 2);
      all.rule.push_back(e.given ? e.rule : alone.rule);
      all.part.push_back(e.part);
    }
    return all;
  }

 private:
  struct Entry {
    double half = 0;
    PartIndex part = none<PartIndex>;
    ThicknessRule rule = ThicknessRule::none;
    bool tracked = false;
    bool given = false;  // an element has offered its thickness
  };
  static void offer(Entry& e, double half, ThicknessRule rule, PartIndex part) {
    if (!e.given || half > e.half) e = {half, part, rule, e.tracked, true};
  }

  NodeSlots slots_;
  std::vector<Entry> entry_;
};

/// Nodes without shell or beam (particles, free nodes) have only what the contact itself gives.
Thickness bare_node_thickness(const ThicknessSide& side) {
  if (side.shlthk == 0 || side.override_value == 0) return {};
  return {side.override_value, ThicknessRule::contact_card};
}

/// Elements that have one of the nodes, ascending.
template <class ElementArray>
std::vector<std::uint32_t> elements_at(const ElementArray& elements, ElementIndex& index, const NodeThickness& nodes,
                                       bool few) {
  std::vector<std::uint32_t> found;
  if (few) {
    for (std::uint32_t i = 0; i < nodes.slots().size(); ++i)
      if (const NodeIndex n = nodes.slots().node(i); nodes.tracked(n))
        found.insert(found.end(), index.at(n).begin(), index.at(n).end());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }
  for (std::uint32_t e = 0; e < elements.size(); ++e) {
    const auto& n = elements.nodes[e];
    if (std::any_of(n.begin(), n.end(), [&](NodeIndex i) { return i != none<NodeIndex> && nodes.tracked(i); }))
      found.push_back(e);
  }
  return found;
}

/// Thickness for nodes without segments: from all elements of the mesh that have one of them.
void offer_all_elements(NodeThickness& nodes, const model::Model& model, const ThicknessSide& side,
                        const std::vector<Vector>& x, MeshIndex& index, bool few) {
  const model::Mesh& mesh = model.mesh;
  Segments s;
  const auto append = [&](const model::SegmentNodes& n, std::uint32_t e, model::ElementKind kind, SegmentKind as) {
    s.nodes.push_back(n);
    s.element.push_back(e);
    s.element_kind.push_back(kind);
    s.kind.push_back(as);
  };
  for (const auto e : elements_at(mesh.shells, index.shells, nodes, few))
    append(mesh.shells.nodes[e], e, model::ElementKind::shell, SegmentKind::shell);
  for (const auto e : elements_at(mesh.beams, index.beams, nodes, few)) {
    const auto& n = mesh.beams.nodes[e];
    append({n[0], n[1], n[1], n[1]}, e, model::ElementKind::beam, SegmentKind::line);
  }
  fill_thickness(s, model, side, x);
  for (std::size_t i = 0; i < s.size(); ++i)
    for (const NodeIndex n : s.nodes[i])
      if (nodes.tracked(n)) nodes.offer(n, s.half[i], s.rule[i], part_of(mesh, s, i));
  const Thickness coat = solid_thickness(side);
  const auto offer_solids = [&](const model::Elements<8>& elements, ElementIndex& at) {
    for (const auto e : elements_at(elements, at, nodes, few))
      for (const NodeIndex n : elements.nodes[e])
        if (nodes.tracked(n)) nodes.offer(n, coat.value / 2, coat.rule, elements.part[e]);
  };
  offer_solids(mesh.solids, index.solids);
  offer_solids(mesh.thick_shells, index.thick_shells);
  for (const auto e : elements_at(mesh.particles, index.particles, nodes, few)) {
    const NodeIndex n = mesh.particles.nodes[e][0];
    const Thickness bare = bare_node_thickness(side);
    if (nodes.tracked(n)) nodes.offer(n, bare.value / 2, bare.rule, mesh.particles.part[e]);
  }
}

/// From each node to its mid-surface: the mean over its segments.
std::vector<Vector> mean_shifts(const Selection& selection, const TrackedNodes& nodes, const std::vector<Vector>& x) {
  const NodeSlots slots(nodes.node);
  std::vector<Vector> sum(slots.size(), Vector::Zero());
  std::vector<int> count(slots.size(), 0);
  const auto add = [&](const Segments& s) {
    for (std::size_t i = 0; i < s.size(); ++i) {
      const auto& n = s.nodes[i];
      const Vector normal = quad_normal(n, x).stableNormalized();
      for (std::size_t c = 0; c < 4; ++c) {
        const std::uint32_t slot = slots.slot(n[c]);
        if ((c > 0 && n[c] == n[c - 1]) || slot == no_position) continue;
        if (!s.offset.empty()) sum[slot] += s.offset[i] * normal;
        ++count[slot];
      }
    }
  };
  add(selection.segments);
  add(selection.cut);
  std::vector<Vector> shift;
  shift.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) shift.emplace_back(sum[i] / std::max(1, count[i]));
  return shift;
}

/// Ascending.
std::vector<NodeIndex> corners_of(const Segments& segments) {
  std::vector<NodeIndex> nodes;
  nodes.reserve(4 * segments.size());
  for (const auto& corners : segments.nodes) nodes.insert(nodes.end(), corners.begin(), corners.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

NodeSlots slots_of(const Selection& selection) {
  std::vector<NodeIndex> nodes = selection.nodes;
  for (const auto& corners : selection.segments.nodes) nodes.insert(nodes.end(), corners.begin(), corners.end());
  return NodeSlots(std::move(nodes));
}

}  // namespace

TrackedNodes tracked_nodes(const Selection& selection, const model::Model& model, const ThicknessSide& side,
                           const std::vector<Vector>& x, MeshIndex& index) {
  const Segments& s = selection.segments;
  const bool few = NodeSlots::few(selection.nodes.size() + 4 * s.size(), x.size());
  NodeThickness nodes(few ? slots_of(selection) : NodeSlots(x.size()));
  if (!selection.nodes.empty()) {
    // Nodes of segments that a box cuts have the thickness of these, all others that of their elements.
    const std::vector<NodeIndex> cut = corners_of(selection.cut);
    bool loose = false;
    for (const NodeIndex n : selection.nodes) {
      if (std::binary_search(cut.begin(), cut.end(), n)) continue;
      nodes.track(n);
      loose = true;
    }
    if (loose) offer_all_elements(nodes, model, side, x, index, few);
    for (const NodeIndex n : selection.nodes) nodes.track(n);
  }
  for (std::size_t i = 0; i < s.size(); ++i) {
    const PartIndex part = part_of(model.mesh, s, i);
    for (const NodeIndex n : s.nodes[i]) nodes.track_and_offer(n, s.half[i], s.rule[i], part);
  }
  const Segments& cut = selection.cut;
  for (std::size_t i = 0; i < cut.size(); ++i)
    for (const NodeIndex n : cut.nodes[i])
      if (nodes.tracked(n)) nodes.offer(n, cut.half[i], cut.rule[i], part_of(model.mesh, cut, i));
  TrackedNodes all = nodes.collect(bare_node_thickness(side));
  if (!s.offset.empty() || !cut.offset.empty()) all.shift = mean_shifts(selection, all, x);
  return all;
}

}  // namespace gapcheck::contact
