#include "contact/pair/candidates.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>

#include "base/parallel.hpp"

namespace gapcheck::contact {

void CandidateTable::search(const PairScene& scene, const PairRules& rules, const CandidateSearch& search,
                            double margin, SweepCounters& counters) {
  double largest_half = 0;
  for (const double half : scene.nodes.half) largest_half = std::max(largest_half, half);
  // A pair as one number sorts fast: the slot above the segment.
  tbb::enumerable_thread_specific<std::vector<std::uint64_t>> found;
  for_each_candidate(
      scene, search, [&](SegmentIndex s) { return scene.reach(s, largest_half) + margin; }, counters,
      [&](SegmentIndex segment, std::span<const SlotIndex> slots) {
        std::vector<std::uint64_t>& mine = found.local();
        for (const SlotIndex slot : slots)
          if (rules(slot, segment) == PairRule::counts) mine.push_back(std::uint64_t{slot.value} << 32 | segment.value);
      });
  std::vector<std::uint64_t> pairs;
  for (const auto& mine : found) pairs.insert(pairs.end(), mine.begin(), mine.end());
  parallel_sort(pairs.begin(), pairs.end());
  slots_.clear();
  start_.clear();
  candidates_.clear();
  candidates_.reserve(pairs.size());
  for (const std::uint64_t pair : pairs) {
    const SlotIndex slot(static_cast<std::uint32_t>(pair >> 32));
    if (slots_.empty() || slots_.back() != slot) {
      slots_.push_back(slot);
      start_.push_back(static_cast<std::uint32_t>(candidates_.size()));
    }
    candidates_.push_back({SegmentIndex(static_cast<std::uint32_t>(pair))});
  }
  start_.push_back(static_cast<std::uint32_t>(candidates_.size()));
}

}  // namespace gapcheck::contact
