#include "geometry/pieces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "families.hpp"
#include "geometry/decide.hpp"
#include "geometry/view.hpp"

namespace gapcheck::geometry::test::pieces_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool settled(Verdict verdict) { return verdict == Verdict::closer || verdict == Verdict::apart; }

struct Share {
  std::size_t asked = 0, settled = 0;
};

/// Every proof must be true, whatever point it starts from and however far the bound is.
Share check(Family family, int pairs, std::uint64_t seed) {
  Maker maker(seed);
  Share share;
  for (int i = 0; i < pairs; ++i) {
    const Pair pair = maker.make(family);
    const Corners e = seen_from(pair.facet, pair.query);
    const double size = size_of(e), distance = std::sqrt(closest_point(pair.facet, pair.query).squared_distance);
    if (!usable(size) || !(distance > 0)) continue;
    const Location best = locate_on_patch(e, Patch(e));
    const bool poor = i % 4 == 0;
    const double wide = distance * (1 + maker.power_of_ten(-12, 0));
    for (const double bound : {std::nextafter(distance, 0), distance, std::nextafter(distance, infinity), wide,
                               distance * distance / wide}) {
      Verdict verdict = Verdict::open;
      if (pair.facet.triangle) {
        verdict = precise::triangle_edges_verdict(pair.facet, pair.query, size, bound);
      } else {
        std::optional<precise::Place> place;
        if (poor) place = precise::Place{maker.uniform(-1, 1), maker.uniform(-1, 1)};
        if (!poor && i % 4 != 1) place = precise::Place{best.s, best.t};
        verdict = precise::quad_verdict(pair.facet, pair.query, size, bound, place);
        if (!poor) ++share.asked;
        if (!poor && settled(verdict)) ++share.settled;
      }
      if (settled(verdict)) {
        EXPECT_EQ(verdict == Verdict::closer, decide(pair.facet, pair.query, bound, Mode::exact).closer)
            << describe(pair, bound);
      }
    }
  }
  return share;
}

class Pieces : public testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Geometry, Pieces, testing::ValuesIn(all_families),
                         [](const auto& test) { return std::string(name(test.param)); });

TEST_P(Pieces, NeverProveWhatIsFalse) {
  const Share share = check(GetParam(), 1500, 641);
  EXPECT_GT(share.settled, share.asked / 2);
}

TEST(PiecesOfTies, NeverProveWhatIsFalse) {
  for (const Family family : tied_families) check(family, 1000, 643);
}

/// A saddle seen from above its middle, at its distance: with the point inside everything is settled but the tie
/// itself, which no number of pieces can tell.
TEST(PiecesOfSaddle, OnlyTheTieStaysOpen) {
  const Facet saddle{{Vector(0, 0, 1), Vector(4, 0, -1), Vector(4, 4, 1), Vector(0, 4, -1)}, false};
  const Vector query(2, 2, 0.75);
  const auto verdict = [&](double bound, const std::optional<precise::Place>& inside) {
    return precise::quad_verdict(saddle, query, 2, bound, inside);
  };
  EXPECT_EQ(verdict(std::nextafter(0.75, 1), precise::Place{1e-9, -1e-9}), Verdict::closer);
  EXPECT_EQ(verdict(std::nextafter(0.75, 0), precise::Place{1e-9, -1e-9}), Verdict::apart);
  EXPECT_EQ(verdict(0.75, precise::Place{0, 0}), Verdict::open);
  EXPECT_EQ(verdict(0.7, std::nullopt), Verdict::apart);
  EXPECT_EQ(verdict(0.8, std::nullopt), Verdict::closer);
  EXPECT_EQ(verdict(std::nextafter(0.75, 0), std::nullopt), Verdict::apart) << "it is found in an open piece";
}

/// Where the nearest point lies beyond an edge, a slope of one sign settles the inside.
TEST(PiecesOfSkewQuads, EdgesAndCornersToTheLastBit) {
  const Facet quad{{Vector(0, 0, 0), Vector(3, 0.5, 1), Vector(2.5, 3, -1), Vector(-0.5, 2, 0.5)}, false};
  const Vector edge = 0.5 * (quad.x[0] + quad.x[1]) + Vector(0.1, -2, 0.7), corner = quad.x[2] + Vector(1, 2, -1);
  for (const Vector& query : {edge, corner}) {
    const double distance = std::sqrt(closest_point(quad, query).squared_distance);
    for (const double bound : {std::nextafter(distance, 0), distance, std::nextafter(distance, infinity)}) {
      const Verdict verdict = precise::quad_verdict(quad, query, size_of(seen_from(quad, query)), bound, std::nullopt);
      EXPECT_EQ(verdict, decide(quad, query, bound, Mode::exact).closer ? Verdict::closer : Verdict::apart);
    }
  }
}

/// A corner that is nearer than the bound by 3 · 2^-106, less than the error of 106 bits: no proof may call it apart.
TEST(PiecesOfUndecidedEdges, AreLeftToExactNumbers) {
  const double x = 1 - 0x1p-53, y = 0x1p-26 * x;  // x² + y² = 1 - 3 · 2^-106 + 2^-158
  const Facet quad{{Vector(x, y, 0), Vector(3, y, 0), Vector(3, 3, 0), Vector(x, 3, 0)}, false};
  const Facet triangle{{quad.x[0], quad.x[1], quad.x[3], quad.x[3]}, true};
  const Vector query = Vector::Zero();
  EXPECT_EQ(precise::quad_verdict(quad, query, 3, 1, std::nullopt), Verdict::open);
  EXPECT_EQ(precise::triangle_edges_verdict(triangle, query, 3, 1), Verdict::open);
  for (const Facet& facet : {quad, triangle}) {
    EXPECT_TRUE(decide(facet, query, 1, Mode::filtered).closer);
    EXPECT_TRUE(decide(facet, query, 1, Mode::exact).closer);
    EXPECT_FALSE(decide(facet, query, x, Mode::filtered).closer);
  }
}

}  // namespace
}  // namespace gapcheck::geometry::test::pieces_test
