#include "contact/pair/closest_segment.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include "base/parallel.hpp"
#include "contact/pair/hidden_faces.hpp"
#include "contact/pair/nearer_segments.hpp"
#include "contact/pair/nearest_hits.hpp"
#include "contact/search/nearest_boxes.hpp"
#include "geometry/pair_batch.hpp"
#include "geometry/view.hpp"

namespace gapcheck::contact {
namespace {

/// Hits by slot: those of slot i are in [start[i], start[i + 1]).
struct BySlot {
  std::vector<std::uint32_t> start;
  std::vector<Hit> hits;
  BySlot(const std::vector<Hit>& all, std::size_t slots) : start(slots + 2, 0), hits(all.size()) {
    // Counts two entries ahead, so that filling leaves every start correct.
    for (const Hit& hit : all) ++start[hit.slot.value + 2];
    for (std::size_t i = 0; i < slots; ++i) start[i + 2] += start[i + 1];
    for (const Hit& hit : all) hits[start[hit.slot.value + 1]++] = hit;
  }
  [[nodiscard]] std::span<const Hit> of(std::size_t slot) const {
    return {hits.data() + start[slot], hits.data() + start[slot + 1]};
  }
};

/// Proves the facet farther from the query than the limit, by the plane through the facet's point (s, t) that faces the
/// query. The distances that are compared later are rounded, by far less than the margin.
bool proven_farther(const geometry::Facet& facet, const Vector& query, double s, double t, double limit) {
  const geometry::Corners e = geometry::seen_from(facet, query);
  const Vector point =
      ((1 - s) * (1 - t) * e[0] + (1 + s) * (1 - t) * e[1] + (1 + s) * (1 + t) * e[2] + (1 - s) * (1 + t) * e[3]) / 4;
  double least = point.dot(e[0]), size = 0;
  for (const Vector& corner : e) {
    least = std::min(least, point.dot(corner));
    size = std::max(size, corner.cwiseAbs().maxCoeff());
  }
  constexpr double margin = 1e-9;
  const double bound = (limit + margin * size) * (1 + margin);
  return least > 0 && least * least > bound * bound * point.squaredNorm();
}

/// Decides pairs and keeps those that count; one for each thread. Two-sided segments go through batches: for a pair
/// that is apart, they need to know nothing more.
class PairSweep {
 public:
  PairSweep(const PairScene& scene, const PairFilter& pair_allowed, NearestHits& nearest)
      : scene_(scene), allowed_(pair_allowed), nearest_(nearest) {}

  void visit(SegmentIndex segment, std::span<const SlotIndex> slots) {
    if (scene_.mode == geometry::Mode::exact || scene_.line(segment) || scene_.oriented(segment)) {
      for (const SlotIndex slot : slots) decide_alone(slot, segment);
      return;
    }
    const geometry::Facet facet = scene_.facet(segment);
    for (const SlotIndex slot : slots) add(slot, segment, facet);
  }
  /// What still waits in the batches.
  void finish() {
    for (Waiting& waiting : waiting_) flush(waiting);
  }
  /// Once all sweeps have finished: moves the hits that may count, and the pairs with oriented segments that are not
  /// hits, to lists that the sweeps share.
  void move_hits(std::vector<Hit>& hits, std::vector<Hit>& measured) {
    std::erase_if(hits_, [&](const Hit& hit) { return !nearest_.may_count(hit); });
    hits.insert(hits.end(), hits_.begin(), hits_.end());
    measured.insert(measured.end(), measured_.begin(), measured_.end());
    hits_ = measured_ = {};
  }
  [[nodiscard]] std::uint64_t decided_by(geometry::Stage stage) const {
    return stages_[static_cast<std::size_t>(stage)];
  }

 private:
  struct Pair {
    SlotIndex slot;
    SegmentIndex segment;
  };
  struct Waiting {
    geometry::PairBatch batch;
    std::array<Pair, geometry::PairBatch::capacity> pairs{};
  };

  void count(geometry::Stage stage, std::size_t times) { stages_[static_cast<std::size_t>(stage)] += times; }

  void add(SlotIndex slot, SegmentIndex segment, const geometry::Facet& facet) {
    const Vector query = scene_.position(slot);
    const geometry::Corners corners = geometry::seen_from(facet, query);
    const double bound = penetration_bound(scene_, slot, segment, facet, query);
    if (geometry::separated_by_axis(corners, bound)) return count(geometry::Stage::filter, 1);
    Waiting& waiting = waiting_[facet.triangle ? 1 : 0];
    waiting.pairs[waiting.batch.size()] = {slot, segment};
    waiting.batch.add(corners, bound);
    if (waiting.batch.full()) flush(waiting);
  }

  void flush(Waiting& waiting) {
    const geometry::PairBatch& batch = waiting.batch;
    waiting.batch.decide();
    count(geometry::Stage::filter, static_cast<std::size_t>(std::popcount(batch.apart())));
    for (std::uint64_t rest = batch.closer() | batch.open(); rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      const auto [slot, segment] = waiting.pairs[i];
      if (batch.located(i)) {
        count(geometry::Stage::filter, 1);
        keep({slot, segment, std::sqrt(batch.squared_distance(i)), true}, true);
      } else if ((batch.closer() >> i & 1) != 0 && !scene_.settings.square_edges) {
        count(geometry::Stage::filter, 1);
        keep_closer(slot, segment, batch.s(i), batch.t(i));
      } else {
        decide_alone(slot, segment);
      }
    }
    waiting.batch.clear();
  }

  void decide_alone(SlotIndex slot, SegmentIndex segment) {
    const PairResult pair = decide_pair(scene_, slot, segment);
    count(pair.stage, 1);
    if (pair.penetrates || scene_.oriented(segment))
      keep({slot, segment, pair.distance, pair.in_band}, pair.penetrates);
  }

  /// A node that penetrates a two-sided segment; near its point (s, t) the segment is nearest to the node.
  void keep_closer(SlotIndex slot, SegmentIndex segment, double s, double t) {
    if (!allowed_(slot, segment, true)) return;
    if (proven_farther(scene_.facet(segment), scene_.position(slot), s, t, nearest_.limit(slot))) return;
    const PairResult pair = measure_pair(scene_, slot, segment);
    keep_allowed({slot, segment, pair.distance, pair.in_band}, true);
  }

  void keep(const Hit& hit, bool penetrates) {
    if (allowed_(hit.slot, hit.segment, penetrates)) keep_allowed(hit, penetrates);
  }

  void keep_allowed(const Hit& hit, bool penetrates) {
    if (penetrates && !nearest_.add(hit)) return;
    (penetrates ? hits_ : measured_).push_back(hit);
    if (hits_.size() + measured_.size() < full_) return;
    std::erase_if(hits_, [&](const Hit& kept) { return !nearest_.may_count(kept); });
    if (hits_.size() + measured_.size() > full_ / 2) drop_farther(scene_, hits_, measured_);
    full_ = std::max(full_, 2 * (hits_.size() + measured_.size()));
  }

  const PairScene& scene_;
  const PairFilter& allowed_;
  NearestHits& nearest_;
  std::array<Waiting, 2> waiting_{Waiting{geometry::PairBatch(false)}, Waiting{geometry::PairBatch(true)}};
  std::vector<Hit> hits_, measured_;
  std::size_t full_ = std::size_t{1} << 18;  ///< pairs held before those that cannot count are dropped
  std::array<std::uint64_t, 4> stages_{};
};

/// The hit of every tracked node that counts.
std::vector<Hit> chosen_hits(const PairScene& scene, std::vector<Hit> all, std::vector<Hit> measured) {
  // Hits in front of every facet need no comparison with others.
  if (std::none_of(all.begin(), all.end(), [](const Hit& hit) { return std::signbit(hit.distance); })) measured.clear();
  const std::size_t slots = scene.nodes.size();
  const BySlot others(measured, slots);
  BySlot hits(all, slots);
  all = {};
  // The chosen hit replaces the first one of its slot.
  constexpr std::size_t grain = 8192;
  parallel_for(slots, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      if (hits.of(slot).empty()) continue;
      Hit& first = hits.hits[hits.start[slot]];
      if (const auto hit = choose_hit(scene, hits.of(slot), others.of(slot)))
        first = *hit;
      else
        first.segment = none<SegmentIndex>;
    }
  });
  std::size_t chosen = 0;
  for (std::size_t slot = 0; slot < slots; ++slot)
    if (!hits.of(slot).empty() && hits.of(slot)[0].segment != none<SegmentIndex>)
      hits.hits[chosen++] = hits.of(slot)[0];
  hits.hits.resize(chosen);
  return std::move(hits.hits);
}

}  // namespace

void for_each_candidate(const PairScene& scene, const CandidateSearch& search,
                        const std::function<double(SegmentIndex)>& reach, SweepCounters& counters,
                        const std::function<void(SegmentIndex, std::span<const SlotIndex>)>& visit) {
  const Segments& s = scene.segments;
  ++counters.searches;
  std::vector<Bounds> boxes(s.size());
  const auto core = [&](std::size_t i) {
    Bounds box;
    for (const NodeIndex n : s.nodes[i]) box.add(scene.x[n.value]);
    return box;
  };
  constexpr std::size_t grain = 4096;
  parallel_for(s.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto segment = to_index<SegmentIndex>(i);
      if (scene.passive(segment)) continue;
      boxes[i] = grown(core(i), reach(segment) + (s.offset.empty() ? 0 : std::abs(s.offset[i])));
    }
  });
  // Cull by the boxes of the two sides before anything is sorted.
  Bounds all_boxes, all_points;
  for (const Bounds& b : boxes) {
    all_boxes.low = all_boxes.low.cwiseMin(b.low);
    all_boxes.high = all_boxes.high.cwiseMax(b.high);
  }
  std::vector<Vector> points;
  std::vector<SlotIndex> slots;
  points.reserve(scene.nodes.size());
  slots.reserve(scene.nodes.size());
  for (const SlotIndex slot : positions<SlotIndex>(scene.nodes.size())) {
    const Vector p = scene.position(slot);
    if (!(p.array() >= all_boxes.low.array()).all() || !(p.array() <= all_boxes.high.array()).all()) continue;
    points.push_back(p);
    slots.push_back(slot);
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
  if (points.empty()) {
    ++counters.searches_culled;
    return;
  }
  std::atomic<std::uint64_t> pairs{0};
  const CandidateSink sink = [&](std::uint32_t box, std::span<const std::uint32_t> inside) {
    static thread_local std::vector<SlotIndex> local;
    local.clear();
    const auto& corners = s.nodes[box];
    for (const std::uint32_t p : inside)
      if (!is_corner(corners, scene.nodes.node[slots[p].value])) local.push_back(slots[p]);
    pairs.fetch_add(local.size(), std::memory_order_relaxed);
    if (!local.empty()) visit(SegmentIndex{box}, local);
  };
  if (!search.exhaustive() && crowded(points, boxes)) {
    counters.crowded_nodes += points.size();
    std::vector<Bounds> cores(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (!boxes[i].empty()) cores[i] = core(i);
    run_nearest(points, boxes, cores, sink);
  } else {
    search.run(points, boxes, sink);
  }
  counters.candidate_pairs += pairs;
}

std::vector<Hit> closest_segments(const PairScene& scene, const CandidateSearch& search, const PairFilter& pair_allowed,
                                  SweepCounters& counters, geometry::DecisionCounters& decisions) {
  double largest_half = 0;
  for (const double half : scene.nodes.half) largest_half = std::max(largest_half, half);
  NearestHits nearest(scene);
  std::vector<Hit> all, measured;
  {
    // Each thread has its own tally: shared counters would cost more than the decisions.
    tbb::enumerable_thread_specific<PairSweep> sweeps([&] { return PairSweep(scene, pair_allowed, nearest); });
    for_each_candidate(
        scene, search, [&](SegmentIndex s) { return scene.reach(s, largest_half); }, counters,
        [&](SegmentIndex segment, std::span<const SlotIndex> slots) { sweeps.local().visit(segment, slots); });
    for (PairSweep& sweep : sweeps) sweep.finish();
    for (PairSweep& sweep : sweeps) {
      sweep.move_hits(all, measured);
      using geometry::Stage;
      for (const Stage stage : {Stage::filter, Stage::interval, Stage::exact, Stage::triangulated})
        geometry::count(decisions, stage, sweep.decided_by(stage));
    }
  }
  drop_outside(scene, search, all);
  add_nearer_segments(scene, pair_allowed, all, measured);
  return chosen_hits(scene, std::move(all), std::move(measured));
}

}  // namespace gapcheck::contact
