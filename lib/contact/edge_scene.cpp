#include "contact/edge_scene.hpp"

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

Segments joined(const ContactSurfaces& surfaces) {
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

EdgeScene::EdgeScene(const model::Model& model, std::uint32_t contact, const ContactSurfaces& surfaces,
                     const std::vector<Vector>& x, bool whole_solids)
    : of_a_(surfaces.a.selection.segments.size()),
      two_sided_(surfaces.two_sided()),
      both_(joined(surfaces)),
      segments_(two_sided_ ? both_ : surfaces.a.selection.segments),
      neighbours_(segments_, model.mesh, whole_solids),
      scene_{model,
             model.contacts[contact],
             surfaces.type,
             surfaces.settings,
             x,
             segments_,
             surfaces.a.nodes,
             neighbours_,
             model.contacts[contact].a.type,
             {},
             {}} {}

std::vector<SurfaceEdge> EdgeScene::edges() const {
  std::vector<SurfaceEdge> edges = surface_edges(scene_, scene_.type.interior_edges);
  if (!scene_.type.edges)
    std::erase_if(edges, [&](const SurfaceEdge& e) { return segments_.kind[e.segment] == SegmentKind::line; });
  return edges;
}

}  // namespace gapcheck::contact
