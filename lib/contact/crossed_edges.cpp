#include "contact/crossed_edges.hpp"

#include <algorithm>

#include "contact/edge_pairs.hpp"

namespace gapcheck::contact {
namespace {

void append(Segments& all, const Segments& more) {
  const auto join = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  join(all.nodes, more.nodes);
  join(all.element, more.element);
  join(all.element_kind, more.element_kind);
  join(all.kind, more.kind);
  join(all.half, more.half);
  join(all.rule, more.rule);
}

}  // namespace

bool looks_at_edges(const model::Contact& contact, const ContactType& type) {
  constexpr std::int64_t edge_to_edge = 5;  // last digit of DEPTH
  if (type.pairing == Pairing::none) return false;
  return type.edges || (type.pairing == Pairing::segments && contact.depth > 0 && contact.depth % 10 == edge_to_edge);
}

std::vector<EdgeCrossing> find_crossed_edges(const model::Model& model, std::uint32_t contact,
                                             const ContactSurfaces& surfaces, const CrossingOptions& options,
                                             CrossingCounters& counters) {
  // Both sides of a contact as one surface; only pairs between the sides are let through below.
  const std::size_t of_a = surfaces.a.selection.segments.size();
  Segments both;
  if (surfaces.two_sided()) {
    append(both, surfaces.a.selection.segments);
    append(both, surfaces.b.selection.segments);
  }
  const Segments& s = surfaces.two_sided() ? both : surfaces.a.selection.segments;
  const Neighbours neighbours(s, model.mesh);
  const PairScene scene{model,      model.contacts[contact], surfaces.type, surfaces.settings, model.mesh.nodes.x, s,
                        surfaces.a.nodes, neighbours, model.contacts[contact].a.type, {}, {}, 0, options.mode};
  std::vector<SurfaceEdge> edges = surface_edges(scene, surfaces.type.interior_edges);
  if (!surfaces.type.edges) std::erase_if(edges, [&](const SurfaceEdge& e) { return s.kind[e.segment] == SegmentKind::line; });
  // Lines as thin as the tolerance that penetrate each other.
  for (SurfaceEdge& e : edges) e.half = 0.5 * crossing_tolerance * (e.x[1] - e.x[0]).norm();

  const CrossingPairs pairs(model, model.contacts[contact].id);
  const auto allowed = [&](const SurfaceEdge& e, const SurfaceEdge& f) {
    if (surfaces.two_sided() && (e.segment < of_a) == (f.segment < of_a)) return false;
    const PartIndex a = part_of(model.mesh, s, e.segment), b = part_of(model.mesh, s, f.segment);
    return pairs.takes_part(a) && pairs.takes_part(b) && pairs.counts(a, b);
  };
  const auto segment = [&](std::uint32_t i) {
    return CrossingSegment{s.nodes[i], s.element_kind[i], s.element[i], part_of(model.mesh, s, i)};
  };
  std::vector<EdgeCrossing> found;
  for (const EdgeHit& hit : penetrating_edges(scene, edges, allowed, options.search, counters.decisions)) {
    const SurfaceEdge &e = edges[hit.tracked], &f = edges[hit.other];
    found.push_back({segment(e.segment), segment(f.segment), {e.a, e.b}, {f.a, f.b}, hit.closest.first});
  }
  return found;
}

}  // namespace gapcheck::contact
