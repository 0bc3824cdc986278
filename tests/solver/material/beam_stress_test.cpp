#include "solver/material/beam_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gapcheck::solver::beam_stress_test {
namespace {

constexpr double young = 1000, poisson = 0.3;

Material hardening(double beta) { return plastic_kinematic(1, young, poisson, 5, 100, beta); }

/// The same point in three dimensions: the strains across are those that leave no stress there. Newton steps with the
/// stiffest slope, until that stress is rounding.
void slow_update(const Material& material, const BeamTensor& increment, double dt, PointState& point) {
  const PointState start = point;
  Symmetric strain{increment[0], -0.3 * increment[0], -0.3 * increment[0], increment[1] / 2, 0, increment[2] / 2};
  for (int i = 0; i < 5000; ++i) {
    point = start;
    update_stress(material, strain, dt, point);
    const double mean = (point.stress[yy] + point.stress[zz]) / 2;
    if (std::abs(mean) < 1e-13) break;
    strain[yy] -= mean / (2 * (material.bulk() + material.shear() / 3));
    strain[zz] = strain[yy];
  }
}

/// A path that turns in stretching and both shears.
BeamTensor path(int step) {
  const double a = 0.37 * step;
  return {2e-3 * std::cos(a), 3e-3 * std::sin(0.7 * a), 2.5e-3 * std::cos(1.3 * a + 1)};
}

TEST(BeamStress, AsInThreeDimensions) {
  for (const double beta : {0.0, 0.5, 1.0}) {
    const Material material = hardening(beta);
    BeamPoint point;
    PointState solid;
    double worst = 0;
    for (int step = 0; step < 60; ++step) {
      update_beam_stress(material, path(step), 1, point);
      slow_update(material, path(step), 1, solid);
      worst = std::max({worst, std::abs(point.stress[0] - solid.stress[xx]),
                        std::abs(point.stress[1] - solid.stress[xy]), std::abs(point.stress[2] - solid.stress[zx]),
                        100 * std::abs(point.plastic_strain - solid.plastic_strain)});
    }
    EXPECT_GT(point.plastic_strain, 0.02);
    EXPECT_LT(worst, 1e-9) << beta;
  }
}

TEST(BeamStress, AsInThreeDimensionsWithThePlasticRate) {
  Material material = hardening(1);
  material.rate_c = 40;
  material.rate_p = 5;
  material.viscoplastic = true;
  BeamPoint point;
  PointState solid;
  for (int step = 0; step < 40; ++step) {
    update_beam_stress(material, path(step), 1e-4, point);
    slow_update(material, path(step), 1e-4, solid);
    EXPECT_NEAR(point.stress[0], solid.stress[xx], 1e-8);
    EXPECT_NEAR(point.stress[1], solid.stress[xy], 1e-8);
    EXPECT_NEAR(point.plastic_strain, solid.plastic_strain, 1e-10);
  }
}

// Yield, slope and reversed yield in tension; in shear at σ₀/√3 with the slope G_t of γ: 1/G_t = 1/G + 3/Eₚ.
TEST(BeamStress, ClosedForms) {
  const double plastic_slope = young * 100 / (young - 100), shear = young / 2.6;
  for (const double beta : {0.0, 1.0}) {
    const Material material = hardening(beta);
    BeamPoint pulled, sheared;
    update_beam_stress(material, {0.004, 0, 0}, 1, pulled);
    EXPECT_NEAR(pulled.stress[0], 4, 1e-12);
    update_beam_stress(material, {0.006, 0, 0}, 1, pulled);
    EXPECT_NEAR(pulled.stress[0], 5 + 100 * 0.005, 1e-12);
    const double reversed = 5.5 - 2 * (beta == 0 ? 5 : 5.5);
    update_beam_stress(material, {(reversed - 5.5) / young - 0.001, 0, 0}, 1, pulled);
    EXPECT_NEAR(pulled.stress[0], reversed - 0.1, 1e-12);
    const double yield = 5 / std::sqrt(3.0), more = 0.02, slope = 1 / (1 / shear + 3 / plastic_slope);
    update_beam_stress(material, {0, 0.6 * (yield / shear + more), 0.8 * (yield / shear + more)}, 1, sheared);
    EXPECT_NEAR(std::hypot(sheared.stress[1], sheared.stress[2]), yield + slope * more, 1e-12);
    EXPECT_NEAR(sheared.stress[1] / sheared.stress[2], 0.75, 1e-12);
  }
}

// The work on a point is its elastic energy, plastic work and, with a shifting surface, nothing else.
TEST(BeamStress, WorkIsStoredOrDissipated) {
  const Material material = hardening(0.3);
  BeamPoint point;
  double work = 0;
  for (int step = 0; step < 200; ++step) {
    const BeamTensor before = point.stress, increment = path(step);
    update_beam_stress(material, increment, 1, point);
    for (std::size_t i = 0; i < 3; ++i) work += (before[i] + point.stress[i]) / 2 * increment[i];
  }
  EXPECT_NEAR(work, elastic_energy(material, point.stress) + point.plastic_work, 1e-12);
}

TEST(BeamStress, FailsAtTheStrain) {
  Material material = hardening(1);
  material.failure_strain = 0.02;
  BeamPoint point;
  for (int step = 0; step < 100 && !point.failed; ++step) {
    EXPECT_LT(point.plastic_strain, 0.02);
    update_beam_stress(material, {0.001, 0.001, 0}, 1, point);
  }
  EXPECT_TRUE(point.failed);
  EXPECT_EQ(point.stress, BeamTensor{});
  update_beam_stress(material, {0.001, 0.001, 0}, 1, point);
  EXPECT_EQ(point.stress, BeamTensor{});
}

/// Without hardening, σ₀ = 5, C = 2, P = 1.
Material viscous(double rate_stress = 0) {
  Material material = plastic_kinematic(1, young, poisson, 5, 0, 1);
  material.rate_c = 2;
  material.rate_p = 1;
  material.viscoplastic = true;
  material.rate_stress = rate_stress;
  return material;
}

// A held strain relaxes: σ̇ = −E C (σ − σ₀)/σ₀, by implicit steps (σ − σ₀) falls by 1/(1 + E C dt/σ₀) in each.
TEST(Viscoplastic, RelaxesTowardsTheStaticStress) {
  const Material material = viscous();
  constexpr double dt = 1e-3, factor = 1 / (1 + young * 2 * dt / 5);
  BeamPoint point;
  update_beam_stress(material, {0.02, 0, 0}, dt, point);
  double over = (20 - 5) * factor;
  EXPECT_NEAR(point.stress[0], 5 + over, 1e-12);
  for (int step = 0; step < 20; ++step) {
    update_beam_stress(material, {0, 0, 0}, dt, point);
    over *= factor;
    EXPECT_NEAR(point.stress[0], 5 + over, 1e-12);
  }
}

// In steady flow the plastic rate is the whole rate: σ = σ₀ (1 + (ε̇/C)^(1/P)), or σ₀ + SIGY (ε̇/C)^(1/P).
TEST(Viscoplastic, SteadyFlow) {
  for (const double power : {1.0, 3.0, 5.0})
    for (const double rate_stress : {0.0, 3.0}) {
      Material material = viscous(rate_stress);
      material.rate_p = power;
      constexpr double rate = 7, dt = 1e-4;
      const double wanted = 5 + (rate_stress > 0 ? rate_stress : 5) * std::pow(rate / 2, 1 / power);
      BeamPoint point;
      PointState shell, solid;
      for (int step = 0; step < 4000; ++step) {
        update_beam_stress(material, {rate * dt, 0, 0}, dt, point);
        if (step < 1000) update_plane_stress(material, {rate * dt, -rate * dt / 2, 0, 0, 0, 0}, dt, shell);
        if (step < 1000) update_stress(material, {rate * dt, -rate * dt / 2, -rate * dt / 2, 0, 0, 0}, dt, solid);
      }
      EXPECT_NEAR(point.stress[0], wanted, 1e-10) << power;
      EXPECT_NEAR(solid.stress[xx] - solid.stress[yy], wanted, 1e-6) << power;
      EXPECT_NEAR(shell.stress[xx], wanted, 1e-6) << power;
      EXPECT_NEAR(shell.stress[yy], 0, 1e-6) << power;
    }
}

// By a table: linear between the curves, by the rate of the plastic strain.
TEST(Viscoplastic, Table) {
  Material material = viscous();
  material.rate_c = material.rate_p = 0;
  material.table.rates = {0, 10};
  material.table.curves = {YieldCurve(5, 0), YieldCurve(9, 0)};
  YieldCurve::align(material.table.curves);
  BeamPoint point;
  for (int step = 0; step < 2000; ++step) update_beam_stress(material, {4e-4, 0, 0}, 1e-4, point);
  EXPECT_NEAR(point.stress[0], 5 + 0.4 * 4, 1e-10);
  for (int step = 0; step < 2000; ++step) update_beam_stress(material, {2e-3, 0, 0}, 1e-4, point);
  EXPECT_NEAR(point.stress[0], 9, 1e-10);
}

// Elastic steps do not know the rate: with VP = 1 the stress at first yield is the static one, without it is not.
TEST(Viscoplastic, FirstYieldIsStatic) {
  Material material = viscous();
  BeamPoint by_plastic, by_total;
  update_beam_stress(material, {0.0049, 0, 0}, 1e-4, by_plastic);
  EXPECT_EQ(by_plastic.plastic_strain, 0);
  update_beam_stress(material, {0.0002, 0, 0}, 1e-4, by_plastic);
  EXPECT_GT(by_plastic.plastic_strain, 0);
  material.viscoplastic = false;
  update_beam_stress(material, {0.0049, 0, 0}, 1e-4, by_total);
  update_beam_stress(material, {0.0002, 0, 0}, 1e-4, by_total);
  EXPECT_EQ(by_total.plastic_strain, 0);
}

}  // namespace
}  // namespace gapcheck::solver::beam_stress_test
