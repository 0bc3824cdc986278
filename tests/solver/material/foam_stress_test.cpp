// Materials 006 and 063.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/material/material.hpp"

namespace gapcheck::solver::foam_stress_test {
namespace {

Material viscoelastic(double bulk, double shear, double long_shear, double decay) {
  const double young = 9 * bulk * shear / (3 * bulk + shear);
  Material material{MaterialKind::viscoelastic, 1, young, young / (2 * shear) - 1, {}, 0, 0, 0};
  material.viscoelastic = Viscoelastic{bulk, long_shear, shear - long_shear, decay};
  return material;
}

// A strain that is put on at once and held: G(t) = G∞ + (G₀ − G∞) exp(−β t); the pressure stays.
TEST(Viscoelastic, Relaxation) {
  const Material material = viscoelastic(100, 10, 4, 3);
  PointState point;
  update_stress(material, {0.03, 0, 0, 0.02, 0, 0}, 1e-9, point);
  EXPECT_NEAR(point.stress[xy], 2 * 10 * 0.02, 1e-8);
  EXPECT_NEAR(point.stress[xx], 100 * 0.03 + 2 * 10 * 0.02, 1e-8);
  EXPECT_NEAR(elastic_energy(material, point), 0.5 * 100 * 9e-4 + 10 * (1.5 * 4e-4 + 2 * 4e-4), 1e-8);
  for (int i = 0; i < 7; ++i) update_stress(material, {}, 0.1, point);
  const double shear = 4 + 6 * std::exp(-2.1);
  EXPECT_NEAR(point.stress[xy], 2 * shear * 0.02, 1e-8);
  EXPECT_NEAR(trace(point.stress) / 3, 3, 1e-12);
  // What the relaxing part held is gone: 6 (1 − exp(−4.2)) e : e.
  EXPECT_NEAR(point.plastic_work, 6 * (1 - std::exp(-4.2)) * (1.5 * 4e-4 + 2 * 4e-4), 1e-8);
}

// A constant shear rate: τ = 2 ε̇ [G∞ t + (G₀ − G∞) (1 − exp(−β t)) / β], exact for any step.
TEST(Viscoelastic, ConstantRateIsExactForAnyStep) {
  const Material material = viscoelastic(100, 10, 4, 3);
  for (const int steps : {1, 7, 100}) {
    PointState point;
    for (int i = 0; i < steps; ++i) update_stress(material, {0, 0, 0, 0.5 / steps, 0, 0}, 1.0 / steps, point);
    EXPECT_NEAR(point.stress[xy], 2 * 0.5 * (4 + 6 * (1 - std::exp(-3.0)) / 3), 1e-13);
  }
}

// Plane stress: the same as three dimensions with the strain through the thickness that it returns; E/(1 − ν²) at once,
// and under a held uniaxial stretch the moduli of K and G∞ in the end.
TEST(Viscoelastic, PlaneStress) {
  const Material material = viscoelastic(100, 10, 4, 3);
  PointState shell, solid;
  for (int i = 0; i < 50; ++i) {
    Symmetric increment{1e-3, -2e-4, 0, 3e-4, 1e-4, 2e-4};
    increment[zz] = update_plane_stress(material, increment, 0.02, shell);
    update_stress(material, increment, 0.02, solid);
  }
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(shell.stress[i], solid.stress[i], 1e-14);
  EXPECT_EQ(shell.stress[zz], 0);
  PointState held;
  update_plane_stress(material, {1e-3, 0, 0, 0, 0, 0}, 1e-9, held);
  EXPECT_NEAR(held.stress[xx], material.plate_modulus() * 1e-3, 1e-9);
  for (int i = 0; i < 2000; ++i) update_plane_stress(material, {}, 0.01, held);
  const double young = 9 * 100 * 4.0 / (300 + 4), nu = young / 8 - 1;
  EXPECT_NEAR(held.stress[xx], young / (1 - nu * nu) * 1e-3, 1e-5 * held.stress[xx]);
}

Material crushable(double poisson = 0) {
  Material material{MaterialKind::crushable, 1, 50, poisson, {}, 0, 0, 0};
  CrushableFoam law;
  law.points = {{0, 1}, {0.3, 1.2}, {0.6, 5}, {0.61, 5.5}};
  law.cutoff = 0.4;
  material.crushable = std::make_shared<const CrushableFoam>(law);
  return material;
}

/// Principal strains e along axes that are turned about z.
void strain_to(const Material& material, PointState& point, Vector from, Vector to, double turn = 0, int steps = 400) {
  const Matrix axes = Eigen::AngleAxisd(turn, Vector::UnitZ()).toRotationMatrix();
  const Symmetric increment = rotated(to_symmetric(Matrix(((to - from) / steps).asDiagonal())), axes);
  for (int i = 0; i < steps; ++i) update_stress(material, increment, 1e-3, point);
}

// Uniaxial compression follows the curve over 1 − V = 1 − exp(ε), unloads with E, and carries at most TSC in tension.
TEST(CrushableFoam, UniaxialPath) {
  const Material material = crushable();
  PointState point;
  strain_to(material, point, {0, 0, 0}, {std::log(0.85), 0, 0});
  EXPECT_NEAR(point.stress[xx], -1.1, 1e-12);
  EXPECT_NEAR(point.stress[yy], 0, 1e-15);
  EXPECT_NEAR(point.plastic_strain, std::log(0.85), 1e-12);
  strain_to(material, point, {0, 0, 0}, {0.01, 0, 0});
  EXPECT_NEAR(point.stress[xx], -0.6, 1e-12);
  strain_to(material, point, {0, 0, 0}, {0.1, 0, 0});
  EXPECT_NEAR(point.stress[xx], 0.4, 1e-12);
  strain_to(material, point, {0, 0, 0}, {std::log(0.5) - std::log(0.85) - 0.11, 0, 0});
  EXPECT_NEAR(point.stress[xx], -(1.2 + 3.8 * 2 / 3), 1e-12);
}

// Each principal stress is cut alone; with turned axes the stress is turned.
TEST(CrushableFoam, PrincipalStressesAreCutOneByOne) {
  PointState straight, turned;
  strain_to(crushable(), straight, {0, 0, 0}, {-0.3, -0.02, 0.1});
  strain_to(crushable(), turned, {0, 0, 0}, {-0.3, -0.02, 0.1}, 0.4);
  const double yield = 1 + 0.2 * (1 - std::exp(-0.22)) / 0.3;
  EXPECT_NEAR(straight.stress[xx], -yield, 1e-12);
  EXPECT_NEAR(straight.stress[yy], -1, 1e-12);
  EXPECT_NEAR(straight.stress[zz], 0.4, 1e-12);
  const Symmetric expected = rotated(straight.stress, Eigen::AngleAxisd(0.4, Vector::UnitZ()).toRotationMatrix());
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(turned.stress[i], expected[i], 1e-12);
}

// Elastic energy and plastic work are the whole work, with and without Poisson's ratio.
TEST(CrushableFoam, WorkIsStoredOrDissipated) {
  for (const double poisson : {0.0, 0.3}) {
    const Material material = crushable(poisson);
    PointState point;
    double work = 0;
    const Symmetric increment{-2e-3, -5e-4, 4e-4, 3e-4, 0, 0};
    for (int i = 0; i < 300; ++i) {
      const Symmetric before = point.stress;
      update_stress(material, increment, 1e-3, point);
      work += (contract(before, increment) + contract(point.stress, increment)) / 2;
    }
    EXPECT_NEAR(elastic_energy(material, point) + point.plastic_work, work, 1e-10);
    EXPECT_GT(point.plastic_work, 0.8 * work);
  }
}

}  // namespace
}  // namespace gapcheck::solver::foam_stress_test
