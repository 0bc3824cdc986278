#include "audit/shared/worst_by_key.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace gapcheck::audit::worst_by_key_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Long runs of one key, then keys that alternate; some things do not count, many weigh the same.
Weighed weigh(std::size_t i) {
  const double weight = i % 7 == 0 ? 0 : i % 11 == 0 ? nan : static_cast<double>(i % 5);
  return {i < 50000 ? i / 20000 : i % 3, weight};
}

TEST(WorstByKey, AgreesWithAPlainLoop) {
  constexpr std::size_t count = 100000;
  std::map<std::uint64_t, Worst> expected;
  for (std::size_t i = 0; i < count; ++i) {
    const Weighed w = weigh(i);
    if (!(w.weight > 0)) continue;
    Worst& worst = expected[w.key];
    if (w.weight > worst.weight) worst.weight = w.weight, worst.item = static_cast<std::uint32_t>(i);
    ++worst.count;
  }
  for (const std::size_t jobs : {1, 2, 7}) {
    const JobLimit limit(jobs);
    const auto worst = worst_by_key(count, weigh);
    ASSERT_EQ(worst.size(), expected.size());
    auto e = expected.begin();
    for (const Worst& w : worst) {
      EXPECT_EQ(w.key, e->first);
      EXPECT_EQ(w.count, e->second.count);
      EXPECT_EQ(w.weight, e->second.weight);
      EXPECT_EQ(w.item, e->second.item);
      ++e;
    }
  }
}

TEST(WorstByKey, NothingThatWeighsNothing) {
  EXPECT_TRUE(worst_by_key(0, weigh).empty());
  EXPECT_TRUE(worst_by_key(10, [](std::size_t) { return Weighed{1, nan}; }).empty());
}

}  // namespace
}  // namespace gapcheck::audit::worst_by_key_test
