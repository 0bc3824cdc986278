#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "contact/definition/exclusions.hpp"
#include "contact/pair/pair.hpp"
#include "contact/pair/tied_pairs.hpp"
#include "contact/search/box_pairs.hpp"
#include "geometry/edge_distance.hpp"
#include "records/penetration.hpp"

namespace gapcheck::contact {

/// An edge of a contact surface: a beam axis, or a side of a shell segment.
struct SurfaceEdge {
  SegmentIndex segment;  ///< of edges between shells the first one
  NodeIndex a, b;
  geometry::Edge x;  ///< its ends, mid-surface offsets included
  double half = 0;   ///< half the contact thickness; between shells the larger one
};

/// The edges that types 26 check, in the order of the segments: free edges of shells, with `interior` (type i26) also
/// those between shells, and beam axes. An edge is free if no other shell or solid facet of the surface has it.
[[nodiscard]] std::vector<SurfaceEdge> surface_edges(const PairScene& scene, bool interior);

/// The ends of an edge on the scene's present coordinates.
[[nodiscard]] geometry::Edge ends_of(const PairScene& scene, const SurfaceEdge& edge);

/// The relative position of two edges.
struct EdgeMeeting {
  geometry::EdgesClosest closest;
  /// The nearest points lie between the ends of both, and no end penetrates nearly as deep: not a case for nodes and
  /// segments.
  bool between = false;
  bool penetrates = false;                          ///< between, and nearer than the contact distance; decided exactly
  geometry::Stage stage = geometry::Stage::filter;  ///< which stage decided; only where `between`
};

/// Decides two edges against each other at the contact distance h.
[[nodiscard]] EdgeMeeting meet_edges(const PairScene& scene, const geometry::Edge& e, const geometry::Edge& f,
                                     double h);

/// Edges with a common node, or in the ring around each other's segment, never meet.
[[nodiscard]] bool edges_are_joined(const PairScene& scene, const SurfaceEdge& e, const SurfaceEdge& f);

/// False for edges of parts without contact between them, and if an end is tied to the other's part. May be called from
/// any thread while nothing is added to the ties.
class EdgeRules {
 public:
  EdgeRules(const PairScene& scene, const Exclusions& exclusions, const TiedPairs& ties)
      : scene_(scene), exclusions_(exclusions), ties_(ties) {}
  [[nodiscard]] bool operator()(const SurfaceEdge& e, const SurfaceEdge& f) const;

 private:
  const PairScene& scene_;
  const Exclusions& exclusions_;
  const TiedPairs& ties_;
};

/// The end of the edge that is nearer to a point at this position (-1 to 1).
[[nodiscard]] inline NodeIndex nearest_end(const SurfaceEdge& edge, double place) {
  return place <= 0 ? edge.a : edge.b;
}

/// To how many others an edge is compared where too many are within the contact thickness: the nearest ones.
inline constexpr std::uint32_t most_edges_each = 32;

/// Visits the pairs of edges whose boxes, grown by half their thickness, meet; if these are too many (crowded()), only
/// those of each edge with the `most_edges_each` others that are nearest to it. True if so; never by brute force.
[[nodiscard]] bool visit_edge_boxes(const std::vector<Bounds>& boxes, const BoxPairVisit& visit,
                                    BoxSearch search = BoxSearch::tree);

/// Two edges that penetrate each other between their ends.
struct EdgeHit {
  std::uint32_t tracked = 0, other = 0;  ///< positions in the list of edges
  geometry::EdgesClosest closest;        ///< `first` is on the tracked edge
};

/// Whether a pair of edges counts; asked only for pairs that penetrate. Called from any thread.
using EdgePairFilter = std::function<bool(const SurfaceEdge&, const SurfaceEdge&)>;

/// Pairs of edges that are nearer to each other than h = half + half, decided exactly, with their nearest points
/// between the ends of both. Where an end is nearest, or penetrates nearly as deep, it is a case for nodes and
/// segments. Edges with a common node, or in the ring around each other's segment, are left out. Of a beam and a shell
/// edge the beam is tracked, otherwise the first. Ascending by tracked, then other edge. `crowded_edges`: rises by
/// their number if there are too many pairs (visit_edge_boxes()).
[[nodiscard]] std::vector<EdgeHit> penetrating_edges(const PairScene& scene, const std::vector<SurfaceEdge>& edges,
                                                     const EdgePairFilter& allowed, BoxSearch search,
                                                     geometry::DecisionCounters& decisions,
                                                     std::uint64_t& crowded_edges);

/// The hits as records of contact number `contact`, one for each node: the deepest of the edges whose nearest end it
/// is.
[[nodiscard]] std::vector<Penetration> edge_records(const PairScene& scene, ContactIndex contact,
                                                    const std::vector<SurfaceEdge>& edges,
                                                    const std::vector<EdgeHit>& hits);

}  // namespace gapcheck::contact
