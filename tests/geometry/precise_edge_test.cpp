#include "geometry/precise_edge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "families.hpp"
#include "geometry/exact.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry::test::precise_edge_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Verdict verdict(const Vector& a, const Vector& b, const Vector& query, double bound) {
  return precise::edge_verdict(a, b, query, size_of({a - query, b - query, b - query, a - query}), bound);
}

/// All edges of all families with bounds down to the last bit; nearly all are settled.
TEST(PreciseEdge, AgreesWithExactNumbers) {
  Maker maker(631);
  std::size_t asked = 0, settled = 0;
  for (int i = 0; i < 24000; ++i) {
    const Family family = i % 12 < 9 ? all_families[i % 12] : tied_families[i % 12 - 9];
    const Pair pair = maker.make(family);
    const auto &a = pair.facet.x[0], &b = pair.facet.x[i % 5 == 0 ? 2 : 1];
    const double distance = std::sqrt(closest_point_on_line(a, b, pair.query).squared_distance);
    if (!(distance > 0) || !usable(size_of({a - pair.query, b - pair.query, b, a}))) continue;
    for (const double bound : {std::nextafter(distance, 0), distance, std::nextafter(distance, infinity)}) {
      ++asked;
      const Verdict answer = verdict(a, b, pair.query, bound);
      if (answer != Verdict::closer && answer != Verdict::apart) continue;
      ++settled;
      EXPECT_EQ(answer == Verdict::closer, exact::segment_closer(a, b, pair.query, bound)) << describe(pair, bound);
    }
  }
  EXPECT_GT(settled, asked - asked / 50);
}

/// Distances that are doubles, beside an end and beside the middle.
TEST(PreciseEdge, TiesOfWholeNumbers) {
  struct Case {
    Vector a, b, query;
    double distance;
  };
  const Case cases[] = {{{0, 0, 0}, {8, 0, 0}, {4, 3, 4}, 5},
                        {{0, 0, 0}, {8, 0, 0}, {-2, 3, 6}, 7},
                        {{0, 0, 0}, {8, 0, 0}, {0, 5, 12}, 13},
                        {{0, 0, 0}, {0, 0, 0}, {4, 4, 7}, 9},
                        {{-6, -8, 0}, {6, 8, 0}, {-4, 3, 12}, 13}};
  for (const Case& c : cases) {
    for (const double sign : {1.0, -1.0}) {
      for (const double factor : {1.0, 0x1p-70, 0x1p60}) {
        const Vector a = sign * factor * c.a, b = sign * factor * c.b, query = sign * factor * c.query;
        const double bound = factor * c.distance;
        EXPECT_EQ(verdict(a, b, query, bound), Verdict::apart) << c.distance;
        EXPECT_EQ(verdict(b, a, query, bound), Verdict::apart) << c.distance;
        EXPECT_EQ(verdict(a, b, query, std::nextafter(bound, infinity)), Verdict::closer) << c.distance;
        EXPECT_EQ(verdict(a, b, query, std::nextafter(bound, 0)), Verdict::apart) << c.distance;
      }
    }
  }
}

/// A tie of numbers with all their digits is left to exact numbers.
TEST(PreciseEdge, OtherTiesStayOpen) {
  const Vector a(0, 0, 0), b(-1, 0, 0);
  // 3x, 4x and 5x without rounding, x with 51 digits: the squares have too many digits for doubles.
  const double x = 1 + 0x1p-50;
  EXPECT_EQ(verdict(a, b, Vector(3 * x, 4 * x, 0), 5 * x), Verdict::open);
  EXPECT_FALSE(exact::segment_closer(a, b, Vector(3 * x, 4 * x, 0), 5 * x));
}

}  // namespace
}  // namespace gapcheck::geometry::test::precise_edge_test
