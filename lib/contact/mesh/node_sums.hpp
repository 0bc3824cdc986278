#pragma once
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/ids.hpp"
#include "base/parallel.hpp"

namespace gapcheck::contact {

/// Adds the values that `each(item, add)` passes to add(node, value), for all items, to sums[node]. With many items
/// every thread visits all of them and keeps to its own range of nodes: no locks, and each sum is formed in the order
/// of the items, for any number of threads. So `each` must be cheap and free of side effects.
template <class Sum, class Each>
void sum_at_nodes(std::vector<Sum>& sums, std::size_t items, const Each& each) {
  constexpr std::size_t worth_threads = 50'000, most_ranges = 16;
  const auto run = [&](std::uint64_t low, std::uint64_t high) {
    const auto add = [&](NodeIndex node, const Sum& value) {
      if (node.value >= low && node.value < high) sums[node.value] += value;
    };
    for (std::size_t i = 0; i < items; ++i) each(i, add);
  };
  if (items < worth_threads) return run(0, sums.size());
  const auto threads = static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
  const std::size_t ranges = std::min(threads, most_ranges);
  parallel_for(ranges, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) run(sums.size() * r / ranges, sums.size() * (r + 1) / ranges);
  });
}

}  // namespace gapcheck::contact
