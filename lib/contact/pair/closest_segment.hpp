#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "contact/pair/hit.hpp"
#include "contact/search/search.hpp"

namespace gapcheck::contact {

/// What a sweep left out and how much it checked.
struct SweepCounters {
  std::uint64_t candidate_pairs = 0, points_culled = 0, segments_culled = 0;
  std::uint64_t searches = 0, searches_culled = 0;     ///< culled by the boxes of the two sides
  std::uint64_t crowded_nodes = 0, crowded_edges = 0;  ///< compared to the nearest segments or edges only
};

/// Whether a pair counts, given whether it penetrates.
struct PairFilter {
  std::function<bool(SlotIndex, SegmentIndex, bool penetrates)> counts;  ///< called from any thread
  bool tallies = false;  ///< it keeps a tally of the pairs that it is asked for, so it is asked for each of them once
  /// Pairs that count only if the node is in the segment's band; empty: none.
  std::function<bool(SlotIndex, SegmentIndex)> only_in_band = {};
  [[nodiscard]] bool operator()(SlotIndex slot, SegmentIndex segment, bool penetrates) const {
    return counts(slot, segment, penetrates);
  }
};

/// Runs the search of one contact side and decides all candidate pairs. At most one hit per tracked node (choose_hit),
/// ascending by slot. `pair_allowed` is asked only for pairs that penetrate or lie nearer to a node than a segment that
/// it is behind; and, unless it tallies them, not for those that cannot be chosen whatever it says.
[[nodiscard]] std::vector<Hit> closest_segments(const PairScene& scene, const CandidateSearch& search,
                                                const PairFilter& pair_allowed, SweepCounters& counters,
                                                geometry::DecisionCounters& decisions);

/// Calls visit(segment, slots) for all pairs whose node lies within `reach(segment)` of the segment's box;
/// concurrently. If these are too many (crowded()), only for the segments nearest to each node.
void for_each_candidate(const PairScene& scene, const CandidateSearch& search,
                        const std::function<double(SegmentIndex)>& reach, SweepCounters& counters,
                        const std::function<void(SegmentIndex, std::span<const SlotIndex>)>& visit);

}  // namespace gapcheck::contact
