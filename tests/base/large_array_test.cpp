#include "base/large_array.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <vector>

namespace gapcheck {
namespace {

/// Above it arrays are large.
constexpr std::size_t four_megabytes = std::size_t{4} << 20;

struct Record {
  std::int32_t a = 7;
  std::int64_t b = -1;
  char c = 'c';
  friend bool operator==(const Record&, const Record&) = default;
};

TEST(LargeArray, IsWhatAVectorOfThatSizeIs) {
  for (const std::size_t bytes :
       {std::size_t{0}, std::size_t{1}, std::size_t{4096}, four_megabytes, 3 * four_megabytes})
    for (const std::size_t more : {0, 1, 23}) {
      const std::size_t size = bytes / sizeof(Record) + more;
      EXPECT_EQ(large_array<Record>(size), std::vector<Record>(size)) << size;
    }
}

TEST(LargeArray, KeepsWhatIsThere) {
  std::vector<std::uint32_t> array;
  std::vector<std::uint32_t> expected;
  for (const std::size_t size : {std::size_t{10}, four_megabytes / 4 - 1, four_megabytes, 2 * four_megabytes + 5,
                                 four_megabytes, 3 * four_megabytes}) {
    const std::size_t before = std::min(array.size(), size);
    resize_in_parallel(array, size);
    expected.resize(size);
    ASSERT_EQ(array, expected);
    std::iota(array.begin() + static_cast<std::ptrdiff_t>(before), array.end(), 17U);
    expected = array;
  }
}

TEST(LargeArray, ReservesOnly) {
  std::vector<double> array{1, 2, 3};
  reserve_in_parallel(array, four_megabytes);
  EXPECT_EQ(array, (std::vector<double>{1, 2, 3}));
  EXPECT_GE(array.capacity(), four_megabytes);
}

TEST(LargeArray, HasNoMoreRoomThanAskedForAtFirst) {
  EXPECT_EQ(large_array<double>(four_megabytes).capacity(), four_megabytes);
}

/// Growing in small steps would otherwise take time with the square of the size.
TEST(LargeArray, MovesSeldomWhileItGrows) {
  std::vector<std::uint32_t> array;
  int moves = 0;
  for (std::size_t size = 100; size < 100'000; size += 100) {
    const std::uint32_t* const before = array.data();
    resize_in_parallel(array, size);
    moves += array.data() != before;
  }
  EXPECT_LE(moves, 20);
}

}  // namespace
}  // namespace gapcheck
