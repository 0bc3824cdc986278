#include "geometry/near_place.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gapcheck::geometry::near_place_test {
namespace {

class Scenes {
 public:
  double number(double size) { return std::uniform_real_distribution<double>(-size, size)(engine_); }
  Vector vector(double size) { return {number(size), number(size), number(size)}; }
  Facet facet(double warp, bool triangle) {
    Facet facet{{Vector(-1, -1, 0), Vector(1, -1, 0), Vector(1, 1, 0), Vector(-1, 1, 0)}, triangle};
    for (Vector& x : facet.x) x += Vector(number(0.6), number(0.6), number(warp));
    if (triangle) facet.x[3] = facet.x[2];
    return facet;
  }

 private:
  std::mt19937 engine_{11};
};

// From any place, right or wrong, on facets that are warped, thin or a point, at any distance.
TEST(NearPlace, BoundIsNeverAboveTheDistance) {
  Scenes scenes;
  std::size_t positive = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    Facet facet = scenes.facet(trial % 2 == 0 ? 0 : 0.5, trial % 3 == 0);
    if (trial % 7 == 0)
      for (Vector& x : facet.x) x.y() *= 1e-9;
    if (trial % 101 == 0) facet.x = {facet.x[0], facet.x[0], facet.x[0], facet.x[0]};
    const double far = std::pow(10, scenes.number(6));
    const Vector query = facet.x[0] + scenes.vector(far);
    const auto index = static_cast<std::uint8_t>(trial % 4);
    const NearPlace guess{true, static_cast<Feature>(trial % 3), index, scenes.number(1), scenes.number(1)};
    const ClosestPoint closest = closest_point(facet, query);
    const double distance = std::sqrt(closest.squared_distance);
    for (const NearPlace& place : {place_of(closest), guess}) {
      const double bound = distance_bound(facet, query, place);
      ASSERT_LE(bound, distance) << trial;
      positive += bound > 0;
    }
  }
  EXPECT_GT(positive, 40000U);
}

// Where the corners' hull is nearest at a corner or an edge, and over a flat facet, nothing is lost but rounding.
TEST(NearPlace, BoundIsTheDistanceWhereOneMoreCannotBeProven) {
  Scenes scenes;
  std::size_t faces = 0, edges = 0, corners = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Facet facet = scenes.facet(0, trial % 3 == 0);
    const Vector query = scenes.vector(3);
    const ClosestPoint closest = closest_point(facet, query);
    const double distance = std::sqrt(closest.squared_distance);
    EXPECT_NEAR(distance_bound(facet, query, place_of(closest)), distance, 1e-13) << trial;
    faces += closest.feature == Feature::face;
    edges += closest.feature == Feature::edge;
    corners += closest.feature == Feature::corner;
  }
  EXPECT_GT(std::min({faces, edges, corners}), 1000U);
}

// The place is that of a moment ago: along an edge and over a flat facet the query may have moved on since.
TEST(NearPlace, FollowsTheQueryAlongTheFacet) {
  const Facet facet{{Vector(0, 0, 0), Vector(4, 0, 0), Vector(4, 4, 0), Vector(0, 4, 0)}, false};
  const NearPlace face = place_of(closest_point(facet, Vector(1, 1, 0.5)));
  EXPECT_NEAR(distance_bound(facet, Vector(3, 2, 0.25), face), 0.25, 1e-13);
  const NearPlace edge = place_of(closest_point(facet, Vector(1, -3, 4)));
  EXPECT_NEAR(distance_bound(facet, Vector(3, -0.3, 0.4), edge), 0.5, 1e-13);
  const NearPlace corner = place_of(closest_point(facet, Vector(-3, -4, 0)));
  EXPECT_NEAR(distance_bound(facet, Vector(-0.3, -0.4, 0), corner), 0.5, 1e-13);
  // Once the query has left the corner's region the bound is poor, but holds.
  EXPECT_LT(distance_bound(facet, Vector(2, -1, 0), corner), 1);
}

TEST(NearPlace, NothingIsKnownAtFirst) {
  const Facet facet{{Vector(0, 0, 0), Vector(4, 0, 0), Vector(4, 4, 0), Vector(0, 4, 0)}, false};
  EXPECT_LT(distance_bound(facet, Vector(1, 1, 1), NearPlace{}), 0);
  EXPECT_LT(distance_bound(facet, facet.x[1], place_of(closest_point(facet, facet.x[1]))), 0);
}

}  // namespace
}  // namespace gapcheck::geometry::near_place_test
