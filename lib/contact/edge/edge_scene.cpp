#include "contact/edge/edge_scene.hpp"

#include <algorithm>
#include <map>

namespace gapcheck::contact {
namespace {

void append(Segments& all, const Segments& more) {
  const auto join = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  const std::size_t before = all.size();
  join(all.nodes, more.nodes);
  join(all.element, more.element);
  join(all.element_kind, more.element_kind);
  join(all.kind, more.kind);
  join(all.half, more.half);
  join(all.rule, more.rule);
  if (all.offset.empty() && more.offset.empty()) return;
  all.offset.resize(before, 0);
  join(all.offset, more.offset);
  all.offset.resize(all.size(), 0);
}

Segments both_sides(const ContactSurfaces& surfaces) {
  Segments both;
  if (!surfaces.two_sided()) return both;
  append(both, surfaces.a.selection.segments);
  append(both, surfaces.b.selection.segments);
  return both;
}

}  // namespace

bool looks_at_edges(const model::Contact& contact, const ContactType& type) {
  constexpr std::int64_t edge_to_edge = 5;  // last digit of DEPTH
  if (type.pairing == Pairing::none) return false;
  return type.edges || (type.pairing == Pairing::segments && contact.depth > 0 && contact.depth % 10 == edge_to_edge);
}

EdgeScene::EdgeScene(const model::Model& model, ContactIndex contact, const ContactSurfaces& surfaces,
                     const std::vector<Vector>& x, bool whole_solids)
    : of_a_(surfaces.a.selection.segments.size()),
      two_sided_(surfaces.two_sided()),
      both_(both_sides(surfaces)),
      segments_(two_sided_ ? both_ : surfaces.a.selection.segments),
      neighbours_(segments_, model.mesh, whole_solids),
      scene_{model,
             model.contact(contact),
             surfaces.type,
             surfaces.settings,
             x,
             segments_,
             surfaces.a.nodes,
             neighbours_,
             model.contact(contact).a.type,
             {},
             {}} {}

std::vector<SurfaceEdge> EdgeScene::edges() const {
  std::vector<SurfaceEdge> edges = surface_edges(scene_, scene_.type.interior_edges);
  if (!scene_.type.edges)
    std::erase_if(edges, [&](const SurfaceEdge& e) { return segments_.kind[e.segment.value] == SegmentKind::line; });
  return edges;
}

ContactSurfaces free_edge_surface(const model::Model& model, ContactIndex contact, const ContactSurfaces& surfaces,
                                  const std::vector<Vector>& x) {
  constexpr double limit = 0.2;  // of the shortest edge, for half a thickness
  ContactType type = surfaces.type;
  type.treatment = Treatment::single_surface;
  ContactSide only_shells;
  only_shells.selection = surfaces.a.selection;
  const ContactSurfaces shells(type, surfaces.settings, std::make_shared<const ContactSide>(std::move(only_shells)));
  const EdgeScene scene(model, contact, shells, x, false);
  const Segments& of = scene.scene().segments;
  ContactSide lines;
  Segments& s = lines.selection.segments;
  std::map<NodeIndex, std::uint32_t> ends;  // by node: the thickest line
  for (const SurfaceEdge& edge : scene.edges()) {
    const std::size_t i = edge.segment.value;
    const double most = model.controls.ssthk == 0 ? limit * shortest_edge(of.nodes[i], x) : edge.half;
    s.nodes.push_back({edge.a, edge.b, edge.b, edge.b});
    s.element.push_back(of.element[i]);
    s.element_kind.push_back(of.element_kind[i]);
    s.kind.push_back(SegmentKind::line);
    s.half.push_back(std::min(edge.half, most));
    s.rule.push_back(of.rule[i]);
    const auto line = static_cast<std::uint32_t>(s.size() - 1);
    for (const NodeIndex end : {edge.a, edge.b}) {
      const auto known = ends.emplace(end, line).first;
      if (s.half[line] > s.half[known->second]) known->second = line;
    }
  }
  lines.lines = s.size();
  TrackedNodes& nodes = lines.nodes;
  for (const auto& [node, line] : ends) {
    nodes.node.push_back(node);
    nodes.half.push_back(s.half[line]);
    nodes.rule.push_back(s.rule[line]);
    nodes.part.push_back(part_of(model.mesh, s, line));
  }
  type.family = Family::automatic;
  type.pairing = Pairing::nodes;
  type.edges = true;
  return {type, surfaces.settings, std::make_shared<const ContactSide>(std::move(lines))};
}

}  // namespace gapcheck::contact
