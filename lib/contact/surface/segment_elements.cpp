#include "contact/surface/segment_elements.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "contact/mesh/faces.hpp"
#include "contact/mesh/node_slots.hpp"
#include "contact/surface/surface.hpp"

namespace gapcheck::contact {

std::size_t SegmentKeyHash::operator()(const SegmentKey& key) const noexcept {
  std::uint64_t h = 0x9E3779B97F4A7C15ULL;
  for (const NodeIndex n : key) h = (h ^ n.value) * 0xD6E8FEB86659FD93ULL, h ^= h >> 32;
  return static_cast<std::size_t>(h);
}

SegmentKey segment_key(model::SegmentNodes nodes) {
  std::sort(nodes.begin(), nodes.end());
  const auto end = std::unique(nodes.begin(), nodes.end());
  std::fill(end, nodes.end(), none<NodeIndex>);
  return nodes;
}

std::unordered_set<SegmentKey, SegmentKeyHash> shell_keys(const Segments& segments) {
  std::unordered_set<SegmentKey, SegmentKeyHash> keys;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments.kind[i] == SegmentKind::shell) keys.insert(segment_key(segments.nodes[i]));
  return keys;
}

namespace {

/// Elements that may have a face with such nodes, ascending: those at the nodes, or all where that is not much less.
template <class ElementArray>
std::vector<std::uint32_t> possible_elements(const ElementArray& elements, ElementIndex& index,
                                             std::span<const model::SegmentNodes> segments, std::size_t mesh_nodes) {
  std::vector<std::uint32_t> possible;
  if (!NodeSlots::few(4 * segments.size(), mesh_nodes)) {
    possible.resize(elements.size());
    std::iota(possible.begin(), possible.end(), 0U);
    return possible;
  }
  std::vector<NodeIndex> nodes;
  for (const auto& corners : segments) nodes.insert(nodes.end(), corners.begin(), corners.end());
  const NodeSlots distinct(std::move(nodes));
  for (std::uint32_t i = 0; i < distinct.size(); ++i) {
    const auto here = index.at(distinct.node(i));
    possible.insert(possible.end(), here.begin(), here.end());
  }
  std::sort(possible.begin(), possible.end());
  possible.erase(std::unique(possible.begin(), possible.end()), possible.end());
  return possible;
}

}  // namespace

std::vector<SegmentElement> find_segment_elements(const model::Mesh& mesh,
                                                  std::span<const model::SegmentNodes> segments, MeshIndex& index) {
  std::unordered_map<SegmentKey, SegmentElement, SegmentKeyHash> wanted;
  std::vector<bool> used(mesh.nodes.size(), false);
  for (const auto& nodes : segments) {
    wanted.try_emplace(segment_key(nodes));
    for (const NodeIndex n : nodes) used[n.value] = true;
  }
  const auto all_used = [&](std::span<const NodeIndex> nodes) {
    return std::all_of(nodes.begin(), nodes.end(), [&](NodeIndex n) { return used[n.value]; });
  };
  const auto offer = [&](const model::SegmentNodes& nodes, std::uint32_t element, model::ElementKind kind) {
    if (!all_used(nodes)) return;
    const auto found = wanted.find(segment_key(nodes));
    if (found != wanted.end() && found->second.element == no_position) found->second = {element, kind};
  };
  for (const std::uint32_t e : possible_elements(mesh.shells, index.shells, segments, mesh.nodes.size()))
    offer(mesh.shells.nodes[e], e, model::ElementKind::shell);
  const auto offer_faces = [&](const model::Elements<8>& elements, ElementIndex& at, model::ElementKind kind) {
    if (elements.size() == 0) return;
    for (const std::uint32_t e : possible_elements(elements, at, segments, mesh.nodes.size())) {
      const auto& n = elements.nodes[e];
      if (std::count_if(n.begin(), n.end(), [&](NodeIndex i) { return used[i.value]; }) < 3) continue;
      for (const Face& face : faces_of(n, e, mesh.nodes.x)) offer(face.nodes, e, kind);
    }
  };
  offer_faces(mesh.solids, index.solids, model::ElementKind::solid);
  offer_faces(mesh.thick_shells, index.thick_shells, model::ElementKind::thick_shell);
  std::vector<SegmentElement> found;
  found.reserve(segments.size());
  for (const auto& nodes : segments) found.push_back(wanted[segment_key(nodes)]);
  return found;
}

}  // namespace gapcheck::contact
