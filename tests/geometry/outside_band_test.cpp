#include "geometry/outside_band.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gapcheck::geometry::outside_band_test {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vector vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  /// Of length 1.
  Vector direction() {
    Vector v = vector(1);
    while (v.norm() < 0.1) v = vector(1);
    return v.normalized();
  }

 private:
  std::mt19937 engine_;
};

Facet random_facet(Random& random, bool triangle, double warp) {
  Facet facet{{Vector(-1, -1, 0), Vector(1, -1, 0), Vector(1, 1, 0), Vector(-1, 1, 0)}, triangle};
  for (Vector& x : facet.x) x += Vector(random.number(-0.5, 0.5), random.number(-0.5, 0.5), random.number(-warp, warp));
  if (triangle) facet.x[3] = facet.x[2];
  return facet;
}

// Whatever direction point and corners take, within the bound the projection stays out of the band. Half of the trials
// steer: the corners move as a body that turns the facet's plane towards the point, which is what brings it in soonest.
TEST(OutsideBand, NothingEntersTheBand) {
  Random random(5);
  std::size_t bounded = 0, close = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const bool triangle = trial % 3 == 0;
    const Facet facet = random_facet(random, triangle, trial % 2 == 0 ? 0 : 0.1);
    const Vector query = Vector(random.number(-6, 6), random.number(-6, 6), random.number(-3, 3));
    const ClosestPoint now = closest_point(facet, query);
    if (now.in_band) continue;
    const double reach = std::sqrt(now.squared_distance) * 1.1;
    const double motion = motion_outside_band({facet, query, now.point, reach});
    if (!(motion > 0)) continue;
    ++bounded;
    const auto enters = [&](double share) {
      for (int way = 0; way < 6; ++way) {
        Facet moved = facet;
        Vector at = query;
        const Vector centre = (facet.x[0] + facet.x[1] + facet.x[2]) / 3, towards = (now.point - query).normalized();
        const Vector axis = (query - centre).cross(now.normal).normalized() * (way % 2 == 0 ? 1 : -1);
        double largest = 0;
        std::array<Vector, 4> turn;
        for (std::size_t i = 0; i < 4; ++i) {
          turn[i] = axis.cross(facet.x[i] - centre);
          largest = std::max(largest, turn[i].norm());
        }
        for (std::size_t i = 0; i < 4; ++i)
          moved.x[i] += share * motion / 2 *
                        (way < 2   ? Vector(turn[i] / largest)
                         : way < 4 ? Vector(-towards)
                                   : random.direction());
        if (triangle) moved.x[3] = moved.x[2];
        at += share * motion / 2 * (way < 5 ? towards : random.direction());
        if (closest_point(moved, at).in_band) return true;
      }
      return false;
    };
    EXPECT_FALSE(enters(0.999)) << trial;
    close += enters(20);
  }
  EXPECT_GT(bounded, 5000u);
  EXPECT_GT(close, 500u);  // a bound that is too careful by far would be of no use
}

// Flat squares: the width of the strip over 13/8 and what the plane's turn adds.
TEST(OutsideBand, FlatSquare) {
  const Facet square{{Vector(-1, -1, 0), Vector(1, -1, 0), Vector(1, 1, 0), Vector(-1, 1, 0)}, false};
  const Vector query(3, 0.2, 0);
  const double motion = motion_outside_band({square, query, Vector(1, 0.2, 0), 2});
  EXPECT_GT(motion, 0.03);
  EXPECT_LT(motion, 1.5 / 1.625);
  // In the band, above the facet, and beside a facet without area there is none.
  EXPECT_EQ(motion_outside_band({square, Vector(1.4, 0, 0), Vector(1, 0, 0), 2}), 0);
  EXPECT_EQ(motion_outside_band({square, Vector(0, 0, 1), Vector(0, 0, 0), 2}), 0);
  const Facet line{{Vector(-1, 0, 0), Vector(1, 0, 0), Vector(1, 0, 0), Vector(-1, 0, 0)}, false};
  EXPECT_EQ(motion_outside_band({line, Vector(5, 0, 0), Vector(1, 0, 0), 9}), 0);
  Facet bad = square;
  bad.x[2].x() = std::nan("");
  EXPECT_EQ(motion_outside_band({bad, query, Vector(1, 0.2, 0), 2}), 0);
}

}  // namespace
}  // namespace gapcheck::geometry::outside_band_test
