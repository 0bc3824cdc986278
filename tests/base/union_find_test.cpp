#include "base/union_find.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace gapcheck::union_find_test {
namespace {

/// The naive twin: the name of each number's set, changed one by one.
class NamedSets {
 public:
  explicit NamedSets(std::uint32_t size) {
    for (std::uint32_t n = 0; n < size; ++n) name_.push_back(n);
  }
  [[nodiscard]] std::uint32_t name(std::uint32_t n) const { return name_[n]; }
  void unite(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t from = std::max(name_[a], name_[b]), to = std::min(name_[a], name_[b]);
    std::replace(name_.begin(), name_.end(), from, to);
  }

 private:
  std::vector<std::uint32_t> name_;
};

TEST(UnionFind, EachIsAloneAtFirst) {
  UnionFind sets(3);
  EXPECT_EQ(sets.size(), 3u);
  for (std::uint32_t n = 0; n < 3; ++n) EXPECT_EQ(sets.root(n), n);
}

TEST(UnionFind, TheSmallestStandsForItsSet) {
  std::mt19937 random(7);
  for (const std::uint32_t size : {1U, 2U, 10U, 300U}) {
    UnionFind sets(size);
    NamedSets twin(size);
    for (std::uint32_t step = 0; step < 2 * size; ++step) {
      const auto a = static_cast<std::uint32_t>(random() % size), b = static_cast<std::uint32_t>(random() % size);
      sets.unite(a, b);
      twin.unite(a, b);
      for (std::uint32_t n = 0; n < size; n += 1 + step % 7) ASSERT_EQ(sets.root(n), twin.name(n)) << size << ' ' << n;
    }
  }
}

TEST(UnionFind, WholeSetsAreTakenApart) {
  UnionFind sets(6);
  sets.unite(0, 3);
  sets.unite(5, 3);
  sets.unite(1, 2);
  for (const std::uint32_t n : {0U, 3U, 5U}) sets.separate(n);
  sets.unite(5, 3);
  EXPECT_EQ(sets.root(0), 0u);
  EXPECT_EQ(sets.root(5), 3u);
  EXPECT_EQ(sets.root(2), 1u);
}

}  // namespace
}  // namespace gapcheck::union_find_test
