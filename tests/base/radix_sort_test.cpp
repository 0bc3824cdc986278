#include "base/radix_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace gapcheck::radix_sort_test {
namespace {

struct Item {
  std::uint64_t key;
  std::uint32_t place;
  bool operator==(const Item&) const = default;
};

TEST(RadixSort, IsAStableSortByTheBitsAskedFor) {
  std::mt19937_64 random(3);
  for (const std::size_t count : {0, 1, 2, 1000, 200000})
    for (const int bits : {1, 11, 30, 33, 63})
      for (const int spread : {0, 7, 62}) {  // bits of the keys that vary
        std::vector<Item> items(count);
        for (std::uint32_t i = 0; i < count; ++i) items[i] = {random() & ((std::uint64_t{2} << spread) - 1), i};
        std::vector<Item> expected = items, spare(count);
        const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
        std::stable_sort(expected.begin(), expected.end(),
                         [&](const Item& a, const Item& b) { return (a.key & mask) < (b.key & mask); });
        radix_sort(std::span(items), std::span(spare), bits, [](const Item& item) { return item.key; });
        EXPECT_EQ(items, expected) << count << ' ' << bits << ' ' << spread;
      }
}

}  // namespace
}  // namespace gapcheck::radix_sort_test
