// Overlaps of two facets against a dense grid of samples, and what holds exactly whatever the facets.
#include "solver/mortar/overlap.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/quad.hpp"

namespace gapcheck::solver::overlap_test {
namespace {

using Facet = std::array<Vector, 4>;

Vector point_of(const Facet& x, const std::array<double, 4>& w) {
  return w[0] * x[0] + w[1] * x[1] + w[2] * x[2] + w[3] * x[3];
}

/// The integrals over an overlap that forces are made of.
struct Sums {
  double area = 0, distance = 0;
  std::array<double, 4> first{}, second{};

  void add(const std::array<double, 4>& on_first, const std::array<double, 4>& on_second, double share, double way) {
    area += share;
    distance += share * way;
    for (std::size_t i = 0; i < 4; ++i) {
      first[i] += share * on_first[i];
      second[i] += share * on_second[i];
    }
  }
};

Sums sums_of(const Overlap& overlap) {
  Sums sums;
  for (const OverlapPoint& p : overlap.points) sums.add(p.first, p.second, p.area, p.distance);
  return sums;
}

/// The slow twin: samples of the first facet, each with the place of the second one on the line through it along the
/// normal, found by bisection of s and t without any projected polygon.
Sums sampled(const Facet& first, const Facet& second, int n) {
  const Vector normal = quad_normal(first).normalized();
  Sums sums;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double s = (2 * i + 1.0) / n - 1, t = (2 * k + 1.0) / n - 1;
      const Vector at = quad_point(first, s, t);
      const Vector ds = (1 - t) / 4 * (first[1] - first[0]) + (1 + t) / 4 * (first[2] - first[3]);
      const Vector dt = (1 - s) / 4 * (first[3] - first[0]) + (1 + s) / 4 * (first[2] - first[1]);
      const double share = ds.cross(dt).dot(normal) * 4 / n / n;
      // Newton's method in space: second(u, v) - at - g · normal = 0.
      double u = 0, v = 0, gap = 0;
      bool found = false;
      for (int step = 0; step < 30 && !found; ++step) {
        const Vector rest = quad_point(second, u, v) - at - gap * normal;
        Eigen::Matrix3d slope;
        slope.col(0) = (1 - v) / 4 * (second[1] - second[0]) + (1 + v) / 4 * (second[2] - second[3]);
        slope.col(1) = (1 - u) / 4 * (second[3] - second[0]) + (1 + u) / 4 * (second[2] - second[1]);
        slope.col(2) = -normal;
        const Vector way = slope.inverse() * rest;
        u -= way.x();
        v -= way.y();
        gap -= way.z();
        found = way.norm() < 1e-10;
      }
      if (!found || std::abs(u) > 1 || std::abs(v) > 1) continue;
      sums.add(quad_weights(s, t), quad_weights(u, v), share, gap);
    }
  return sums;
}

Facet facet(std::mt19937& random, double z, bool down) {
  std::uniform_real_distribution<double> shake(-0.25, 0.25), shift(-0.8, 0.8), turn(0, 3);
  const double dx = shift(random), dy = shift(random), angle = turn(random);
  Facet x{Vector(-1, -1, 0), Vector(1, -1, 0), Vector(1, 1, 0), Vector(-1, 1, 0)};
  for (Vector& corner : x) {
    const Vector old = corner;
    corner = {std::cos(angle) * old.x() - std::sin(angle) * old.y() + dx + shake(random),
              std::sin(angle) * old.x() + std::cos(angle) * old.y() + dy + shake(random), z + shake(random)};
  }
  if (down) std::swap(x[1], x[3]);
  return x;
}

TEST(Overlap, AgreesWithDenseSamples) {
  std::mt19937 random(7);
  double worst = 0;
  int with_area = 0;
  for (int i = 0; i < 40; ++i) {
    const Facet a = facet(random, 0, false), b = facet(random, 0.4, i % 2 == 0);
    Overlap overlap;
    find_overlap(a, b, overlap);
    const Sums fast = sums_of(overlap), slow = sampled(a, b, 300);
    with_area += slow.area > 0.1;
    const auto compare = [&](double one, double other) { worst = std::max(worst, std::abs(one - other)); };
    compare(fast.area, slow.area);
    compare(fast.distance, slow.distance);
    for (std::size_t c = 0; c < 4; ++c) {
      compare(fast.first[c], slow.first[c]);
      compare(fast.second[c], slow.second[c]);
    }
  }
  EXPECT_GT(with_area, 30);
  EXPECT_LT(worst, 0.01) << "300 x 300 samples of facets with an area of about 4";
  RecordProperty("worst_difference", fmt::format("{:.2g}", worst));
}

TEST(Overlap, BothPointsLieOnOneLineAlongTheNormal) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    const Facet a = facet(random, 0, false), b = facet(random, 0.4, i % 2 == 0);
    Overlap overlap;
    find_overlap(a, b, overlap);
    double area = 0;
    for (const OverlapPoint& p : overlap.points) {
      const Vector way = point_of(b, p.second) - point_of(a, p.first);
      EXPECT_LT((way - p.distance * overlap.normal).norm(), 1e-12);
      EXPECT_GT(p.area, 0);
      area += p.area;
    }
    EXPECT_DOUBLE_EQ(area, overlap.area);
  }
}

// Turned and moved together, two facets have the same overlap.
TEST(Overlap, RigidMotionChangesNothing) {
  std::mt19937 random(11);
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(1.1, Vector(1, 2, -0.5).normalized()) * Eigen::AngleAxisd(-2, Vector::UnitZ()))
          .toRotationMatrix();
  for (int i = 0; i < 100; ++i) {
    const Facet a = facet(random, 0, false), b = facet(random, 0.4, i % 2 == 0);
    Facet turned_a = a, turned_b = b;
    for (std::size_t c = 0; c < 4; ++c) {
      turned_a[c] = turn * a[c] + Vector(3, -2, 5);
      turned_b[c] = turn * b[c] + Vector(3, -2, 5);
    }
    Overlap before, after;
    find_overlap(a, b, before);
    find_overlap(turned_a, turned_b, after);
    const Sums first = sums_of(before), second = sums_of(after);
    EXPECT_NEAR(first.area, second.area, 1e-12);
    EXPECT_NEAR(first.distance, second.distance, 1e-12);
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_NEAR(first.first[c], second.first[c], 1e-12);
      EXPECT_NEAR(first.second[c], second.second[c], 1e-12);
    }
    EXPECT_LT((turn * before.normal - after.normal).norm(), 1e-14);
  }
}

// A facet covered by others that share its area out: the integrals of its weights are those of the whole facet.
TEST(Overlap, PiecesOfACoverGiveTheWholeFacet) {
  const Facet a{Vector(0, 0, 0), Vector(1, 0.1, 0), Vector(1.2, 0.9, 0), Vector(-0.1, 1, 0)};
  Sums sums;
  Overlap overlap;
  for (int i = -2; i < 6; ++i)
    for (int k = -2; k < 6; ++k) {
      const double x = 0.3 * i, y = 0.3 * k;
      find_overlap(a, {Vector(x, y, 1), Vector(x, y + 0.3, 1), Vector(x + 0.3, y + 0.3, 1), Vector(x + 0.3, y, 1)},
                   overlap);
      for (const OverlapPoint& p : overlap.points) sums.add(p.first, p.second, p.area, p.distance);
    }
  EXPECT_NEAR(sums.area, quad_normal(a).norm() / 2, 1e-14);
  EXPECT_NEAR(sums.distance, sums.area, 1e-14);
  // Exact integrals of the bilinear weights: the corner's Jacobian counts most.
  const Sums whole = sampled(a, {Vector(-9, -9, 1), Vector(9, -9, 1), Vector(9, 9, 1), Vector(-9, 9, 1)}, 400);
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(sums.first[c], whole.first[c], 1e-5);
}

TEST(Overlap, TrianglesAndConcaveFacets) {
  const Facet square{Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)};
  Overlap overlap;
  const Facet triangle{Vector(0, 0, 1), Vector(1, 0, 1), Vector(0, 1, 1), Vector(0, 1, 1)};
  find_overlap(square, triangle, overlap);
  EXPECT_NEAR(overlap.area, 0.5, 1e-15);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sums_of(overlap).second[c], 0.5 / 3, 1e-15);
  EXPECT_EQ(sums_of(overlap).second[3], 0);
  find_overlap(triangle, square, overlap);
  EXPECT_NEAR(overlap.area, 0.5, 1e-15);
  const Facet arrow{Vector(0, 0, 1), Vector(1, 0, 1), Vector(0.25, 0.25, 1), Vector(0, 1, 1)};
  find_overlap(square, arrow, overlap);
  EXPECT_NEAR(overlap.area, 0.25, 1e-15);
}

TEST(Overlap, NothingInCommonHasNoPoints) {
  const Facet square{Vector(0, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)};
  Overlap overlap;
  for (const Facet& other :
       {Facet{Vector(1, 0, 1), Vector(2, 0, 1), Vector(2, 1, 1), Vector(1, 1, 1)},          // side by side
        Facet{Vector(0.5, 0, 0), Vector(0.5, 1, 0), Vector(0.5, 1, 1), Vector(0.5, 0, 1)},  // on edge
        Facet{Vector(0.5, 0.5, 1), Vector(0.5, 0.5, 1), Vector(0.5, 0.5, 1), Vector(0.5, 0.5, 1)}}) {
    find_overlap(square, other, overlap);
    EXPECT_TRUE(overlap.points.empty());
    EXPECT_EQ(overlap.area, 0);
    find_overlap(other, square, overlap);
    EXPECT_TRUE(overlap.points.empty());
  }
  const double nan = std::nan("");
  find_overlap(square, {Vector(nan, 0, 0), Vector(1, 0, 0), Vector(1, 1, 0), Vector(0, 1, 0)}, overlap);
  EXPECT_TRUE(overlap.points.empty());
}

}  // namespace
}  // namespace gapcheck::solver::overlap_test
