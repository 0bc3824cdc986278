#include "base/pieces.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace gapcheck::pieces_test {
namespace {

// Whatever runs a list has: the pieces cover it, none begins inside a run, and none is longer than its runs require.
TEST(PiecesOfRuns, KeepRunsTogether) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 500; ++round) {
    std::vector<int> list;
    for (int run = 0; run < static_cast<int>(random() % 12); ++run) list.insert(list.end(), 1 + random() % 9, run);
    const std::size_t grain = 1 + random() % 8;
    const auto starts = pieces_of_runs(list.size(), grain, [&](std::size_t i) { return list[i] == list[i - 1]; });
    ASSERT_FALSE(starts.empty());
    EXPECT_EQ(starts.front(), 0U);
    EXPECT_EQ(starts.back(), list.size());
    for (std::size_t piece = 0; piece + 1 < starts.size(); ++piece) {
      const std::size_t begin = starts[piece], end = starts[piece + 1];
      ASSERT_LT(begin, end);
      if (end < list.size()) {
        EXPECT_NE(list[end], list[end - 1]);
        EXPECT_GE(end - begin, grain);
      }
      EXPECT_TRUE(end - begin <= grain || list[begin + grain - 1] == list[end - 1]);
    }
  }
}

}  // namespace
}  // namespace gapcheck::pieces_test
