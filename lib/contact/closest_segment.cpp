#include "contact/closest_segment.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "base/parallel.hpp"

namespace gapcheck::contact {
namespace {

/// Segments count as equally near within this share of the distance.
constexpr double equally_near = 1e-9;
constexpr std::size_t grain = 4096;

bool is_corner(const model::SegmentNodes& n, NodeIndex node) {
  return n[0] == node || n[1] == node || n[2] == node || n[3] == node;
}

/// The best hit of every tracked node.
std::vector<Hit> best_hits(const std::vector<Hit>& all, std::size_t slots) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();
  struct Nearest {
    double in_band = infinity, outside = infinity;
    std::uint32_t hit = nothing;
  };
  std::vector<Nearest> nearest(slots);
  for (const Hit& hit : all) {
    double& distance = hit.in_band ? nearest[hit.slot].in_band : nearest[hit.slot].outside;
    distance = std::min(distance, std::abs(hit.distance));
  }
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    Nearest& n = nearest[all[i].slot];
    const bool any_in_band = n.in_band < infinity;
    if (any_in_band && !all[i].in_band) continue;
    if (std::abs(all[i].distance) > (any_in_band ? n.in_band : n.outside) * (1 + equally_near)) continue;
    if (n.hit == nothing || all[i].segment < all[n.hit].segment) n.hit = i;
  }
  std::vector<Hit> chosen;
  for (const Nearest& n : nearest)
    if (n.hit != nothing) chosen.push_back(all[n.hit]);
  return chosen;
}

/// A node lies inside a body only if it is behind the body's nearest facet: behind a farther one also lies what is outside
/// on another side. Takes out hits behind a facet that is not the nearest of its part; `measured` are the pairs with
/// oriented facets that are no hits.
void keep_nearest_facets(std::vector<Hit>& hits, const std::vector<Hit>& measured, const PairScene& scene) {
  const auto behind = [](const Hit& hit) { return std::signbit(hit.distance); };
  if (std::none_of(hits.begin(), hits.end(), behind)) return;
  const auto key = [&](const Hit& hit) {
    const std::uint32_t body = scene.solids.empty() ? 0 : scene.solids.body[hit.segment];
    return std::uint64_t{hit.slot} << 32 | body;
  };
  std::unordered_map<std::uint64_t, double> nearest;
  const auto offer = [&](const Hit& hit) {
    double& distance = nearest.try_emplace(key(hit), std::abs(hit.distance)).first->second;
    distance = std::min(distance, std::abs(hit.distance));
  };
  for (const Hit& hit : measured) offer(hit);
  for (const Hit& hit : hits)
    if (scene.oriented(hit.segment)) offer(hit);
  std::erase_if(hits, [&](const Hit& hit) {
    return behind(hit) && std::abs(hit.distance) > nearest.at(key(hit)) * (1 + equally_near);
  });
}

}  // namespace

void for_each_candidate(const PairScene& scene, const CandidateSearch& search,
                        const std::function<double(std::uint32_t)>& reach, SweepCounters& counters,
                        const std::function<void(std::uint32_t, std::span<const std::uint32_t>)>& visit) {
  const Segments& s = scene.segments;
  std::vector<Bounds> boxes(s.size());
  parallel_for(s.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto segment = static_cast<std::uint32_t>(i);
      Bounds box;
      for (const NodeIndex n : s.nodes[i]) box.add(scene.x[n.value]);
      if (scene.passive(segment)) continue;
      boxes[i] = grown(box, reach(segment) + (s.offset.empty() ? 0 : std::abs(s.offset[i])));
    }
  });
  // Cull by the boxes of the two sides before anything is sorted.
  Bounds all_boxes, all_points;
  for (const Bounds& b : boxes) {
    all_boxes.low = all_boxes.low.cwiseMin(b.low);
    all_boxes.high = all_boxes.high.cwiseMax(b.high);
  }
  std::vector<Vector> points;
  std::vector<std::uint32_t> slots;
  points.reserve(scene.nodes.size());
  slots.reserve(scene.nodes.size());
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    const Vector p = scene.position(i);
    if (!(p.array() >= all_boxes.low.array()).all() || !(p.array() <= all_boxes.high.array()).all()) continue;
    points.push_back(p);
    slots.push_back(i);
    all_points.add(p);
  }
  counters.points_culled += scene.nodes.size() - points.size();
  std::uint64_t culled = 0;
  for (Bounds& b : boxes) {
    if (points.empty() || !b.meets(all_points)) {
      b = Bounds{};
      ++culled;
    }
  }
  counters.segments_culled += culled;
  if (points.empty()) return;
  std::atomic<std::uint64_t> pairs{0};
  search.run(points, boxes, [&](std::uint32_t segment, std::span<const std::uint32_t> inside) {
    static thread_local std::vector<std::uint32_t> local;
    local.clear();
    const auto& corners = s.nodes[segment];
    for (const std::uint32_t p : inside)
      if (!is_corner(corners, scene.nodes.node[slots[p]])) local.push_back(slots[p]);
    pairs.fetch_add(local.size(), std::memory_order_relaxed);
    if (!local.empty()) visit(segment, local);
  });
  counters.candidate_pairs += pairs;
}

std::vector<Hit> closest_segments(const PairScene& scene, const CandidateSearch& search,
                                  const PairFilter& pair_allowed,
                                  SweepCounters& counters, geometry::DecisionCounters& decisions) {
  double largest_half = 0;
  for (const double half : scene.nodes.half) largest_half = std::max(largest_half, half);
  // Each thread has a tally of its own: shared counters would cost more than the decisions.
  struct Mine {
    std::vector<Hit> hits, measured;
    std::array<std::uint64_t, 4> stages{};
  };
  tbb::enumerable_thread_specific<Mine> found;
  for_each_candidate(
      scene, search, [&](std::uint32_t s) { return scene.reach(s, largest_half); }, counters,
      [&](std::uint32_t segment, std::span<const std::uint32_t> slots) {
        Mine& mine = found.local();
        for (const std::uint32_t slot : slots) {
          const PairResult pair = decide_pair(scene, slot, segment);
          ++mine.stages[static_cast<std::size_t>(pair.stage)];
          if (!pair.penetrates && !scene.oriented(segment)) continue;
          if (pair_allowed(slot, segment, pair.penetrates))
            (pair.penetrates ? mine.hits : mine.measured).push_back({slot, segment, pair.distance, pair.in_band});
        }
      });
  std::vector<Hit> all, measured;
  for (const Mine& mine : found) {
    all.insert(all.end(), mine.hits.begin(), mine.hits.end());
    measured.insert(measured.end(), mine.measured.begin(), mine.measured.end());
    for (std::size_t i = 0; i < mine.stages.size(); ++i)
      geometry::count(decisions, static_cast<geometry::Stage>(i), mine.stages[i]);
  }
  keep_nearest_facets(all, measured, scene);
  return best_hits(all, scene.nodes.size());
}

}  // namespace gapcheck::contact
