#include "geometry/batch/pair_batch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "../families.hpp"
#include "geometry/decide.hpp"

namespace gapcheck::geometry::test::pair_batch_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Bounded {
  Pair pair;
  double bound = 0;
};

/// What a batch says of one pair, bit by bit.
struct Answer {
  Verdict verdict = Verdict::open;
  bool located = false;
  std::array<std::uint64_t, 3> numbers{};
  bool operator==(const Answer&) const = default;
};

Answer answer(const PairBatch& batch, std::size_t i) {
  return {batch.verdict(i),
          batch.located(i),
          {std::bit_cast<std::uint64_t>(batch.s(i)), std::bit_cast<std::uint64_t>(batch.t(i)),
           std::bit_cast<std::uint64_t>(batch.squared_distance(i))}};
}

std::vector<Answer> decide_in_batches(const std::vector<Bounded>& pairs, bool triangles, BatchWidth width) {
  PairBatch batch(triangles);
  std::vector<Answer> out;
  const auto flush = [&] {
    batch.decide(width);
    EXPECT_EQ(batch.closer() & batch.apart(), 0u);
    for (std::size_t i = 0; i < batch.size(); ++i) out.push_back(answer(batch, i));
    batch.clear();
  };
  for (const Bounded& each : pairs) {
    batch.add(seen_from(each.pair.facet, each.pair.query), each.bound);
    if (batch.full()) flush();
  }
  flush();
  return out;
}

/// Pairs of one kind with bounds from clear to the last bit around their distances.
std::vector<Bounded> bounded_pairs(Family family, bool triangles, std::size_t count) {
  Maker maker(61);
  std::vector<Bounded> out;
  for (std::size_t made = 0; out.size() < count && made < 20 * count; ++made) {
    const Pair pair = maker.make(family);
    if (pair.facet.triangle != triangles) continue;
    const double d = std::sqrt(closest_point(pair.facet, pair.query).squared_distance);
    for (const double bound : {0.5 * d, d * (1 - 1e-6), d * (1 - 1e-9), d * (1 - 1e-12), std::nextafter(d, 0.0), d,
                               std::nextafter(d, infinity), d * (1 + 1e-12), d * (1 + 1e-9), d * (1 + 1e-6), 2 * d})
      out.push_back({pair, bound});
  }
  // Warped and skew facets are quads.
  const bool quads = family == Family::warped || family == Family::skew;
  EXPECT_EQ(out.size() < count, triangles && quads) << name(family);
  return out;
}

class BatchFamilies : public testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Geometry, BatchFamilies, testing::ValuesIn(all_families),
                         [](const auto& test) { return std::string(name(test.param)); });

TEST_P(BatchFamilies, EveryVerdictAgreesWithExactNumbers) {
  for (const bool triangles : {false, true}) {
    const std::vector<Bounded> pairs = bounded_pairs(GetParam(), triangles, 11000);
    const std::vector<Answer> answers = decide_in_batches(pairs, triangles, batch_widths().back());
    ASSERT_EQ(answers.size(), pairs.size());
    std::size_t decided = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [pair, bound] = pairs[i];
      if (answers[i].verdict == Verdict::open) continue;
      ++decided;
      ASSERT_EQ(answers[i].verdict == Verdict::closer, decide(pair.facet, pair.query, bound, Mode::exact).closer)
          << describe(pair, bound);
    }
    EXPECT_GE(decided, pairs.size() / 4);
  }
}

TEST_P(BatchFamilies, EveryWidthGivesTheSameBits) {
  for (const bool triangles : {false, true}) {
    const std::vector<Bounded> pairs = bounded_pairs(GetParam(), triangles, 5500);
    const std::vector<Answer> narrow = decide_in_batches(pairs, triangles, BatchWidth::two);
    for (const BatchWidth width : batch_widths()) {
      const std::vector<Answer> wide = decide_in_batches(pairs, triangles, width);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        ASSERT_EQ(wide[i], narrow[i]) << static_cast<int>(width) << " " << describe(pairs[i].pair, pairs[i].bound);
    }
  }
}

TEST_P(BatchFamilies, NeighboursInTheBatchDoNotMatter) {
  for (const bool triangles : {false, true}) {
    const std::vector<Bounded> pairs = bounded_pairs(GetParam(), triangles, 600);
    for (const BatchWidth width : batch_widths()) {
      const std::vector<Answer> together = decide_in_batches(pairs, triangles, width);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        ASSERT_EQ(decide_in_batches({pairs[i]}, triangles, width).front(), together[i])
            << describe(pairs[i].pair, pairs[i].bound);
    }
  }
}

TEST_P(BatchFamilies, LocatedPointsAreTheClosest) {
  for (const bool triangles : {false, true}) {
    const std::vector<Bounded> pairs = bounded_pairs(GetParam(), triangles, 11000);
    const std::vector<Answer> answers = decide_in_batches(pairs, triangles, batch_widths().back());
    std::size_t located = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!answers[i].located) continue;
      ++located;
      ASSERT_EQ(answers[i].verdict, Verdict::closer);
      const auto& [pair, bound] = pairs[i];
      const ClosestPoint closest = closest_point(pair.facet, pair.query);
      const double size = size_of(seen_from(pair.facet, pair.query));
      const double square = std::bit_cast<double>(answers[i].numbers[2]);
      EXPECT_EQ(closest.feature, Feature::face) << describe(pair, bound);
      EXPECT_NEAR(square, closest.squared_distance, 1e-12 * square + 1e-15 * size * size) << describe(pair, bound);
      const double s = std::bit_cast<double>(answers[i].numbers[0]), t = std::bit_cast<double>(answers[i].numbers[1]);
      const Vector point = blend(pair.facet.x, quad_weights(s, t));
      // The coordinates of the point are rounded at the size of the model.
      const double rounding = size * size + size * pair.query.lpNorm<Eigen::Infinity>();
      EXPECT_NEAR((pair.query - point).squaredNorm(), square, 1e-14 * rounding) << describe(pair, bound);
    }
    if (GetParam() == Family::flat || GetParam() == Family::lattice) {
      EXPECT_GT(located, 40u) << triangles;
    }
  }
}

TEST(PairBatch, FlatFacesAreDecidedAndLocated) {
  Maker maker(67);
  for (const bool triangles : {false, true}) {
    PairBatch batch(triangles);
    while (!batch.full()) {
      const double z = maker.uniform(0.1, 0.9);
      Corners e{Vector(-1, -1, z), Vector(2, -1, z), Vector(2, 2, z), Vector(-1, 2, z)};
      if (triangles) e[3] = e[2] = Vector(-1, 2, z);
      batch.add(e, batch.size() % 2 == 0 ? 1.0 : 0.05);
    }
    batch.decide();
    for (std::size_t i = 0; i < batch.size(); ++i) {
      EXPECT_EQ(batch.verdict(i), i % 2 == 0 ? Verdict::closer : Verdict::apart);
      EXPECT_EQ(batch.located(i), i % 2 == 0);
    }
    EXPECT_EQ(batch.open(), 0u);
  }
}

TEST(PairBatch, WhatIsNoNumberStaysOpen) {
  const Corners good{Vector(0, 0, 1), Vector(1, 0, 1), Vector(1, 1, 1), Vector(0, 1, 1)};
  for (const bool triangles : {false, true}) {
    for (const double bad : {nan, infinity, -infinity, 1e200}) {
      PairBatch batch(triangles);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
          Corners e = good;
          e[corner][axis] = bad;
          batch.add(e, 2);
        }
      }
      for (const double bound : {bad, -1.0, 0.0, nan}) batch.add(good, bound == 1e200 ? infinity : bound);
      for (const double size : {1e-200, 1e-40, 1e40}) {
        Corners e = good;
        for (Vector& corner : e) corner *= size;
        batch.add(e, 2 * size);
      }
      for (const BatchWidth width : batch_widths()) {
        batch.decide(width);
        EXPECT_EQ(batch.open(), filled(batch.size())) << bad;
      }
    }
  }
}

TEST(PairBatch, AnEmptyBatchIsNothing) {
  PairBatch batch(false);
  batch.decide();
  EXPECT_EQ(batch.closer() | batch.apart() | batch.open(), 0u);
}

}  // namespace
}  // namespace gapcheck::geometry::test::pair_batch_test
