#include "contact/surface/neighbours.hpp"

#include <algorithm>

namespace gapcheck::contact {
namespace {

/// Distinct corners: a triangle repeats its last one, a line its second one twice.
template <class Visit>
void each_corner(const model::SegmentNodes& n, const Visit& visit) {
  for (std::size_t c = 0; c < 4; ++c)
    if (c == 0 || n[c] != n[c - 1]) visit(n[c]);
}

}  // namespace

NodeSlots slots_of(const Segments& segments, std::size_t mesh_nodes) {
  if (!NodeSlots::few(4 * segments.size(), mesh_nodes)) return NodeSlots(mesh_nodes);
  std::vector<NodeIndex> nodes;
  for (const auto& corners : segments.nodes) nodes.insert(nodes.end(), corners.begin(), corners.end());
  return NodeSlots(std::move(nodes));
}

Neighbours::Neighbours(const Segments& segments, const model::Mesh& mesh, bool whole_solids, const Segments* cut)
    : segments_(&segments), mesh_(&mesh), slots_(slots_of(segments, mesh.nodes.size())), start_(slots_.size() + 1, 0) {
  for (const auto& nodes : segments.nodes) each_corner(nodes, [&](NodeIndex n) { ++start_[slots_.slot(n) + 1]; });
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  list_.resize(start_.back());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (const SegmentIndex s : positions<SegmentIndex>(segments.size()))
    each_corner(segments.nodes[s.value], [&](NodeIndex n) { list_[next[slots_.slot(n)]++] = s; });
  if (cut != nullptr) {
    for (const auto& corners : cut->nodes) each_corner(corners, [&](NodeIndex n) { cut_.emplace_back(n, corners); });
    std::stable_sort(cut_.begin(), cut_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  if (!whole_solids || mesh.solids.size() == 0) return;
  solid_start_.assign(mesh.nodes.size() + 1, 0);
  for (const auto& nodes : mesh.solids.nodes)
    for (const NodeIndex n : nodes) ++solid_start_[n.value + 1];
  for (std::size_t i = 1; i < solid_start_.size(); ++i) solid_start_[i] += solid_start_[i - 1];
  solid_list_.resize(solid_start_.back());
  next.assign(solid_start_.begin(), solid_start_.end() - 1);
  for (std::uint32_t e = 0; e < mesh.solids.size(); ++e)
    for (const NodeIndex n : mesh.solids.nodes[e]) solid_list_[next[n.value]++] = e;
}

bool Neighbours::meets_cut(NodeIndex node, const model::SegmentNodes& corners) const {
  auto own = std::lower_bound(cut_.begin(), cut_.end(), node, [](const auto& a, NodeIndex n) { return a.first < n; });
  for (; own != cut_.end() && own->first == node; ++own)
    if (std::any_of(own->second.begin(), own->second.end(), [&](NodeIndex n) { return is_corner(corners, n); }))
      return true;
  return false;
}

bool Neighbours::in_ring(NodeIndex node, SegmentIndex segment) const {
  const auto& corners = segments_->nodes[segment.value];
  if (!cut_.empty() && meets_cut(node, corners)) return true;
  for (const SegmentIndex own : at(node))
    for (const NodeIndex n : segments_->nodes[own.value])
      if (is_corner(corners, n)) return true;
  return meets_solid(node, corners);
}

bool Neighbours::in_ring_without_shells(NodeIndex node, SegmentIndex segment) const {
  const auto& corners = segments_->nodes[segment.value];
  if (is_corner(corners, node)) return true;
  for (const SegmentIndex own : at(node)) {
    if (segments_->element_kind[own.value] == model::ElementKind::shell) continue;
    for (const NodeIndex n : segments_->nodes[own.value])
      if (is_corner(corners, n)) return true;
  }
  return meets_solid(node, corners);
}

bool Neighbours::meets_solid(NodeIndex node, const model::SegmentNodes& corners) const {
  for (const SegmentIndex own : at(node)) {
    const auto kind = segments_->element_kind[own.value];
    const std::uint32_t e = segments_->element[own.value];
    if (e == no_position) continue;
    if (kind != model::ElementKind::solid && kind != model::ElementKind::thick_shell) continue;
    const auto& solid = (kind == model::ElementKind::solid ? mesh_->solids : mesh_->thick_shells).nodes[e];
    if (std::any_of(solid.begin(), solid.end(), [&](NodeIndex n) { return is_corner(corners, n); })) return true;
  }
  if (solid_start_.empty()) return false;
  for (std::uint32_t i = solid_start_[node.value]; i < solid_start_[node.value + 1]; ++i) {
    const auto& solid = mesh_->solids.nodes[solid_list_[i]];
    if (std::any_of(solid.begin(), solid.end(), [&](NodeIndex n) { return is_corner(corners, n); })) return true;
  }
  return false;
}

bool Neighbours::free_edge(SegmentIndex segment, NodeIndex a, NodeIndex b) const {
  const auto around = at(a);
  return std::none_of(around.begin(), around.end(), [&](SegmentIndex other) {
    return other != segment && is_corner(segments_->nodes[other.value], b);
  });
}

}  // namespace gapcheck::contact
