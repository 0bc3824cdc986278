#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.hpp"

namespace gapcheck {

/// Sorts by the lowest `bits` bits of key(item), an unsigned number; items with equal keys keep their order, so the
/// result is the same for any number of threads. `spare`: as long as `items`, its contents are undefined afterwards. At
/// most 2³² - 1 items. Time is linear; digits that all items share cost one pass.
template <class Item, class Key>
void radix_sort(std::span<Item> items, std::span<Item> spare, int bits, const Key& key) {
  constexpr int digit = 11;
  constexpr std::size_t radix = std::size_t{1} << digit, block = std::size_t{1} << 16;
  using Counts = std::array<std::uint32_t, radix>;
  const std::size_t blocks = (items.size() + block - 1) / block;
  std::vector<Counts> counts(blocks);
  std::span<Item> from = items, to = spare;
  for (int shift = 0; shift < bits; shift += digit) {
    const auto mask = bits - shift < digit ? (std::size_t{1} << (bits - shift)) - 1 : radix - 1;
    const auto digit_of = [&](const Item& item) { return static_cast<std::size_t>(key(item) >> shift) & mask; };
    parallel_for(blocks, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b) {
        counts[b].fill(0);
        for (const Item& item : from.subspan(b * block, std::min(block, from.size() - b * block)))
          ++counts[b][digit_of(item)];
      }
    });
    // Turns counts into the positions where each block puts its items of each digit.
    std::uint32_t place = 0;
    bool all_equal = false;
    for (std::size_t d = 0; d <= mask; ++d) {
      const std::uint32_t before = place;
      for (Counts& count : counts) {
        const std::uint32_t here = count[d];
        count[d] = place;
        place += here;
      }
      all_equal = all_equal || place - before == items.size();
    }
    if (all_equal) continue;
    parallel_for(blocks, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b)
        for (const Item& item : from.subspan(b * block, std::min(block, from.size() - b * block)))
          to[counts[b][digit_of(item)]++] = item;
    });
    std::swap(from, to);
  }
  if (from.data() != items.data()) std::copy(from.begin(), from.end(), items.begin());
}

}  // namespace gapcheck
