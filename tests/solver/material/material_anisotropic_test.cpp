#include <gtest/gtest.h>

#include <cmath>

#include "solver/material/material.hpp"

namespace gapcheck::solver::material_anisotropic_test {
namespace {

constexpr double young = 210000, poisson = 0.3, yield = 300, slope = 5000;

Material sheet(double ratio) {
  Material material{MaterialKind::anisotropic, 7.8e-9, young, poisson, {}, 0, 0, 0, {}, 1};
  material.yield = YieldCurve({{0, yield}, {0.01, yield + 0.01 * slope}, {0.2, 400}});
  material.anisotropy = ratio;
  return material;
}

double size_of(const Symmetric& s, double ratio) {
  return std::sqrt(s[xx] * s[xx] + s[yy] * s[yy] - 2 * ratio / (1 + ratio) * s[xx] * s[yy] +
                   2 * (1 + 2 * ratio) / (1 + ratio) * s[xy] * s[xy] + 3 * (s[yz] * s[yz] + s[zx] * s[zx]));
}

/// One step under uniaxial stress along x; returns the lateral strain.
double pull(const Material& material, double strain, PointState& point) {
  const PointState start = point;
  double low = -std::abs(strain), high = std::abs(strain);
  for (int i = 0; i < 200; ++i) {
    point = start;
    update_plane_stress(material, {strain, (low + high) / 2, 0, 0, 0, 0}, 1, point);
    (point.stress[yy] > 0 ? high : low) = (low + high) / 2;
  }
  return (low + high) / 2;
}

// Uniaxial: yields at σ₀, hardens with the curve, and thins: plastic ε_width / ε_thickness = R.
TEST(Anisotropic, UniaxialYieldAndThinning) {
  for (const double ratio : {0.5, 1.0, 1.593, 3.0}) {
    PointState point;
    pull(sheet(ratio), 0.999 * yield / young, point);
    EXPECT_EQ(point.plastic_strain, 0);
    EXPECT_NEAR(point.stress[xx], 0.999 * yield, 1e-8);
    double width = 0;
    for (int i = 0; i < 5; ++i) width += pull(sheet(ratio), 0.001, point);
    EXPECT_NEAR(point.stress[xx], yield + slope * point.plastic_strain, 1e-7);
    const double stress_after = point.stress[xx] - 0.999 * yield;
    const double plastic = 0.005 - stress_after / young, plastic_width = width + poisson * stress_after / young;
    EXPECT_NEAR(point.plastic_strain, plastic, 1e-10);
    EXPECT_NEAR(plastic_width / (-plastic - plastic_width), ratio, 1e-6 * ratio);
  }
}

// Equibiaxial: q = σ √(2 / (1 + R)); pure shear: q = τ √(2 (1 + 2R) / (1 + R)).
TEST(Anisotropic, BiaxialAndShearYield) {
  for (const double ratio : {0.5, 1.593}) {
    PointState both, sheared;
    for (int i = 0; i < 100; ++i) {
      const double through = update_plane_stress(sheet(ratio), {1e-4, 1e-4, 0, 0, 0, 0}, 1, both);
      EXPECT_LT(through, 0);
      update_plane_stress(sheet(ratio), {0, 0, 0, 1e-4, 0, 0}, 1, sheared);
    }
    EXPECT_NEAR(both.stress[xx] * std::sqrt(2 / (1 + ratio)), sheet(ratio).yield.stress(both.plastic_strain), 1e-9);
    EXPECT_NEAR(both.stress[xx], both.stress[yy], 1e-9);
    EXPECT_NEAR(sheared.stress[xy] * std::sqrt(2 * (1 + 2 * ratio) / (1 + ratio)),
                sheet(ratio).yield.stress(sheared.plastic_strain), 1e-9);
    EXPECT_GT(both.plastic_strain, 0.01);
  }
}

// R = 1 is von Mises: the same as material 024 on any path, transverse shear and thickness included.
TEST(Anisotropic, WithoutAnisotropyItIsMises) {
  Material mises = sheet(1);
  mises.kind = MaterialKind::plastic;
  PointState one, other;
  for (int i = 0; i < 200; ++i) {
    const double a = i, size = i % 3 == 2 ? 1e-6 : 1;  // every third step is tiny
    Symmetric increment{1e-3 * std::sin(a),       2e-3 * std::cos(0.7 * a), 0,
                        1e-3 * std::sin(0.3 * a), 5e-4 * std::cos(0.2 * a), 4e-4 * std::sin(0.5 * a)};
    for (double& value : increment) value *= size;
    const double through = update_plane_stress(sheet(1), increment, 1, one);
    EXPECT_NEAR(through, update_plane_stress(mises, increment, 1, other), 1e-12);
    for (std::size_t k = 0; k < 6; ++k) ASSERT_NEAR(one.stress[k], other.stress[k], 1e-9 * yield) << i;
    ASSERT_NEAR(one.plastic_strain, other.plastic_strain, 1e-12);
    ASSERT_LE(size_of(one.stress, 1), sheet(1).yield.stress(one.plastic_strain) * (1 + 1e-12));
  }
  EXPECT_GT(one.plastic_strain, 0.005);
}

// Huge steps, no yield stress at the start, curves that fall: always an answer on or below the surface.
TEST(Anisotropic, ExtremeSteps) {
  for (const double ratio : {0.0, 0.1, 1.593, 50.0})
    for (const double strain : {1e-6, 1e-2, 1.0, 100.0}) {
      PointState point;
      update_plane_stress(sheet(ratio), {strain, -0.3 * strain, 0, strain, 0.1 * strain, 0}, 1, point);
      const double limit = sheet(ratio).yield.stress(point.plastic_strain);
      EXPECT_LE(size_of(point.stress, ratio), limit * (1 + 1e-9)) << ratio << " " << strain;
      Material soft = sheet(ratio);
      soft.yield = YieldCurve({{0, 0}, {1, 13}});
      EXPECT_TRUE(soft.valid());
      PointState yielding;
      update_plane_stress(soft, {strain, -0.3 * strain, 0, strain, 0, 0}, 1, yielding);
      EXPECT_NEAR(size_of(yielding.stress, ratio) / (13 * yielding.plastic_strain), 1, 1e-6);
      Material falling = sheet(ratio);
      falling.yield = YieldCurve(yield, -1000);
      PointState weak;
      update_plane_stress(falling, {strain, -0.3 * strain, 0, strain, 0, 0}, 1, weak);
      EXPECT_TRUE(std::isfinite(weak.stress[xx] + weak.stress[xy] + weak.plastic_strain));
      EXPECT_LE(size_of(weak.stress, ratio), std::max(falling.yield.stress(weak.plastic_strain), 0.0) + 1e-9 * yield)
          << ratio << " " << strain;
    }
}

// Between two curves in proportion to the rate, beyond them the last one.
TEST(RateTable, InterpolatesBetweenCurves) {
  Material material{MaterialKind::plastic, 7.8e-9, young, poisson, {}, 0, 0, 0, {}, 1};
  material.table.rates = {1, 11};
  material.table.curves = {YieldCurve({{0, 100}, {0.1, 200}}), YieldCurve({{0, 300}, {0.05, 350}, {0.2, 380}})};
  YieldCurve::align(material.table.curves);
  material.yield = material.table.curves[0];
  ASSERT_TRUE(material.valid());
  EXPECT_DOUBLE_EQ(material.table.curves[0].stress(0.05), 150);
  EXPECT_DOUBLE_EQ(material.table.curves[1].stress(0.1), 360);
  EXPECT_DOUBLE_EQ(material.yield_at(0).stress(0.05), 150);
  EXPECT_DOUBLE_EQ(material.yield_at(3).stress(0.05), 0.8 * 150 + 0.2 * 350);
  EXPECT_DOUBLE_EQ(material.yield_at(11).stress(0.1), 360);
  EXPECT_DOUBLE_EQ(material.yield_at(1e9).stress(0.1), 360);
  // trial − R Δ = σ(p + Δ), over a corner.
  const YieldLaw law = material.yield_at(3);
  const auto [increment, tangent] = law.solve(300, 1000, 0.03);
  EXPECT_NEAR(300 - 1000 * increment, law.stress(0.03 + increment), 1e-10);
  EXPECT_NEAR(tangent, (law.stress(0.03 + increment) - law.stress(0.03 + increment - 1e-6)) / 1e-6, 1e-3);
  material.table.logarithmic = true;
  material.table.rates = {std::log(1.0), std::log(100.0)};
  EXPECT_NEAR(material.yield_at(10).stress(0), 200, 1e-9);
  EXPECT_DOUBLE_EQ(material.yield_at(0).stress(0), 100);
}

// In the stress update: the flow stress of pure shear at a given rate, √(ε̇:ε̇) = √2 ε̇xy.
TEST(RateTable, ShearAtARate) {
  Material material{MaterialKind::plastic, 7.8e-9, young, poisson, {}, 0, 0, 0, {}, 1};
  material.table.rates = {0, 10};
  material.table.curves = {YieldCurve({{0, 100}}), YieldCurve({{0, 200}})};
  material.yield = material.table.curves[0];
  PointState point;
  const double dt = 1e-3, rate = 5;
  for (int i = 0; i < 50; ++i) update_stress(material, {0, 0, 0, rate / std::sqrt(2.0) * dt, 0, 0}, dt, point);
  EXPECT_NEAR(point.stress[xy], 150 / std::sqrt(3.0), 1e-9);
}

}  // namespace
}  // namespace gapcheck::solver::material_anisotropic_test
