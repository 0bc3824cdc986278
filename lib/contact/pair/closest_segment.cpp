#include "contact/pair/closest_segment.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <mutex>
#include <span>
#include <utility>

#include "base/large_array.hpp"
#include "base/parallel.hpp"
#include "contact/pair/hidden_faces.hpp"
#include "contact/pair/nearer_segments.hpp"
#include "contact/pair/nearest_hits.hpp"
#include "contact/pair/side_filter.hpp"
#include "contact/search/nearest_boxes.hpp"
#include "geometry/batch/pair_batch.hpp"
#include "geometry/view.hpp"

namespace gapcheck::contact {
namespace {

/// Hits by slot: those of slot i are in [start[i], start[i + 1]).
struct BySlot {
  std::vector<std::uint32_t> start;
  std::vector<Hit> hits;
  BySlot(const std::vector<Hit>& all, std::size_t slots) : start(slots + 2, 0), hits(large_array<Hit>(all.size())) {
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

/// Decides pairs and keeps the hits that count; one for each thread. Two-sided segments go through batches; of
/// oriented ones, SideFilter leaves few pairs.
class PairSweep {
 public:
  PairSweep(const PairScene& scene, const PairFilter& pair_allowed, NearestHits& nearest)
      : scene_(scene), allowed_(pair_allowed), nearest_(nearest) {}

  void visit(SegmentIndex segment, std::span<const SlotIndex> slots) {
    if (scene_.mode == geometry::Mode::exact || scene_.line(segment)) {
      for (const SlotIndex slot : slots) decide_alone(slot, segment);
      return;
    }
    const geometry::Facet facet = scene_.facet(segment);
    if (scene_.oriented(segment)) return visit_oriented(segment, facet, slots);
    for (const SlotIndex slot : slots) add(slot, segment, facet);
  }
  /// What still waits in the batches.
  void finish() {
    for (Waiting& waiting : waiting_) flush(waiting);
    settle_late();
  }
  /// Once all sweeps have finished: moves the hits that may count to a list that the sweeps share.
  void move_hits(std::vector<Hit>& hits) {
    std::erase_if(hits_, [&](const Hit& hit) { return !nearest_.may_count(hit); });
    if (hits.empty())
      hits = std::move(hits_);
    else
      hits.insert(hits.end(), hits_.begin(), hits_.end());
    hits_ = {};
    late_ = {};
  }
  [[nodiscard]] std::uint64_t decided_by(geometry::Stage stage) const {
    return stages_[static_cast<std::size_t>(stage)];
  }

 private:
  struct Pair {
    SlotIndex slot;
    SegmentIndex segment;
  };
  /// A node that penetrates a two-sided segment, which is nearest to the node somewhere near its point (s, t).
  struct Late {
    SlotIndex slot;
    SegmentIndex segment;
    float s, t;
  };
  static constexpr std::size_t most_late = std::size_t{1} << 18;
  struct Waiting {
    geometry::PairBatch batch;
    std::array<Pair, geometry::PairBatch::capacity> pairs{};
  };

  void count(geometry::Stage stage, std::size_t times) { stages_[static_cast<std::size_t>(stage)] += times; }

  void visit_oriented(SegmentIndex segment, const geometry::Facet& facet, std::span<const SlotIndex> slots) {
    const SideFilter filter(scene_, segment, facet);
    for (const SlotIndex slot : slots) {
      const Vector query = scene_.position(slot);
      if (filter.apart(query, penetration_bound(scene_, slot, segment, facet, query)))
        count(geometry::Stage::filter, 1);
      else
        decide_alone(slot, segment);
    }
  }

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
        keep({slot, segment, std::sqrt(batch.squared_distance(i)), true});
      } else if ((batch.closer() >> i & 1) != 0 && !scene_.settings.square_edges) {
        count(geometry::Stage::filter, 1);
        late_.push_back({slot, segment, static_cast<float>(batch.s(i)), static_cast<float>(batch.t(i))});
        if (late_.size() == most_late) settle_late();
      } else {
        decide_alone(slot, segment);
      }
    }
    waiting.batch.clear();
  }

  void decide_alone(SlotIndex slot, SegmentIndex segment) {
    const PairResult pair = decide_pair(scene_, slot, segment);
    count(pair.stage, 1);
    if (pair.penetrates) keep({slot, segment, pair.distance, pair.in_band});
  }

  /// Measures the pairs that were put off: by now, most of their nodes have a nearer segment.
  void settle_late() {
    for (const auto& [slot, segment, s, t] : late_) {
      if (allowed_.tallies && !allowed_(slot, segment, true)) continue;
      if (proven_farther(scene_.facet(segment), scene_.position(slot), s, t, nearest_.limit(slot))) continue;
      if (!allowed_.tallies && !allowed_(slot, segment, true)) continue;
      const PairResult pair = measure_pair(scene_, slot, segment);
      keep_allowed({slot, segment, pair.distance, pair.in_band});
    }
    late_.clear();
  }

  void keep(const Hit& hit) {
    if (!allowed_.tallies && !nearest_.may_count(hit)) return;
    if (allowed_(hit.slot, hit.segment, true)) keep_allowed(hit);
  }

  void keep_allowed(const Hit& hit) {
    if (!hit.in_band && allowed_.only_in_band && allowed_.only_in_band(hit.slot, hit.segment)) return;
    if (!nearest_.add(hit)) return;
    hits_.push_back(hit);
    if (hits_.size() < full_) return;
    std::erase_if(hits_, [&](const Hit& kept) { return !nearest_.may_count(kept); });
    if (hits_.size() > std::max(full_ / 2, scene_.nodes.size())) drop_farther(scene_, hits_);
    full_ = std::max(full_, 2 * hits_.size());
  }

  const PairScene& scene_;
  const PairFilter& allowed_;
  NearestHits& nearest_;
  std::array<Waiting, 2> waiting_{Waiting{geometry::PairBatch(false)}, Waiting{geometry::PairBatch(true)}};
  std::vector<Late> late_;
  std::vector<Hit> hits_;
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

/// Grows a box by another one; empty ones and numbers that are not finite leave it as it is.
void join(Bounds& box, const Bounds& other) {
  box.low = box.low.cwiseMin(other.low);
  box.high = box.high.cwiseMax(other.high);
}

/// Tracked nodes and their positions, ascending by slot, and the box around them.
struct Placed {
  std::vector<Vector> points;
  std::vector<SlotIndex> slots;
  Bounds bounds;
};

/// The tracked nodes inside a closed box.
Placed nodes_inside(const PairScene& scene, const Bounds& box) {
  constexpr std::size_t block = 8192;
  const std::size_t count = scene.nodes.size(), blocks = (count + block - 1) / block;
  const auto each_inside = [&](std::size_t b, const auto& visit) {
    for (std::size_t i = b * block; i < std::min(count, (b + 1) * block); ++i)
      if (const Vector p = scene.position(to_index<SlotIndex>(i)); box.contains(p)) visit(to_index<SlotIndex>(i), p);
  };
  std::vector<std::size_t> first(blocks + 1, 0);
  parallel_for(blocks, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) each_inside(b, [&](SlotIndex, const Vector&) { ++first[b + 1]; });
  });
  for (std::size_t b = 0; b < blocks; ++b) first[b + 1] += first[b];
  Placed placed;
  resize_in_parallel(placed.points, first.back());
  resize_in_parallel(placed.slots, first.back());
  std::mutex mutex;
  parallel_for(blocks, 1, [&](std::size_t begin, std::size_t end) {
    Bounds here;
    for (std::size_t b = begin; b < end; ++b) {
      std::size_t to = first[b];
      each_inside(b, [&](SlotIndex slot, const Vector& p) {
        placed.points[to] = p;
        placed.slots[to++] = slot;
        here.add(p);
      });
    }
    const std::scoped_lock lock(mutex);
    join(placed.bounds, here);
  });
  return placed;
}

}  // namespace

void for_each_candidate(const PairScene& scene, const CandidateSearch& search,
                        const std::function<double(SegmentIndex)>& reach, SweepCounters& counters,
                        const std::function<void(SegmentIndex, std::span<const SlotIndex>)>& visit) {
  const Segments& s = scene.segments;
  ++counters.searches;
  std::vector<Bounds> boxes = large_array<Bounds>(s.size());
  const auto core = [&](std::size_t i) {
    Bounds box;
    for (const NodeIndex n : s.nodes[i]) box.add(scene.x[n.value]);
    return box;
  };
  constexpr std::size_t grain = 4096;
  Bounds all_boxes;
  std::mutex mutex;
  parallel_for(s.size(), grain, [&](std::size_t begin, std::size_t end) {
    Bounds here;
    for (std::size_t i = begin; i < end; ++i) {
      const auto segment = to_index<SegmentIndex>(i);
      if (scene.passive(segment)) continue;
      boxes[i] = grown(core(i), reach(segment) + (s.offset.empty() ? 0 : std::abs(s.offset[i])));
      join(here, boxes[i]);
    }
    const std::scoped_lock lock(mutex);
    join(all_boxes, here);
  });
  // Cull by the boxes of the two sides before anything is sorted.
  const auto [points, slots, all_points] = nodes_inside(scene, all_boxes);
  counters.points_culled += scene.nodes.size() - points.size();
  std::atomic<std::uint64_t> culled{0};
  parallel_for(boxes.size(), grain,
               [&, &points = points, &all_points = all_points](std::size_t begin, std::size_t end) {
                 std::uint64_t here = 0;
                 for (std::size_t i = begin; i < end; ++i) {
                   if (!points.empty() && boxes[i].meets(all_points)) continue;
                   boxes[i] = Bounds{};
                   ++here;
                 }
                 culled += here;
               });
  counters.segments_culled += culled;
  if (points.empty()) {
    ++counters.searches_culled;
    return;
  }
  std::atomic<std::uint64_t> pairs{0};
  const CandidateSink sink = [&, &slots = slots](std::uint32_t box, std::span<const std::uint32_t> inside) {
    static thread_local std::vector<SlotIndex> local;
    local.clear();
    const auto& corners = s.nodes[box];
    for (const std::uint32_t p : inside)
      if (!is_corner(corners, scene.nodes.node[slots[p].value])) local.push_back(slots[p]);
    pairs.fetch_add(local.size(), std::memory_order_relaxed);
    if (!local.empty()) visit(SegmentIndex{box}, local);
  };
  if (!search.exhaustive() && crowded(points, boxes, scene.most_pairs)) {
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
  std::vector<Hit> all;
  {
    // Each thread has its own tally: shared counters would cost more than the decisions.
    tbb::enumerable_thread_specific<PairSweep> sweeps([&] { return PairSweep(scene, pair_allowed, nearest); });
    for_each_candidate(
        scene, search, [&](SegmentIndex s) { return scene.reach(s, largest_half); }, counters,
        [&](SegmentIndex segment, std::span<const SlotIndex> slots) { sweeps.local().visit(segment, slots); });
    std::vector<PairSweep*> list;
    for (PairSweep& sweep : sweeps) list.push_back(&sweep);
    parallel_for(list.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) list[i]->finish();
    });
    for (PairSweep& sweep : sweeps) {
      sweep.move_hits(all);
      using geometry::Stage;
      for (const Stage stage : {Stage::filter, Stage::interval, Stage::exact, Stage::triangulated})
        geometry::count(decisions, stage, sweep.decided_by(stage));
    }
  }
  drop_outside(scene, search, all);
  std::vector<Hit> measured = nearer_segments(scene, pair_allowed, all);
  return chosen_hits(scene, std::move(all), std::move(measured));
}

}  // namespace gapcheck::contact
