#include "geometry/decide.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "families.hpp"
#include "reference.hpp"

namespace gapcheck::geometry::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double up(double x, int steps = 1) {
  for (; steps > 0; --steps) x = std::nextafter(x, infinity);
  for (; steps < 0; ++steps) x = std::nextafter(x, 0.0);
  return x;
}

/// Bounds from clear to the last bit around a distance.
std::vector<double> bounds_around(double d) {
  return {0.5 * d,       d * (1 - 1e-6), d * (1 - 1e-9), d * (1 - 1e-12), up(d, -2), up(d, -1), d, up(d, 1),
          up(d, 2),      d * (1 + 1e-12), d * (1 + 1e-9), d * (1 + 1e-6),  2 * d};
}

class Families : public testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Geometry, Families, testing::ValuesIn(all_families),
                         [](const auto& test) { return std::string(name(test.param)); });

TEST_P(Families, EveryDecisionAgreesWithTheReference) {
  Maker maker(17);
  std::array<std::size_t, 4> stages{};
  std::size_t triangulated = 0, compared = 0;
  for (int i = 0; i < 12000; ++i) {
    const Pair pair = maker.make(GetParam());
    const mpf_class exact = squared_distance(pair.facet, pair.query);
    const double distance = mpf_class(sqrt(exact)).get_d();
    if (distance < 1e-60) continue;
    for (double bound : bounds_around(distance)) {
      const mpf_class square = mpf_class(bound, 600) * bound;
      const bool expected = square - exact > square * 1e-22;  // less is a tie that the reference only reached from above
      const Decision fast = decide(pair.facet, pair.query, bound, Mode::filtered);
      const Decision slow = decide(pair.facet, pair.query, bound, Mode::exact);
      ++stages[static_cast<std::size_t>(fast.stage)];
      ++compared;
      ASSERT_EQ(fast.closer, slow.closer) << describe(pair, bound);
      if (fast.stage == Stage::triangulated || slow.stage == Stage::triangulated) {
        ++triangulated;
        if(triangulated<4) std::printf("%s %.17g\n",describe(pair,bound).c_str(),distance);
        continue;
      }
      ASSERT_EQ(fast.closer, expected) << describe(pair, bound);
    }
  }
  EXPECT_GT(compared, 100000u);
  EXPECT_LT(triangulated, compared / 10000) << "warped quads are to be decided on the patch";
  std::printf("filter %zu, interval %zu, exact %zu, triangulated %zu\n", stages[0], stages[1], stages[2], triangulated);
}

}  // namespace
}  // namespace gapcheck::geometry::test
