#include "contact/pair/penetration_list.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <unordered_set>

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
  std::vector<SortKey> spare(keys.size());
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
  all_.resize(all_.size() + count);
  return std::span(all_).last(count);
}

void PenetrationList::sort_deepest_first() {
  // Records are large: their keys are sorted, then each record is moved once.
  std::vector<SortKey> keys(all_.size() - first_);
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = {all_[first_ + i].depth, all_[first_ + i].node, i};
  sort_keys(keys);
  for (std::size_t start = 0; start < keys.size(); ++start) {
    if (keys[start].at == start) continue;
    const Penetration first = all_[first_ + start];
    std::size_t to = start;
    for (std::size_t from = keys[to].at; from != start; from = keys[to].at) {
      all_[first_ + to] = all_[first_ + from];
      keys[to].at = to;
      to = from;
    }
    all_[first_ + to] = first;
    keys[to].at = to;
  }
}

}  // namespace gapcheck::contact
