#include "contact/pair/candidates.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

namespace gapcheck::contact {

void CandidateTable::search(const PairScene& scene, const PairRules& rules, const CandidateSearch& search,
                            double margin, SweepCounters& counters) {
  double largest_half = 0;
  for (const double half : scene.nodes.half) largest_half = std::max(largest_half, half);
  // A pair as one number sorts fast: the slot above the segment.
  tbb::enumerable_thread_specific<std::vector<std::uint64_t>> found;
  for_each_candidate(
      scene, search, [&](std::uint32_t s) { return scene.reach(s, largest_half) + margin; }, counters,
      [&](std::uint32_t segment, std::span<const std::uint32_t> slots) {
        std::vector<std::uint64_t>& mine = found.local();
        for (const std::uint32_t slot : slots)
          if (rules(slot, segment) == PairRule::counts) mine.push_back(std::uint64_t{slot} << 32 | segment);
      });
  std::vector<std::uint64_t> pairs;
  for (const auto& mine : found) pairs.insert(pairs.end(), mine.begin(), mine.end());
  tbb::parallel_sort(pairs.begin(), pairs.end());
  slots_.clear();
  start_.clear();
  candidates_.clear();
  candidates_.reserve(pairs.size());
  for (const std::uint64_t pair : pairs) {
    const auto slot = static_cast<std::uint32_t>(pair >> 32);
    if (slots_.empty() || slots_.back() != slot) {
      slots_.push_back(slot);
      start_.push_back(static_cast<std::uint32_t>(candidates_.size()));
    }
    candidates_.push_back({static_cast<std::uint32_t>(pair)});
  }
  start_.push_back(static_cast<std::uint32_t>(candidates_.size()));
}

}  // namespace gapcheck::contact
