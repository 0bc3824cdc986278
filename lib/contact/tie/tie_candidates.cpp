#include "contact/tie/tie_candidates.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gapcheck::contact {
namespace {

/// Share of the segment's shorter diagonal within which a node ties (contact rules, section 9.1).
constexpr double tie_diagonal_share = 0.05;
/// Nodes that no node set names count as meant to tie within this multiple of the tie distance.
constexpr double meant_to_tie = 2;
/// Segments count as equally near within this share of the tie distance.
constexpr double equally_near_to_tie = 1e-9;

struct Diagonals {
  double shorter, longer;
};

Diagonals diagonals(const geometry::Facet& f) {
  const double a = (f.x[2] - f.x[0]).squaredNorm(), b = (f.x[3] - f.x[1]).squaredNorm();
  return {std::sqrt(std::min(a, b)), std::sqrt(std::max(a, b))};
}

bool solid(const Segments& s, SegmentIndex i) {
  const model::ElementKind kind = s.element_kind[i.value];
  return kind == model::ElementKind::solid || kind == model::ElementKind::thick_shell;
}

/// A candidate pair with its tie distance.
struct Pair {
  SlotIndex slot;
  TieCandidate candidate;
  double allowed;
};

/// 0: ties, 1: holds the projection, 2: near.
std::size_t rank(const TieCandidate& c) { return c.ties ? 0 : c.on_segment ? 1 : 2; }

/// The best candidate of every slot, whatever the order of the pairs.
std::vector<TieCandidate> best_candidates(const std::vector<std::vector<Pair>>& lists, std::size_t slots) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<std::array<double, 3>> nearest(slots, {infinity, infinity, infinity});
  for (const auto& list : lists)
    for (const Pair& pair : list) {
      double& distance = nearest[pair.slot.value][rank(pair.candidate)];
      distance = std::min(distance, pair.candidate.distance);
    }
  std::vector<TieCandidate> best(slots);
  for (const auto& list : lists)
    for (const Pair& pair : list) {
      const auto& by_rank = nearest[pair.slot.value];
      const std::size_t first = by_rank[0] < infinity ? 0 : by_rank[1] < infinity ? 1 : 2;
      const TieCandidate& candidate = pair.candidate;
      if (rank(candidate) != first || candidate.distance > by_rank[first] + equally_near_to_tie * pair.allowed)
        continue;
      if (candidate.segment < best[pair.slot.value].segment) best[pair.slot.value] = candidate;
    }
  return best;
}

}  // namespace

double tie_distance(double node_thickness, double segment_thickness, double diagonal, bool solid_segment,
                    bool negative_thickness) {
  const double d1 = tie_thickness_share * (node_thickness + segment_thickness);
  const double d2 = tie_diagonal_share * diagonal;
  if (negative_thickness) return d1;
  return solid_segment ? d2 : std::max(d1, d2);
}

std::vector<TieCandidate> tie_candidates(const PairScene& scene, const CandidateSearch& search, const TieSearch& how,
                                         SweepCounters& counters, geometry::DecisionCounters& decisions) {
  const Segments& segments = scene.segments;
  const TrackedNodes& nodes = scene.nodes;
  const double largest_half = nodes.half.empty() ? 0 : *std::max_element(nodes.half.begin(), nodes.half.end());
  const auto limit = [&](double node_half, SegmentIndex s, double diagonal) {
    return tie_distance(2 * node_half, 2 * segments.half[s.value], diagonal, solid(segments, s), how.negative);
  };
  const auto reach = [&](SegmentIndex s) {
    const geometry::Facet facet = scene.facet(s);
    const Diagonals d = diagonals(facet);
    const double near = meant_to_tie * limit(largest_half, s, d.shorter);
    const double tolerance = 2 * default_tolerance(near, largest_coordinate(facet, facet.x[0]));
    return (how.node_set ? std::max(near, d.longer) : near) + tolerance;
  };
  // Each thread has a list of its own.
  struct Mine {
    std::vector<Pair> pairs;
    std::array<std::uint64_t, 4> stages{};
  };
  tbb::enumerable_thread_specific<Mine> found;
  for_each_candidate(scene, search, reach, counters, [&](SegmentIndex s, std::span<const SlotIndex> slots) {
    if (scene.line(s)) return;
    Mine& mine = found.local();
    const geometry::Facet facet = scene.facet(s);
    const double diagonal = diagonals(facet).shorter;
    for (const SlotIndex slot : slots) {
      if (how.single && scene.neighbours.in_ring(nodes.node[slot.value], s)) continue;
      const Vector at = scene.position(slot);
      const auto closest = geometry::closest_point(facet, at, how.parmax - 1);
      TieCandidate candidate{s, closest.in_band, false, std::sqrt(closest.squared_distance), diagonal};
      const double allowed = limit(nodes.half[slot.value], s, diagonal);
      const double tolerance = default_tolerance(allowed, largest_coordinate(facet, at));
      if (!std::isfinite(candidate.distance)) continue;
      if (!how.node_set && candidate.distance > meant_to_tie * allowed + tolerance) continue;
      if (candidate.on_segment) {
        const auto decision = geometry::decide(facet, at, allowed + tolerance, scene.mode, &closest);
        ++mine.stages[static_cast<std::size_t>(decision.stage)];
        candidate.ties = decision.closer;
      }
      mine.pairs.push_back({slot, candidate, allowed});
    }
  });
  std::vector<std::vector<Pair>> lists;
  for (Mine& mine : found) {
    lists.push_back(std::move(mine.pairs));
    for (std::size_t i = 0; i < mine.stages.size(); ++i)
      geometry::count(decisions, static_cast<geometry::Stage>(i), mine.stages[i]);
  }
  return best_candidates(lists, nodes.size());
}

}  // namespace gapcheck::contact
