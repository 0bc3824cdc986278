#include "geometry/follow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "families.hpp"
#include "geometry/decide.hpp"

namespace gapcheck::geometry::test::follow_test {
namespace {

/// Pairs of one family with a start near their closest point.
std::vector<Pair> fill(Maker& maker, Family family, FollowedPairs& pairs, double off) {
  std::vector<Pair> made;
  for (std::size_t i = 0; i < FollowedPairs::capacity; ++i) {
    made.push_back(maker.make(family));
    const Pair& pair = made.back();
    const ClosestPoint c = closest_point(pair.facet, pair.query);
    pairs.set(i, pair.facet, pair.query);
    pairs.s[i] = c.s + off * maker.uniform(-1, 1);
    pairs.t[i] = c.t + off * maker.uniform(-1, 1);
  }
  return made;
}

class FollowFamilies : public testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Geometry, FollowFamilies, testing::ValuesIn(all_families),
                         [](const auto& test) { return std::string(name(test.param)); });

// What has settled is the closest point, inside the facet, and what is closer is so by the exact decision.
TEST_P(FollowFamilies, AgreesWithClosestPointAndDecision) {
  Maker maker(211);
  const auto pairs = std::make_unique<FollowedPairs>();
  int settled = 0, closer = 0, all = 0;
  for (int round = 0; round < 100; ++round) {
    const std::vector<Pair> made = fill(maker, GetParam(), *pairs, 0.02);
    follow(*pairs, made.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
      ++all;
      if (!(pairs->settled[i] > 0)) continue;
      ++settled;
      const Pair& pair = made[i];
      const ClosestPoint c = closest_point(pair.facet, pair.query);
      const double size = pairs->size[i];
      EXPECT_NEAR(std::sqrt(pairs->squared_distance[i]), std::sqrt(c.squared_distance), 1e-13 * size) << describe(pair);
      EXPECT_LT(std::max(std::abs(pairs->s[i]), std::abs(pairs->t[i])), 1);
      EXPECT_LT((pair.query + pairs->offset_of(i) - c.point).norm(), 1e-6 * size + 1e-14 * pair.query.norm())
          << describe(pair);
      // Folded quads have points with two sides, and no normal along the fold.
      const double apart = std::abs(pairs->s[i] - c.s) + std::abs(pairs->t[i] - c.t);
      const bool has_normal = std::abs(pairs->turn[i]) > 1e-6 * std::abs(c.gap) * size * size;
      if (c.gap * c.gap > 1e-12 * size * size && apart < 1e-6 && has_normal) {
        EXPECT_EQ(pairs->turn[i]<0, c.gap> 0) << describe(pair);
      }
      for (const double factor : {0.5, 1 - 1e-15, 1.0, 1 + 1e-15, 1 + 1e-12, 2.0}) {
        const double bound = factor * std::sqrt(pairs->squared_distance[i]);
        if (!pairs->closer_than(i, bound)) continue;
        ++closer;
        EXPECT_TRUE(decide(pair.facet, pair.query, bound, Mode::exact).closer) << describe(pair, bound);
      }
    }
  }
  if (GetParam() == Family::flat || GetParam() == Family::warped) {
    EXPECT_GT(settled, all / 20);
    EXPECT_GT(closer, settled / 2);
  }
}

// Neither the others in the batch nor the width of the processor's vectors show in a single bit.
TEST_P(FollowFamilies, SameBitsAloneAndInNarrowVectors) {
  Maker maker(223);
  const auto many = std::make_unique<FollowedPairs>(), one = std::make_unique<FollowedPairs>(),
             narrow = std::make_unique<FollowedPairs>();
  for (int round = 0; round < 10; ++round) {
    const std::vector<Pair> made = fill(maker, GetParam(), *many, 0.2);
    *narrow = *many;
    const FollowedPairs start = *many;
    follow(*many, made.size());
    follow_narrow(*narrow, made.size() - 1);
    for (std::size_t i = 0; i + 1 < made.size(); ++i) {
      one->set(0, made[i].facet, made[i].query);
      one->s[0] = start.s[i];
      one->t[0] = start.t[i];
      follow(*one, 1);
      for (const auto& [other, k] : {std::pair(one.get(), std::size_t{0}), std::pair(narrow.get(), i)}) {
        ASSERT_EQ(many->settled[i], other->settled[k]);
        if (!(many->settled[i] > 0)) continue;
        ASSERT_EQ(many->s[i], other->s[k]);
        ASSERT_EQ(many->t[i], other->t[k]);
        ASSERT_EQ(many->offset_of(i), other->offset_of(k));
        ASSERT_EQ(many->squared_distance[i], other->squared_distance[k]);
        ASSERT_EQ(many->turn[i], other->turn[k]);
      }
    }
  }
}

TEST(Follow, NumbersThatAreNoneNeverSettle) {
  const auto pairs = std::make_unique<FollowedPairs>();
  const Facet square{{Vector(-1, -1, 0), Vector(1, -1, 0), Vector(1, 1, 0), Vector(-1, 1, 0)}, false};
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    pairs->set(0, square, Vector(bad, 0, 1));
    pairs->set(1, square, Vector(0.2, 0.1, 1));
    pairs->set(2, Facet{{square.x[0], square.x[1], Vector(1, bad, 0), square.x[3]}, false}, Vector(0, 0, 1));
    for (std::size_t i = 0; i < 3; ++i) pairs->s[i] = pairs->t[i] = 0;
    follow(*pairs, 3);
    EXPECT_EQ(pairs->settled[0], 0);
    EXPECT_EQ(pairs->settled[1], 1);
    EXPECT_EQ(pairs->settled[2], 0);
    EXPECT_TRUE(pairs->closer_than(1, 1.1));
    EXPECT_FALSE(pairs->closer_than(0, 1.1));
  }
  pairs->set(0, square, Vector(0.2, 0.1, 1));
  pairs->s[0] = pairs->t[0] = std::numeric_limits<double>::quiet_NaN();
  follow(*pairs, 1);
  EXPECT_EQ(pairs->settled[0], 0);
}

}  // namespace
}  // namespace gapcheck::geometry::test::follow_test
