#include "geometry/batch/plane_band.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gapcheck::geometry::plane_band_test {
namespace {

/// Numbers from -1 to 1.
double number(std::mt19937_64& random) { return static_cast<double>(random() % 2000001) / 1e6 - 1; }

Vector place(std::mt19937_64& random) { return {number(random), number(random), number(random)}; }

/// A unit square or half of it, tilted, sheared, out of shape by `rough` and out of its plane by `warp`.
Facet facet_of(std::mt19937_64& random, bool triangle, double rough, double warp) {
  Facet facet{{Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)}, triangle};
  const Vector shear{0.4 * number(random), 1 + 0.5 * number(random), 0};
  Eigen::Matrix3d tilt = Eigen::Quaterniond(number(random), number(random), number(random), number(random))
                             .normalized()
                             .toRotationMatrix();
  for (Vector& x : facet.x) {
    x = Vector(x.x() + shear.x() * x.y(), shear.y() * x.y(), 0);
    x += Vector(rough * number(random), rough * number(random), warp * number(random));
    x = tilt * x;
  }
  if (triangle) facet.x[3] = facet.x[2];
  return facet;
}

struct Tally {
  int points = 0, outside = 0, proven = 0;
};

Tally compare(std::mt19937_64& random, double rough, double warp, double band) {
  Tally tally;
  for (int round = 0; round < 3000; ++round) {
    const Facet facet = facet_of(random, round % 3 == 0, rough, warp);
    const PlaneBand plane(facet, band);
    const Vector middle = (facet.x[0] + facet.x[1] + facet.x[2]) / 3;
    for (int i = 0; i < 10; ++i) {
      const Vector query = middle + (i % 2 == 0 ? 1 : 2.5) * place(random);
      const bool in_band = closest_point(facet, query, band).in_band;
      ++tally.points;
      tally.outside += in_band ? 0 : 1;
      if (!plane.usable() || !plane.outside(query)) continue;
      ++tally.proven;
      EXPECT_FALSE(in_band) << "round " << round << ", query " << query.transpose();
    }
  }
  return tally;
}

TEST(PlaneBand, SaysOutsideOnlyOfWhatTheClosestPointLeavesOut) {
  std::mt19937_64 random(31);
  for (const double band : {0.0, 0.5}) {
    const Tally flat = compare(random, 0, 0, band), rough = compare(random, 0.1, 0.03, band),
                wild = compare(random, 0.4, 0.4, band);
    // Of flat parallelograms and triangles it misses those without a shape, of common ones a fifth.
    EXPECT_GT(flat.proven, flat.outside * 98 / 100);
    EXPECT_GT(rough.proven, rough.outside * 8 / 10);
    EXPECT_GT(wild.proven, wild.outside / 4);
    EXPECT_LT(wild.outside, wild.points * 9 / 10);
  }
}

TEST(PlaneBand, HeightsAreThoseOverTheMeanPlane) {
  const Facet saddle{{Vector(5, 0, 1.1), Vector(7, 0, 0.9), Vector(7, 3, 1.1), Vector(5, 3, 0.9)}, false};
  const PlaneBand plane(saddle, 0.5);
  ASSERT_TRUE(plane.usable());
  EXPECT_NEAR(plane.warp(), 0.1, 1e-15);
  EXPECT_NEAR(plane.height({6, 1, 1.7}), 0.7, 1e-15);
  EXPECT_NEAR(plane.height({9, -4, 0.5}), -0.5, 1e-15);
  const PlaneBand corner({{Vector(0, 0, 2), Vector(1, 0, 2), Vector(0, 1, 2), Vector(0, 1, 2)}, true}, 0.5);
  ASSERT_TRUE(corner.usable());
  EXPECT_NEAR(corner.height({7, 7, -1}), -3, 1e-15);
  // The band ends where a barycentric coordinate is -1/4.
  EXPECT_FALSE(corner.outside({-0.2499, 0.5, 0}));
  EXPECT_TRUE(corner.outside({-0.2501, 0.5, 0}));
  EXPECT_FALSE(corner.outside({0.6, 0.6499, 0}));
  EXPECT_TRUE(corner.outside({0.6, 0.6501, 0}));
}

TEST(PlaneBand, IsOfNoUseForFacetsWithoutShape) {
  const double nan = std::nan("");
  const Vector o = Vector::Zero(), x{1, 0, 0}, y{0, 1, 0};
  for (const Facet& facet :
       {Facet{{o, o, o, o}, false}, Facet{{o, x, x, o}, false}, Facet{{o, x, 2 * x, 2 * x}, true},
        Facet{{o, x, x + 0.01 * y, 0.01 * x}, true}, Facet{{o, Vector(nan, 0, 0), x + y, y}, false},
        Facet{{o, 1e200 * x, 1e200 * (x + y), 1e200 * y}, false}, Facet{{o, x, x + y, Vector(0.9, 0.1, 0)}, false}})
    EXPECT_FALSE(PlaneBand(facet, 0.5).usable());
}

}  // namespace
}  // namespace gapcheck::geometry::plane_band_test
