#include <algorithm>

#include "contact/surface.hpp"

namespace gapcheck::contact {
namespace {

/// Largest thickness seen so far at each node of the mesh.
class NodeThickness {
 public:
  explicit NodeThickness(std::size_t nodes) : entry_(nodes) {}

  /// The node takes part, with nothing known of its thickness.
  void track(NodeIndex node) { entry_[node.value].tracked = true; }
  void offer(NodeIndex node, double half, ThicknessRule rule, PartIndex part) {
    Entry& e = entry_[node.value];
    if (e.given && half <= e.half) return;
    e = {half, part, rule, e.tracked, true};
  }
  [[nodiscard]] bool tracked(NodeIndex node) const { return entry_[node.value].tracked; }

  /// `alone`: thickness of nodes to which no element gave one.
  [[nodiscard]] TrackedNodes collect(const Thickness& alone) const {
    TrackedNodes all;
    for (std::uint32_t n = 0; n < entry_.size(); ++n) {
      const Entry& e = entry_[n];
      if (!e.tracked) continue;
      all.node.push_back(NodeIndex{n});
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
  std::vector<Entry> entry_;
};

/// Nodes without shell or beam (particles, free nodes) have only what the contact itself gives.
Thickness bare_node_thickness(const ThicknessSide& side) {
  if (side.shlthk == 0 || side.override_value == 0) return {};
  return {side.override_value, ThicknessRule::contact_card};
}

template <class ElementArray>
std::vector<std::uint32_t> elements_at(const ElementArray& elements, const NodeThickness& nodes) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t e = 0; e < elements.size(); ++e) {
    const auto& n = elements.nodes[e];
    if (std::any_of(n.begin(), n.end(), [&](NodeIndex i) { return i != none<NodeIndex> && nodes.tracked(i); }))
      found.push_back(e);
  }
  return found;
}

/// Thickness for nodes that came without segments: all elements of the mesh that have one of them.
void offer_all_elements(NodeThickness& nodes, const model::Model& model, const ThicknessSide& side,
                        const std::vector<Vector>& x) {
  const model::Mesh& mesh = model.mesh;
  Segments s;
  const auto append = [&](const model::SegmentNodes& n, std::uint32_t e, model::ElementKind kind, SegmentKind as) {
    s.nodes.push_back(n);
    s.element.push_back(e);
    s.element_kind.push_back(kind);
    s.kind.push_back(as);
  };
  for (const auto e : elements_at(mesh.shells, nodes))
    append(mesh.shells.nodes[e], e, model::ElementKind::shell, SegmentKind::shell);
  for (const auto e : elements_at(mesh.beams, nodes)) {
    const auto& n = mesh.beams.nodes[e];
    append({n[0], n[1], n[1], n[1]}, e, model::ElementKind::beam, SegmentKind::line);
  }
  fill_thickness(s, model, side, x);
  for (std::size_t i = 0; i < s.size(); ++i)
    for (const NodeIndex n : s.nodes[i])
      if (nodes.tracked(n)) nodes.offer(n, s.half[i], s.rule[i], part_of(mesh, s, i));
  const Thickness coat = solid_thickness(side);
  const auto offer_solids = [&](const model::Elements<8>& elements) {
    for (const auto e : elements_at(elements, nodes))
      for (const NodeIndex n : elements.nodes[e])
        if (nodes.tracked(n)) nodes.offer(n, coat.value / 2, coat.rule, elements.part[e]);
  };
  offer_solids(mesh.solids);
  offer_solids(mesh.thick_shells);
  for (std::uint32_t e = 0; e < mesh.particles.size(); ++e) {
    const NodeIndex n = mesh.particles.nodes[e][0];
    const Thickness bare = bare_node_thickness(side);
    if (nodes.tracked(n)) nodes.offer(n, bare.value / 2, bare.rule, mesh.particles.part[e]);
  }
}

/// From each node to its mid-surface: the mean over its segments.
std::vector<Vector> mean_shifts(const Segments& s, const TrackedNodes& nodes, const std::vector<Vector>& x) {
  std::vector<Vector> sum(x.size(), Vector::Zero());
  std::vector<int> count(x.size(), 0);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const auto& n = s.nodes[i];
    const Vector normal = (x[n[2].value] - x[n[0].value]).cross(x[n[3].value] - x[n[1].value]).stableNormalized();
    for (std::size_t c = 0; c < 4; ++c) {
      if (c > 0 && n[c] == n[c - 1]) continue;
      sum[n[c].value] += s.offset[i] * normal;
      ++count[n[c].value];
    }
  }
  std::vector<Vector> shift;
  shift.reserve(nodes.size());
  for (const NodeIndex n : nodes.node) shift.push_back(sum[n.value] / std::max(1, count[n.value]));
  return shift;
}

}  // namespace

TrackedNodes tracked_nodes(const Selection& selection, const model::Model& model, const ThicknessSide& side,
                           const std::vector<Vector>& x) {
  NodeThickness nodes(x.size());
  if (!selection.nodes.empty()) {
    for (const NodeIndex n : selection.nodes) nodes.track(n);
    offer_all_elements(nodes, model, side, x);
  }
  const Segments& s = selection.segments;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const PartIndex part = part_of(model.mesh, s, i);
    for (const NodeIndex n : s.nodes[i]) {
      nodes.track(n);
      nodes.offer(n, s.half[i], s.rule[i], part);
    }
  }
  TrackedNodes all = nodes.collect(bare_node_thickness(side));
  if (!s.offset.empty()) all.shift = mean_shifts(s, all, x);
  return all;
}

}  // namespace gapcheck::contact
