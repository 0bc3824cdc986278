#include "contact/crossing/crossed_edges.hpp"

namespace gapcheck::contact {
namespace {

/// Pairs of a scene's edges that cross, as lines as thin as the tolerance that penetrate each other.
std::vector<EdgeHit> crossed_pairs(const model::Model& model, ContactIndex contact, EdgeScene& both,
                                   std::vector<SurfaceEdge> edges, const CrossingOptions& options,
                                   CrossingCounters& counters) {
  PairScene& scene = both.scene();
  scene.tolerance = 0;
  scene.mode = options.mode;
  for (SurfaceEdge& e : edges) e.half = 0.5 * crossed_edge_tolerance * (e.x[1] - e.x[0]).norm();
  const CrossingPairs pairs(model, model.contact(contact).id);
  const auto allowed = [&](const SurfaceEdge& e, const SurfaceEdge& f) {
    if (!both.opposite(e, f)) return false;
    const PartIndex a = part_of(model.mesh, scene.segments, e.segment.value),
                    b = part_of(model.mesh, scene.segments, f.segment.value);
    return pairs.takes_part(a) && pairs.takes_part(b) && pairs.counts(a, b);
  };
  std::uint64_t crowded = 0;  // lines as thin as these are only if thousands lie on each other
  return penetrating_edges(scene, edges, allowed, options.search, counters.decisions, crowded);
}

}  // namespace

std::vector<EdgeCrossing> find_crossed_edges(const model::Model& model, ContactIndex contact,
                                             const ContactSurfaces& surfaces, const CrossingOptions& options,
                                             CrossingCounters& counters) {
  EdgeScene both(model, contact, surfaces, model.mesh.nodes.x, false);
  const Segments& s = both.scene().segments;
  const std::vector<SurfaceEdge> edges = both.edges();
  const auto element = [&](const SurfaceEdge& edge) {
    const std::size_t i = edge.segment.value;
    return CrossingSegment{s.nodes[i], s.element_kind[i], s.element[i], part_of(model.mesh, s, i)};
  };
  std::vector<EdgeCrossing> found;
  for (const EdgeHit& hit : crossed_pairs(model, contact, both, edges, options, counters)) {
    const SurfaceEdge &e = edges[hit.tracked], &f = edges[hit.other];
    found.push_back({element(e), element(f), {e.a, e.b}, {f.a, f.b}, hit.closest.first});
  }
  return found;
}

std::vector<Penetration> crossed_edge_records(const model::Model& model, ContactIndex contact,
                                              const ContactSurfaces& surfaces, const CrossingOptions& options,
                                              CrossingCounters& counters) {
  EdgeScene both(model, contact, surfaces, model.mesh.nodes.x, false);
  const std::vector<SurfaceEdge> edges = both.edges();
  const std::vector<EdgeHit> hits = crossed_pairs(model, contact, both, edges, options, counters);
  return edge_records(both.scene(), contact, edges, hits);
}

}  // namespace gapcheck::contact
