#include "contact/pair/penetration_list.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "base/large_array.hpp"
#include "base/parallel.hpp"
#include "base/prefetch.hpp"
#include "base/radix_sort.hpp"

namespace gapcheck::contact {
namespace {

struct SortKey {
  double depth;
  std::int64_t node;
  std::size_t at;  ///< before sorting
};

/// Deepest first, then ascending by node; equal ones keep their order.
void sort_keys(std::vector<SortKey>& keys) {
  constexpr std::size_t worth_digits = 4096;
  if (keys.size() < worth_digits) {
    std::sort(keys.begin(), keys.end(), [](const SortKey& l, const SortKey& r) {
      if (l.depth != r.depth) return l.depth > r.depth;
      return l.node != r.node ? l.node < r.node : l.at < r.at;
    });
    return;
  }
  std::vector<SortKey> spare = large_array<SortKey>(keys.size());
  const auto by_node = [](const SortKey& l, const SortKey& r) { return l.node < r.node; };
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  if (!std::is_sorted(keys.begin(), keys.end(), by_node))
    radix_sort(std::span(keys), std::span(spare), 64,
               [](const SortKey& key) { return static_cast<std::uint64_t>(key.node) ^ sign; });
  radix_sort(std::span(keys), std::span(spare), 64, [](const SortKey& key) {
    // Bits rise with positive numbers and fall with negative ones; adding zero turns -0 into 0.
    const auto bits = std::bit_cast<std::uint64_t>(key.depth + 0.0);
    return (bits & sign) != 0 ? bits : ~(bits | sign);
  });
}

/// Moves record order[i] to place i, along the cycles of the permutation. `order` is the identity afterwards.
void put_in_order(std::span<Penetration> records, std::span<std::size_t> order) {
  // The records of a cycle lie anywhere in memory: they are fetched some steps before they are moved.
  constexpr int steps_ahead = 8;
  for (std::size_t start = 0; start < order.size(); ++start) {
    if (order[start] == start) continue;
    const Penetration first = records[start];
    std::size_t to = start, ahead = start;
    for (int step = 0; step < steps_ahead; ++step) ahead = order[ahead];
    for (std::size_t from = order[to]; from != start; from = order[to]) {
      prefetch(&records[ahead]);
      ahead = order[ahead];
      records[to] = records[from];
      order[to] = to;
      to = from;
    }
    records[to] = first;
    order[to] = to;
  }
}

}  // namespace

void PenetrationList::keep_one_per_node(std::vector<Hit>& hits, const TrackedNodes& nodes,
                                        const std::vector<std::int64_t>& id) {
  if (records().empty()) return;
  std::unordered_map<std::int64_t, PenetrationKind> listed;
  for (const Penetration& p : records()) listed.emplace(p.node, p.kind);
  std::unordered_set<std::int64_t> replaced;
  std::erase_if(hits, [&](const Hit& hit) {
    const auto found = listed.find(id[nodes.node[hit.slot.value].value]);
    if (found == listed.end()) return false;
    if (found->second != PenetrationKind::edge_zone || !hit.in_band) return true;
    replaced.insert(found->first);
    return false;
  });
  const auto begin = all_.begin() + static_cast<std::ptrdiff_t>(first_);
  all_.erase(std::remove_if(begin, all_.end(), [&](const Penetration& p) { return replaced.contains(p.node); }),
             all_.end());
}

std::span<Penetration> PenetrationList::add(std::size_t count) {
  resize_in_parallel(all_, all_.size() + count);
  return std::span(all_).last(count);
}

void PenetrationList::sort_deepest_first() {
  const std::span<Penetration> own = std::span(all_).subspan(first_);
  // Records are large: their keys are sorted, then each record is moved once.
  std::vector<SortKey> keys = large_array<SortKey>(own.size());
  parallel_for(own.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) keys[i] = {own[i].depth, own[i].node, i};
  });
  sort_keys(keys);
  std::vector<std::size_t> order(own.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keys[i].at;
  put_in_order(own, order);
}

}  // namespace gapcheck::contact
