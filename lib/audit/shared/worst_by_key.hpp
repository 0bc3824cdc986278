#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "base/parallel.hpp"

namespace gapcheck::audit {

/// The weight of one thing, and the key with which it is counted.
struct Weighed {
  std::uint64_t key = 0;
  double weight = 0;    ///< not above 0: it does not count
  std::int64_t id = 0;  ///< of equally heavy things the smallest is taken, whatever their order
};

/// The things of one key: how many there are, and the heaviest (of equal ones that with the smallest id, then the
/// first).
struct Worst {
  std::uint64_t key = 0, count = 0;
  double weight = 0;
  std::uint32_t item = 0;
  std::int64_t id = 0;
};

/// Weighs the things 0 … count - 1 in parallel with `weigh(i)` → Weighed; one Worst per key that has any, ascending by
/// key. Quick where neighbours have the same key, and the same for any number of threads.
template <class Weigh>
[[nodiscard]] std::vector<Worst> worst_by_key(std::size_t count, const Weigh& weigh) {
  constexpr std::size_t grain = 8192;
  const auto add = [](Worst& into, const Worst& other) {
    into.count += other.count;
    const bool before = std::tie(other.id, other.item) < std::tie(into.id, into.item);
    if (other.weight > into.weight || (other.weight == into.weight && before))
      into.weight = other.weight, into.item = other.item, into.id = other.id;
  };
  tbb::enumerable_thread_specific<std::vector<Worst>> runs;
  parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Worst>& mine = runs.local();
    for (std::size_t i = begin; i < end; ++i) {
      const Weighed w = weigh(i);
      if (!(w.weight > 0)) continue;
      const Worst one{w.key, 1, w.weight, static_cast<std::uint32_t>(i), w.id};
      if (!mine.empty() && mine.back().key == w.key)
        add(mine.back(), one);
      else
        mine.push_back(one);
    }
  });
  std::vector<Worst> all, worst;
  for (const auto& mine : runs) all.insert(all.end(), mine.begin(), mine.end());
  std::sort(all.begin(), all.end(), [](const Worst& a, const Worst& b) { return a.key < b.key; });
  for (const Worst& one : all) {
    if (!worst.empty() && worst.back().key == one.key)
      add(worst.back(), one);
    else
      worst.push_back(one);
  }
  return worst;
}

}  // namespace gapcheck::audit
