#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace gapcheck::parallel_test {
namespace {

TEST(ParallelFor, VisitsEveryEntryOnce) {
  for (const std::size_t jobs : {1u, 2u, 0u}) {
    const JobLimit limit(jobs);
    for (const std::size_t count : {0u, 1u, 99u, 100u, 101u, 100'000u}) {
      std::vector<int> visits(count, 0);
      parallel_for(count, 100, [&](std::size_t begin, std::size_t end) {
        ASSERT_LT(begin, end);
        ASSERT_LE(end, count);
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      for (const int visit : visits) ASSERT_EQ(visit, 1);
    }
  }
}

TEST(ParallelFor, SmallCountsAreOnePiece) {
  int pieces = 0;
  parallel_for(10, 10, [&](std::size_t, std::size_t) { ++pieces; });
  EXPECT_EQ(pieces, 1);
}

}  // namespace
}  // namespace gapcheck::parallel_test
