#include "contact/edge/edge_pairs.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "base/parallel.hpp"
#include "contact/definition/outcome.hpp"
#include "contact/search/nearest_boxes.hpp"

namespace gapcheck::contact {
namespace {

/// An end that penetrates by at most this share of h less than the edges do says as much as they.
constexpr double nearly_as_deep = 0.05;

bool seen_by_nodes(const geometry::EdgesClosest& closest, double h) {
  const double end = std::sqrt(closest.squared_end_distance);
  return end < h && end - std::sqrt(closest.squared_distance) < nearly_as_deep * h;
}

/// What is on the other side of a shell's edge.
struct Beyond {
  bool free = true;   ///< no facet
  bool first = true;  ///< no shell that comes earlier
  double half = 0;    ///< largest of the shells
};

Beyond beyond(const PairScene& scene, SegmentIndex segment, NodeIndex a, NodeIndex b) {
  const Segments& s = scene.segments;
  Beyond result;
  for (const SegmentIndex other : scene.neighbours.at(a)) {
    if (other == segment || s.kind[other.value] == SegmentKind::line || !is_corner(s.nodes[other.value], b)) continue;
    result.free = false;
    if (s.kind[other.value] != SegmentKind::shell) continue;
    result.first = result.first && other > segment;
    result.half = std::max(result.half, s.half[other.value]);
  }
  return result;
}

void append_edges(const PairScene& scene, SegmentIndex segment, bool interior, std::vector<SurfaceEdge>& edges) {
  const Segments& s = scene.segments;
  const auto& n = s.nodes[segment.value];
  if (s.kind[segment.value] == SegmentKind::line) {
    edges.push_back({segment, n[0], n[1], {scene.x[n[0].value], scene.x[n[1].value]}, s.half[segment.value]});
    return;
  }
  if (s.kind[segment.value] != SegmentKind::shell) return;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if (n[i] == n[next]) continue;
    const Beyond other = beyond(scene, segment, n[i], n[next]);
    if (interior ? !other.first : !other.free) continue;
    const geometry::Facet facet = scene.facet(segment);
    edges.push_back({segment, n[i], n[next], {facet.x[i], facet.x[next]}, std::max(s.half[segment.value], other.half)});
  }
}

/// Grown by half the contact thickness and rounded outward: edges that penetrate have boxes that meet.
Bounds box_of(const SurfaceEdge& edge) {
  Bounds box;
  if (!edge.x[0].allFinite() || !edge.x[1].allFinite()) return box;
  box.add(edge.x[0]);
  box.add(edge.x[1]);
  return grown(box, edge.half);
}

bool have_a_common_end(const SurfaceEdge& e, const SurfaceEdge& f) {
  return e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b;
}

double largest_end_coordinate(const geometry::Edge& e) {
  return std::max(e[0].cwiseAbs().maxCoeff(), e[1].cwiseAbs().maxCoeff());
}

}  // namespace

geometry::Edge ends_of(const PairScene& scene, const SurfaceEdge& edge) {
  const auto& n = scene.segments.nodes[edge.segment.value];
  const geometry::Facet facet = scene.facet(edge.segment);
  const auto corner = [&](NodeIndex node) -> const Vector& {
    return facet.x[static_cast<std::size_t>(std::find(n.begin(), n.end() - 1, node) - n.begin())];
  };
  return {corner(edge.a), corner(edge.b)};
}

EdgeMeeting meet_edges(const PairScene& scene, const geometry::Edge& e, const geometry::Edge& f, double h) {
  EdgeMeeting meeting;
  meeting.closest = geometry::closest_points(e, f);
  meeting.between = meeting.closest.interior && !seen_by_nodes(meeting.closest, h);
  if (!meeting.between) return meeting;
  const double tolerance = scene.tolerance >= 0
                               ? scene.tolerance
                               : default_tolerance(h, std::max(largest_end_coordinate(e), largest_end_coordinate(f)));
  const geometry::Decision decision = geometry::decide_edges(e, f, h - tolerance, scene.mode, &meeting.closest);
  meeting.penetrates = decision.closer;
  meeting.stage = decision.stage;
  return meeting;
}

bool edges_are_joined(const PairScene& scene, const SurfaceEdge& e, const SurfaceEdge& f) {
  if (have_a_common_end(e, f)) return true;
  const Neighbours& around = scene.neighbours;
  return around.in_ring(e.a, f.segment) || around.in_ring(e.b, f.segment) || around.in_ring(f.a, e.segment) ||
         around.in_ring(f.b, e.segment);
}

bool EdgeRules::operator()(const SurfaceEdge& e, const SurfaceEdge& f) const {
  const PartIndex part_e = part_of(scene_.model.mesh, scene_.segments, e.segment.value);
  const PartIndex part_f = part_of(scene_.model.mesh, scene_.segments, f.segment.value);
  if (!exclusions_.empty() && exclusions_.excluded(part_e, part_f)) return false;
  return !ties_.tied(e.a, part_f) && !ties_.tied(e.b, part_f) && !ties_.tied(f.a, part_e) && !ties_.tied(f.b, part_e);
}

std::vector<SurfaceEdge> surface_edges(const PairScene& scene, bool interior) {
  constexpr std::size_t grain = 4096;
  const std::size_t size = scene.segments.size();
  std::vector<std::vector<SurfaceEdge>> pieces((size + grain - 1) / grain);
  parallel_for(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      for (std::size_t s = p * grain; s < std::min(size, (p + 1) * grain); ++s)
        append_edges(scene, to_index<SegmentIndex>(s), interior, pieces[p]);
  });
  std::vector<SurfaceEdge> edges;
  for (const auto& piece : pieces) edges.insert(edges.end(), piece.begin(), piece.end());
  return edges;
}

bool visit_edge_boxes(const std::vector<Bounds>& boxes, const BoxPairVisit& visit, BoxSearch search) {
  const bool nearest_only = search == BoxSearch::tree && crowded(boxes);
  if (nearest_only)
    for_each_near_box_pair(boxes, most_edges_each, visit);
  else
    for_each_box_pair(boxes, visit, search);
  return nearest_only;
}

std::vector<EdgeHit> penetrating_edges(const PairScene& scene, const std::vector<SurfaceEdge>& edges,
                                       const EdgePairFilter& allowed, BoxSearch search,
                                       geometry::DecisionCounters& decisions, std::uint64_t& crowded_edges) {
  std::vector<Bounds> boxes;
  boxes.reserve(edges.size());
  for (const SurfaceEdge& edge : edges) boxes.push_back(box_of(edge));
  struct Mine {
    std::vector<EdgeHit> hits;
    std::array<std::uint64_t, 4> stages{};
  };
  tbb::enumerable_thread_specific<Mine> found;
  const auto line = [&](std::uint32_t e) { return scene.line(edges[e].segment); };
  const auto visit = [&](std::uint32_t i, std::uint32_t k) {
    const bool swap = line(k) && !line(i);
    const std::uint32_t tracked = swap ? k : i, other = swap ? i : k;
    const SurfaceEdge &e = edges[tracked], &f = edges[other];
    if (have_a_common_end(e, f)) return;
    const EdgeMeeting meeting = meet_edges(scene, e.x, f.x, e.half + f.half);
    if (!meeting.between) return;
    Mine& mine = found.local();
    ++mine.stages[static_cast<std::size_t>(meeting.stage)];
    if (meeting.penetrates && !edges_are_joined(scene, e, f) && allowed(e, f))
      mine.hits.push_back({tracked, other, meeting.closest});
  };
  if (visit_edge_boxes(boxes, visit, search)) crowded_edges += edges.size();
  std::vector<EdgeHit> all;
  for (const Mine& mine : found) {
    all.insert(all.end(), mine.hits.begin(), mine.hits.end());
    for (std::size_t i = 0; i < mine.stages.size(); ++i)
      geometry::count(decisions, static_cast<geometry::Stage>(i), mine.stages[i]);
  }
  std::sort(all.begin(), all.end(), [](const EdgeHit& l, const EdgeHit& r) {
    return std::tie(l.tracked, l.other) < std::tie(r.tracked, r.other);
  });
  return all;
}

std::vector<Penetration> edge_records(const PairScene& scene, ContactIndex contact,
                                      const std::vector<SurfaceEdge>& edges, const std::vector<EdgeHit>& hits) {
  const model::Nodes& all = scene.model.mesh.nodes;
  const Segments& s = scene.segments;
  const auto depth = [&](const EdgeHit& hit) {
    return edges[hit.tracked].half + edges[hit.other].half - std::sqrt(hit.closest.squared_distance);
  };
  std::map<NodeIndex, const EdgeHit*> deepest;
  for (const EdgeHit& hit : hits) {
    const EdgeHit*& best = deepest[nearest_end(edges[hit.tracked], hit.closest.s)];
    if (best == nullptr || depth(hit) > depth(*best)) best = &hit;
  }
  const auto part_id = [&](SegmentIndex segment) {
    const PartIndex part = part_of(scene.model.mesh, s, segment.value);
    return part == none<PartIndex> ? 0 : scene.model.part(part).id.value;
  };
  std::vector<Penetration> records;
  records.reserve(deepest.size());
  for (const auto& [node, hit] : deepest) {
    const SurfaceEdge &tracked = edges[hit->tracked], &other = edges[hit->other];
    Penetration p;
    p.kind = PenetrationKind::edge;
    p.contact = contact.value;
    p.segment_number = other.segment.value + 1;
    p.node = all.id[node.value];
    p.part = part_id(tracked.segment);
    const std::int64_t last = all.id[other.b.value];
    p.segment = {all.id[other.a.value], last, last, last};
    p.element = element_id(scene.model.mesh, s, other.segment.value);
    p.element_part = part_id(other.segment);
    p.depth = depth(*hit);
    p.contact_distance = tracked.half + other.half;
    p.s = hit->closest.t;
    p.t = hit->closest.s;
    p.original = p.moved_to = hit->closest.first;
    p.point = hit->closest.second;
    p.feature = Feature::edge;
    p.outcome = outcome(scene.settings);
    if (p.outcome == Outcome::moved) p.outcome = Outcome::forced;  // edges are not moved
    p.node_rule = s.rule[tracked.segment.value];
    p.segment_rule = s.rule[other.segment.value];
    p.file = all.origins.file(node.value).value;
    p.line = all.line[node.value];
    records.push_back(p);
  }
  return records;
}

}  // namespace gapcheck::contact
