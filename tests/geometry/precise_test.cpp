#include "geometry/precise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "families.hpp"
#include "geometry/decide.hpp"
#include "geometry/double_double.hpp"
#include "geometry/view.hpp"
#include "reference.hpp"

namespace gapcheck::geometry::test::precise_test {
namespace {

mpq_class value_of(const DoubleDouble<double>& a) { return mpq_class(a.high) + mpq_class(a.low); }

TEST(DoubleDouble, StaysWithinItsErrorBounds) {
  Maker maker(601);
  const mpq_class squared_roundoff = mpq_class(roundoff) * mpq_class(roundoff);
  const auto any = [&] {
    const double high = maker.uniform(-1, 1) * maker.power_of_ten(-20, 20);
    return two_sum(high, maker.uniform(-0.5, 0.5) * roundoff * high);
  };
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble<double> a = any();
    DoubleDouble<double> b = any();
    if (i % 4 == 0) b = {-a.high, maker.uniform(-1, 1) * a.low};  // digits cancel
    EXPECT_EQ(value_of(two_sum(a.high, b.high)), mpq_class(a.high) + mpq_class(b.high));
    EXPECT_EQ(value_of(two_product(a.high, b.high)), mpq_class(a.high) * mpq_class(b.high));
    const mpq_class x = value_of(a), y = value_of(b);
    EXPECT_LE(abs(value_of(a + b) - (x + y)), 4 * squared_roundoff * (abs(x) + abs(y)));
    EXPECT_LE(abs(value_of(a - b) - (x - y)), 4 * squared_roundoff * (abs(x) + abs(y)));
    EXPECT_LE(abs(value_of(a * b) - x * y), 9 * squared_roundoff * abs(x * y));
  }
}

precise::Differences differences(const Pair& pair) {
  const auto& x = pair.facet.x;
  return {{x[0], x[1], x[2], x[pair.facet.triangle ? 2 : 3]}, {pair.query, pair.query, pair.query, pair.query}};
}

TEST(Precise, TiesAlongAnAxis) {
  const double z = 0.7;
  const Facet facet{{Vector(0.1, 0.2, z), Vector(1.1, 0.2, z), Vector(1.1, 1.3, z), Vector(0.1, 1.3, z)}, false};
  const double bound = 0.7 - 0.25;  // without rounding
  const Pair pair{facet, Vector(0.4, 0.5, 0.25)};
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(precise::separated_by_axis(differences(pair), bound));
  EXPECT_TRUE(precise::separated_by_axis(differences(pair), std::nextafter(bound, 0)));
  EXPECT_FALSE(precise::separated_by_axis(differences(pair), std::nextafter(bound, infinity)));
  // 0.7 less 1e-20 is 0.7 as a double, but not without rounding.
  const Pair nearer{facet, Vector(0.4, 0.5, 1e-20)}, farther{facet, Vector(0.4, 0.5, -1e-20)};
  EXPECT_FALSE(precise::separated_by_axis(differences(nearer), 0.7));
  EXPECT_TRUE(precise::separated_by_axis(differences(farther), 0.7));
}

/// True proofs from good points and from poor ones, with bounds down to the last bit; and most pairs are settled.
TEST(Precise, NeverProvesWhatIsFalse) {
  Maker maker(607);
  std::size_t proofs = 0, asked = 0;
  for (int i = 0; i < 12000; ++i) {
    const Family family = i % 12 < 9 ? all_families[i % 12] : tied_families[i % 12 - 9];
    const Pair pair = maker.make(family);
    const Corners e = seen_from(pair.facet, pair.query);
    const double size = size_of(e), distance = std::sqrt(closest_point(pair.facet, pair.query).squared_distance);
    if (!usable(size) || !(distance > 0)) continue;
    const Location best = pair.facet.triangle ? locate_on_triangle(e) : locate_on_patch(e, Patch(e));
    const bool poor = i % 5 == 0;
    const double s = poor ? maker.uniform(-1, 1) : best.s, t = poor ? maker.uniform(-1, 1) : best.t;
    for (const double bound : {std::nextafter(distance, 0), distance, distance * (1 + 2 * roundoff)}) {
      const Verdict verdict = pair.facet.triangle ? precise::triangle_verdict(differences(pair), size, bound, s, t)
                                                  : precise::patch_verdict(differences(pair), size, bound, s, t);
      if (!poor) ++asked;
      if (verdict != Verdict::closer && verdict != Verdict::apart) continue;
      if (!poor) ++proofs;
      EXPECT_EQ(verdict == Verdict::closer, decide(pair.facet, pair.query, bound, Mode::exact).closer)
          << describe(pair, bound);
    }
  }
  EXPECT_GT(proofs, asked / 2);
}

}  // namespace
}  // namespace gapcheck::geometry::test::precise_test
