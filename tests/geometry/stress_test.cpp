// Many pairs of every family against numbers without rounding. GAPCHECK_STRESS_PAIRS sets how many (30,000 each).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "families.hpp"
#include "geometry/batch/pair_batch.hpp"
#include "geometry/decide.hpp"
#include "geometry/view.hpp"
#include "whole_numbers.hpp"

namespace gapcheck::geometry::test::stress_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t block_pairs = 500;  ///< pairs from one seed; work is shared out in blocks

double up(double x) { return std::nextafter(x, infinity); }
double down(double x) { return std::nextafter(x, 0.0); }

/// Nothing if the variable does not hold a number.
std::optional<std::uint64_t> pairs_per_family() {
  const char* const text = std::getenv("GAPCHECK_STRESS_PAIRS");
  if (text == nullptr) return 30'000;
  const std::string value(text);
  std::uint64_t pairs = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), pairs);
  if (error != std::errc{} || end != value.data() + value.size() || pairs == 0) return std::nullopt;
  return pairs;
}

/// What the pairs of a block, or of a family, came to.
struct Tally {
  std::uint64_t pairs = 0, decisions = 0, against_whole_numbers = 0, halved = 0, given_up = 0, moved = 0,
                by_batches = 0, twin_gave_up = 0;
  std::array<std::uint64_t, 4> stages{};
  std::uint64_t wrong = 0;
  std::string first_wrong;

  void fault(const char* what, const Pair& pair, double bound) {
    if (wrong++ == 0) first_wrong = fmt::format("{}: {}", what, describe(pair, bound));
  }
  void add(const Tally& other) {
    pairs += other.pairs;
    decisions += other.decisions;
    against_whole_numbers += other.against_whole_numbers;
    halved += other.halved;
    given_up += other.given_up;
    moved += other.moved;
    by_batches += other.by_batches;
    twin_gave_up += other.twin_gave_up;
    for (std::size_t i = 0; i < stages.size(); ++i) stages[i] += other.stages[i];
    if (wrong == 0) first_wrong = other.first_wrong;
    wrong += other.wrong;
  }
};

/// Pairs of one family from one seed.
class Block {
 public:
  Block(Family family, std::uint64_t number)
      : family_(family), number_(number), maker_(1'000'003 * number + static_cast<std::uint64_t>(family) + 71) {}

  Tally run(std::uint64_t pairs) {
    for (std::uint64_t i = 0; i < pairs; ++i) check(maker_.make(family_), i);
    return tally_;
  }

 private:
  using Bounds = std::array<double, 3>;  ///< ascending
  using Answers = std::array<Decision, 3>;

  Bounds bounds(const Pair& pair, double distance, std::uint64_t i) {
    if (pair.distance > 0) return {down(pair.distance), pair.distance, up(pair.distance)};
    if (!(distance > 0)) return {std::numeric_limits<double>::denorm_min(), 1e-300, 1};
    if (i % 3 == 0) {
      const double share = maker_.uniform(0.01, 0.9);
      return {distance * (1 - share), distance * (1 + 0.1 * share), distance * (1 + 10 * share)};
    }
    if (i % 3 == 1) {
      const double share = maker_.power_of_ten(-16, -3);
      return {distance * (1 - share), distance, distance * (1 + share)};
    }
    return {down(distance), distance, up(distance)};
  }

  Decision decided(const Pair& pair, double bound, const ClosestPoint* hint = nullptr) {
    const Decision decision = decide(pair.facet, pair.query, bound, Mode::filtered, hint);
    ++tally_.decisions;
    ++tally_.stages[static_cast<std::size_t>(decision.stage)];
    return decision;
  }
  bool closer(const Pair& pair, double bound) { return decided(pair, bound).closer; }

  void check(const Pair& pair, std::uint64_t i) {
    ++tally_.pairs;
    const ClosestPoint closest = closest_point(pair.facet, pair.query);
    const Bounds b = bounds(pair, std::sqrt(closest.squared_distance), i);
    const auto square = whole_squared_distance(pair.facet, pair.query);
    tally_.against_whole_numbers += square ? 1 : 0;
    Answers answers;
    for (std::size_t k = 0; k < b.size(); ++k) {
      answers[k] = decided(pair, b[k], i % 2 == 0 ? &closest : nullptr);
      const bool answer = answers[k].closer;
      // Where exact numbers run out of pieces, the twin answers for the triangulation, and the proof may know better.
      const Decision twin = decide(pair.facet, pair.query, b[k], Mode::exact);
      const bool twin_gave_up = twin.stage == Stage::triangulated && answers[k].stage != Stage::triangulated;
      tally_.twin_gave_up += twin_gave_up ? 1 : 0;
      if (!twin_gave_up && twin.closer != answer) tally_.fault("slow twin", pair, b[k]);
      if (k > 0 && answers[k - 1].closer && !answer) tally_.fault("lost at a larger bound", pair, b[k]);
      if (square && less(*square, b[k]) != answer) tally_.fault("whole numbers", pair, b[k]);
      // The triangulation answers for a surface of its own.
      if (pair.distance > 0 && (pair.distance < b[k]) != answer && answers[k].stage != Stage::triangulated)
        tally_.fault("known distance", pair, b[k]);
    }
    check_batch(pair, b, answers);
    if (!square && i == number_ % block_pairs) halve(pair, b, answers);
    if (i % 8 == 0) check_guises(pair, b[1], answers[1].closer);
  }

  /// What a batch of any width proves must be so; half and twice the bounds too, where there is something to prove.
  void check_batch(const Pair& pair, const Bounds& b, const Answers& answers) {
    const std::array<double, 5> bounds{0.5 * b[0], b[0], b[1], b[2], 2 * b[2]};
    PairBatch batch(pair.facet.triangle);
    for (const double bound : bounds) batch.add(seen_from(pair.facet, pair.query), bound);
    for (const BatchWidth width : widths_) {
      batch.decide(width);
      for (std::size_t k = 0; k < bounds.size(); ++k) {
        const Verdict verdict = batch.verdict(k);
        if (verdict == Verdict::open) continue;
        ++tally_.by_batches;
        // At half the bound it may be apart, at twice the bound nearer, whatever the bound itself gives.
        const bool closer = verdict == Verdict::closer, expected = answers[std::clamp<std::size_t>(k, 1, 3) - 1].closer;
        if (closer != expected && !(k == 0 && !closer) && !(k == 4 && closer)) tally_.fault("batch", pair, bounds[k]);
      }
    }
  }

  void halve(const Pair& pair, const Bounds& b, const Answers& answers) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (b[k] == pair.distance || answers[k].stage == Stage::triangulated) continue;
      const auto expected = closer_by_halving(pair.facet, pair.query, b[k], 1500);
      ++(expected ? tally_.halved : tally_.given_up);
      if (expected && *expected != answers[k].closer) tally_.fault("halving in whole numbers", pair, b[k]);
    }
  }

  /// The same pair with its corners in another order, in another scale, at another place.
  void check_guises(const Pair& pair, double bound, bool answer) {
    const Facet turned = rotated(pair.facet, static_cast<std::size_t>(maker_.integer(0, pair.facet.triangle ? 2 : 3)));
    if (closer({turned, pair.query}, bound) != answer) tally_.fault("another corner first", pair, bound);
    if (closer({reversed(turned), pair.query}, bound) != answer) tally_.fault("reversed", pair, bound);

    const double factor = std::ldexp(1.0, maker_.integer(-60, 60));
    Pair scaled = pair;
    for (Vector& x : scaled.facet.x) x *= factor;
    scaled.query *= factor;
    if (bound * factor > 1e-290 && closer(scaled, bound * factor) != answer) tally_.fault("scaled", pair, bound);

    const double size = size_of(seen_from(pair.facet, pair.query));
    if (!usable(size)) return;
    // On a grid on which the way to the new place is without rounding.
    const double grid = std::ldexp(1.0, std::ilogb(size) - 24);
    const auto moved = [&](const Pair& from, const Vector& way) {
      Pair out = from;
      for (Vector& x : out.facet.x) x += way;
      out.query += way;
      return out;
    };
    Pair snapped = moved(pair, -pair.query);
    for (Vector& x : snapped.facet.x)
      for (double& value : x) value = grid * std::nearbyint(value / grid);
    const Vector way = grid * Vector(maker_.integer(-1 << 30, 1 << 30), maker_.integer(-1 << 30, 1 << 30), 1 << 29);
    const double distance = std::sqrt(closest_point(snapped.facet, snapped.query).squared_distance);
    if (!(distance > 0)) return;
    ++tally_.moved;
    for (const double near : {down(distance), distance, up(distance)})
      if (closer(snapped, near) != closer(moved(snapped, way), near)) tally_.fault("moved", snapped, near);
  }

  Family family_;
  std::uint64_t number_;
  Maker maker_;
  std::vector<BatchWidth> widths_ = batch_widths();
  Tally tally_;
};

class Stress : public testing::TestWithParam<Family> {};

std::vector<Family> families() {
  std::vector<Family> list;
  for (const Family family : all_families) list.push_back(family);
  for (const Family family : tied_families) list.push_back(family);
  return list;
}

INSTANTIATE_TEST_SUITE_P(Geometry, Stress, testing::ValuesIn(families()),
                         [](const auto& test) { return std::string(name(test.param)); });

TEST_P(Stress, NoDecisionIsWrong) {
  const auto pairs = pairs_per_family();
  ASSERT_TRUE(pairs.has_value()) << "GAPCHECK_STRESS_PAIRS must be a whole number above 0";
  const std::uint64_t blocks = (*pairs + block_pairs - 1) / block_pairs;
  // Some blocks at a time: memory does not grow with the number of pairs, and the sum has a fixed order.
  constexpr std::uint64_t at_a_time = 512;
  Tally all;
  for (std::uint64_t first = 0; first < blocks; first += at_a_time) {
    std::vector<Tally> tallies(std::min(at_a_time, blocks - first));
    parallel_for(tallies.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::uint64_t before = (first + i) * block_pairs;
        tallies[i] = Block(GetParam(), first + i).run(std::min(block_pairs, *pairs - before));
      }
    });
    for (const Tally& tally : tallies) all.add(tally);
  }
  std::printf(
      "%-11s %llu pairs: %llu decisions (filter %llu, pieces %llu, exact %llu, triangulated %llu), %llu pairs in whole "
      "numbers, %llu decisions by halving, %llu without the twin\n",
      std::string(name(GetParam())).c_str(), static_cast<unsigned long long>(all.pairs),
      static_cast<unsigned long long>(all.decisions), static_cast<unsigned long long>(all.stages[0]),
      static_cast<unsigned long long>(all.stages[1]), static_cast<unsigned long long>(all.stages[2]),
      static_cast<unsigned long long>(all.stages[3]), static_cast<unsigned long long>(all.against_whole_numbers),
      static_cast<unsigned long long>(all.halved), static_cast<unsigned long long>(all.twin_gave_up));
  EXPECT_EQ(all.wrong, 0u) << "the first: " << all.first_wrong;
  EXPECT_EQ(all.pairs, *pairs);
  EXPECT_GE(all.decisions, 3 * all.pairs);
  EXPECT_GT(all.by_batches, 0u);
  // Every family is compared with something other than lib/geometry.
  EXPECT_GT(all.against_whole_numbers + all.halved, 0u);
  EXPECT_LE(all.twin_gave_up, all.decisions / 10000 + 2) << "exact numbers must settle nearly all";
  EXPECT_LE(all.given_up, all.halved + 2) << "halving must settle most of what it is given";
  EXPECT_LE(all.stages[3], all.decisions / 1000) << "only folds and ties within a patch are left to the triangulation";
}

TEST(WholeNumbers, DistancesByHand) {
  const Facet square{{Vector(0, 0, 0), Vector(4, 0, 0), Vector(4, 4, 0), Vector(0, 4, 0)}, false};
  const Facet triangle{{Vector(0, 0, 0), Vector(4, 0, 0), Vector(4, 4, 0), Vector(4, 4, 0)}, true};
  struct Case {
    Facet facet;
    Vector query;
    double distance;
  };
  const std::vector<Case> cases{{square, {1, 3, 0.5}, 0.5}, {square, {7, 2, 4}, 5},
                                {square, {5, 6, 2}, 3},     {triangle, {3, 1, 3}, 3},
                                {triangle, {-3, 0, 4}, 5},  {triangle, {1, 3, 1}, std::sqrt(3)}};
  for (const Case& c : cases) {
    const auto square_distance = whole_squared_distance(c.facet, c.query);
    ASSERT_TRUE(square_distance.has_value());
    EXPECT_TRUE(less(*square_distance, up(up(c.distance))));
    EXPECT_FALSE(less(*square_distance, down(c.distance)));
    EXPECT_EQ(closer_by_halving(c.facet, c.query, 1.001 * c.distance, 1000), true);
    EXPECT_EQ(closer_by_halving(c.facet, c.query, 0.999 * c.distance, 1000), false);
  }
  EXPECT_FALSE(less(*whole_squared_distance(square, {7, 2, 4}), 5));
  EXPECT_TRUE(less(*whole_squared_distance(square, {7, 2, 4}), up(5)));
  const Facet dart{{Vector(0, 0, 0), Vector(4, 0, 0), Vector(1, 1, 0), Vector(0, 4, 0)}, false};
  EXPECT_FALSE(whole_squared_distance(dart, {1, 1, 1}).has_value());
  const Facet saddle{{Vector(0, 0, 1), Vector(4, 0, -1), Vector(4, 4, 1), Vector(0, 4, -1)}, false};
  EXPECT_FALSE(whole_squared_distance(saddle, {2, 2, 1}).has_value());
  EXPECT_EQ(closer_by_halving(saddle, {2, 2, 0.75}, 0.7500001, 10000), true);
  EXPECT_EQ(closer_by_halving(saddle, {2, 2, 0.75}, 0.7499999, 10000), false);
  EXPECT_EQ(closer_by_halving(saddle, {2, 2, 0.75}, 0.75, 50), std::nullopt) << "a tie";
}

}  // namespace
}  // namespace gapcheck::geometry::test::stress_test
