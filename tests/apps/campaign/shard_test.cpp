#include "campaign/shard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace gapcheck::app {
namespace {

std::uint64_t load(const std::vector<std::uint64_t>& sizes, const std::vector<std::size_t>& own) {
  return std::accumulate(own.begin(), own.end(), std::uint64_t{0},
                         [&](std::uint64_t sum, std::size_t i) { return sum + sizes[i]; });
}

TEST(Shard, EveryDeckIsInOneShareAndSharesAreEven) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::uint64_t> sizes(random() % 60);
    for (std::uint64_t& size : sizes) size = random() % 4 == 0 ? 0 : random() % 1000;
    const std::size_t count = 1 + random() % 12;
    std::vector<int> times(sizes.size());
    std::uint64_t least = std::uint64_t(-1), most = 0, largest = 1;
    for (const std::uint64_t size : sizes) largest = std::max(largest, size);
    for (std::size_t number = 1; number <= count; ++number) {
      const std::vector<std::size_t> own = share_of(sizes, {number, count});
      EXPECT_TRUE(std::is_sorted(own.begin(), own.end()));
      for (const std::size_t i : own) ++times[i];
      least = std::min(least, load(sizes, own));
      most = std::max(most, load(sizes, own));
    }
    EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int n) { return n == 1; }));
    // The largest first: the last deck of the fullest share went where least was. Decks of no size count as one byte.
    EXPECT_LE(most, least + largest + sizes.size());
  }
}

TEST(Shard, LargeDecksGoApart) {
  const std::vector<std::uint64_t> sizes{1, 50, 1, 50, 1, 1, 50};
  for (std::size_t number = 1; number <= 3; ++number) EXPECT_GE(load(sizes, share_of(sizes, {number, 3})), 50);
  EXPECT_EQ(share_of(sizes, {1, 1}).size(), sizes.size());
  EXPECT_TRUE(share_of({7}, {2, 2}).empty());
}

TEST(Shard, IsReadAsKOfN) {
  ASSERT_TRUE(read_shard("3/8"));
  EXPECT_EQ(read_shard("3/8")->number, 3);
  EXPECT_EQ(read_shard("3/8")->count, 8);
  EXPECT_TRUE(read_shard("1/1")->whole());
  for (const std::string wrong : {"", "3", "/", "3/", "/8", "0/8", "9/8", "-1/8", "3/8/2", " 3/8", "3/8 ", "a/b",
                                  "1.5/2", "1/100001", "1/99999999999999999999999"})
    EXPECT_FALSE(read_shard(wrong)) << wrong;
}

}  // namespace
}  // namespace gapcheck::app
