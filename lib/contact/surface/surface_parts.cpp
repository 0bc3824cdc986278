#include "contact/surface/surface_parts.hpp"

#include <algorithm>
#include <tuple>

#include "base/parallel.hpp"
#include "contact/mesh/faces_at.hpp"
#include "contact/mesh/mean_edge.hpp"

namespace gapcheck::contact {
namespace {

void sort_unique(std::vector<PartIndex>& parts) {
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  if (!parts.empty() && parts.back() == none<PartIndex>) parts.pop_back();
}

/// An edge with its nodes in ascending order, and the direction in which the segment runs along it.
struct HalfEdge {
  NodeIndex low, high;
  SegmentIndex segment;
  bool forward = true;
};

std::vector<HalfEdge> half_edges(const Segments& s) {
  std::vector<HalfEdge> edges;
  edges.reserve(4 * s.size());
  for (const SegmentIndex i : positions<SegmentIndex>(s.size())) {
    const model::SegmentNodes& n = s.nodes[i.value];
    if (s.kind[i.value] == SegmentKind::line) continue;
    for (std::size_t c = 0; c < 4; ++c) {
      const NodeIndex a = n[c], b = n[(c + 1) % 4];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), i, a < b});
    }
  }
  parallel_sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.segment) < std::tie(b.low, b.high, b.segment);
  });
  return edges;
}

/// Two segments with an edge in common.
struct Link {
  SegmentIndex other;
  bool turned = false;
};

std::vector<std::vector<Link>> links_between(const Segments& s) {
  std::vector<std::vector<Link>> links(s.size());
  const std::vector<HalfEdge> edges = half_edges(s);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end == i + 2) {
      const bool turned = edges[i].forward == edges[i + 1].forward;
      links[edges[i].segment.value].push_back({edges[i + 1].segment, turned});
      links[edges[i + 1].segment.value].push_back({edges[i].segment, turned});
    }
    i = end;
  }
  return links;
}

}  // namespace

std::vector<PartIndex> parts_of(const model::Model& model, const ContactSide& side) {
  std::vector<PartIndex> parts;
  const auto add = [&](PartIndex part) {
    if (parts.empty() || parts.back() != part) parts.push_back(part);
  };
  const Segments& s = side.selection.segments;
  for (std::size_t i = 0; i < s.size(); ++i) add(part_of(model.mesh, s, i));
  if (side.nodes_only)
    for (const PartIndex part : side.nodes.part) add(part);
  sort_unique(parts);
  return parts;
}

bool whole_parts(const model::SurfaceInput& input) {
  using enum model::SurfaceType;
  const auto type = static_cast<model::SurfaceType>(input.type);
  return input.box == 0 &&
         (type == part_set || type == part || type == all || type == exempted_part_set || type == branch);
}

double mean_edge(const model::Model& model, const ContactSide& side) {
  const std::vector<Vector>& x = model.mesh.nodes.x;
  MeanEdge edges;
  const Segments& s = side.selection.segments;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] != SegmentKind::line) edges.add(s.nodes[i], x);
  if (!side.nodes_only) return edges.value();
  std::vector<bool> tracked(x.size(), false);
  for (const NodeIndex n : side.selection.nodes) tracked[n.value] = true;
  const auto is_tracked = [&](NodeIndex n) { return tracked[n.value]; };
  for_each_face_at(model.mesh, is_tracked, [&](const model::SegmentNodes& face) {
    if (std::all_of(face.begin(), face.end(), is_tracked)) edges.add(face, x);
  });
  return edges.value();
}

void for_each_connected_surface(const Segments& s, const std::function<void(const ConnectedSurface&)>& visit) {
  const auto links = links_between(s);
  enum class Sense : std::uint8_t { unseen, same, turned };
  std::vector<Sense> sense(s.size(), Sense::unseen);
  ConnectedSurface surface;
  for (const SegmentIndex first : positions<SegmentIndex>(s.size())) {
    if (sense[first.value] != Sense::unseen) continue;
    sense[first.value] = Sense::same;
    std::vector<SegmentIndex>& segments = surface.segments;
    segments.assign(1, first);
    std::size_t turned = 0;
    for (std::size_t next = 0; next < segments.size(); ++next) {
      const bool own = sense[segments[next].value] == Sense::turned;
      for (const Link& link : links[segments[next].value]) {
        if (sense[link.other.value] != Sense::unseen) continue;
        const bool other = own != link.turned;
        sense[link.other.value] = other ? Sense::turned : Sense::same;
        turned += other ? 1 : 0;
        segments.push_back(link.other);
      }
    }
    const Sense fewer = 2 * turned <= segments.size() ? Sense::turned : Sense::same;
    surface.turned.clear();
    for (const SegmentIndex i : segments)
      if (sense[i.value] == fewer) surface.turned.push_back(i);
    visit(surface);
  }
}

std::vector<Misoriented> misoriented_segments(const model::Mesh& mesh, const Segments& s) {
  std::vector<Misoriented> found;
  for_each_connected_surface(s, [&](const ConnectedSurface& surface) {
    for (const SegmentIndex i : surface.turned) found.push_back({i, part_of(mesh, s, i.value)});
  });
  std::sort(found.begin(), found.end(),
            [](const Misoriented& a, const Misoriented& b) { return a.segment < b.segment; });
  return found;
}

}  // namespace gapcheck::contact
