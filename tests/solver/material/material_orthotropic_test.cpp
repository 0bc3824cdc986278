#include <gtest/gtest.h>

#include <cmath>

#include "solver/material/material.hpp"

namespace gapcheck::solver::material_orthotropic_test {
namespace {

Material sheet(double ea, double eb, double poisson_ba, double gab, bool only_tension = false) {
  Material material{MaterialKind::orthotropic, 1, ea, 0, {}, 0, 0, 0};
  OrthotropicPlane law;
  law.ea = ea;
  law.eb = eb;
  law.poisson_ba = poisson_ba;
  law.gab = gab;
  law.gbc = 3;
  law.gca = 5;
  law.only_tension = only_tension;
  material.orthotropic = law;
  return material;
}

PointState strained(const Material& material, const Symmetric& strain, double axis = 0) {
  PointState point;
  point.axis = axis;
  update_plane_stress(material, strain, 1, point);
  return point;
}

// The compliance of the card: εa = σa/EA − PRBA σb/EB, and likewise; shears by their own moduli.
TEST(Orthotropic, Compliance) {
  const PointState point = strained(sheet(100, 40, 0.1, 7), {0.01, 0.02, 0, 0.004, 0.002, 0.001});
  EXPECT_NEAR(point.stress[xx] / 100 - 0.1 / 40 * point.stress[yy], 0.01, 1e-14);
  EXPECT_NEAR(point.stress[yy] / 40 - 0.1 / 40 * point.stress[xx], 0.02, 1e-14);
  EXPECT_NEAR(point.stress[xy], 2 * 7 * 0.004, 1e-14);
  EXPECT_NEAR(point.stress[yz], 2 * 3 * 0.002, 1e-14);
  EXPECT_NEAR(point.stress[zx], 2 * 5 * 0.001, 1e-14);
  double work = 0;
  const Symmetric strain{0.01, 0.02, 0, 0.004, 0.002, 0.001};
  work = contract(point.stress, strain) / 2;
  EXPECT_NEAR(elastic_energy(sheet(100, 40, 0.1, 7), point), work, 1e-15);
}

// A quarter turn exchanges a and b; at 45 degrees the modulus is 4 / (1/EA + 1/EB − 2 PRBA/EB + 1/GAB).
TEST(Orthotropic, TurnedAxes) {
  const Material material = sheet(100, 40, 0.1, 7);
  const PointState straight = strained(material, {0.01, 0.02, 0, 0.004, 0, 0}),
                   quarter = strained(material, {0.02, 0.01, 0, -0.004, 0, 0}, std::acos(0.0));
  EXPECT_NEAR(quarter.stress[xx], straight.stress[yy], 1e-13);
  EXPECT_NEAR(quarter.stress[yy], straight.stress[xx], 1e-13);
  EXPECT_NEAR(quarter.stress[xy], -straight.stress[xy], 1e-13);
  // Strain of a unit stress along x with axes at 45 degrees: σa = σb = ½, τ = −½.
  const double a = 0.5 / 100 - 0.1 / 40 * 0.5, b = 0.5 / 40 - 0.1 / 40 * 0.5, shear = -0.5 / 14;
  const PointState pulled =
      strained(material, {(a + b) / 2 - shear, (a + b) / 2 + shear, 0, (a - b) / 2, 0, 0}, std::acos(0.0) / 2);
  EXPECT_NEAR(pulled.stress[xx], 1, 1e-13);
  EXPECT_NEAR(pulled.stress[yy], 0, 1e-13);
  EXPECT_NEAR(pulled.stress[xy], 0, 1e-13);
  EXPECT_NEAR(elastic_energy(material, pulled), ((a + b) / 2 - shear) / 2, 1e-14);
}

// Equal moduli and G = E / 2 (1 + ν) are Hooke's law.
TEST(Orthotropic, IsotropicModuliAreHookesLaw) {
  const Material hooke{MaterialKind::elastic, 1, 100, 0.3, {}, 0, 0, 0};
  PointState point;
  update_plane_stress(hooke, {0.01, -0.02, 0, 0.03, 0, 0}, 1, point);
  const PointState other = strained(sheet(100, 100, 0.3, 100 / 2.6), {0.01, -0.02, 0, 0.03, 0, 0}, 0.7);
  for (const std::size_t i : {xx, yy, xy}) EXPECT_NEAR(other.stress[i], point.stress[i], 1e-13);
}

// CSE: principal stresses below zero are taken out, in any axes; what was taken out comes back with the strain.
TEST(Orthotropic, OnlyTension) {
  const Material fabric = sheet(100, 100, 0, 50, true);
  PointState point = strained(fabric, {0.02, -0.03, 0, 0, 0, 0});
  EXPECT_NEAR(point.stress[xx], 2, 1e-13);
  EXPECT_NEAR(point.stress[yy], 0, 1e-13);
  update_plane_stress(fabric, {0, 0.05, 0, 0, 0, 0}, 1, point);
  EXPECT_NEAR(point.stress[yy], 2, 1e-13);
  update_plane_stress(fabric, {-0.05, -0.05, 0, 0, 0, 0}, 1, point);
  EXPECT_EQ(point.stress[xx], 0);
  // Pure shear carries tension along the diagonal alone: ½ (1 1; 1 1) of the shear stress.
  const PointState sheared = strained(fabric, {0, 0, 0, 0.01, 0, 0});
  EXPECT_NEAR(sheared.stress[xx], 0.5, 1e-13);
  EXPECT_NEAR(sheared.stress[yy], 0.5, 1e-13);
  EXPECT_NEAR(sheared.stress[xy], 0.5, 1e-13);
}

}  // namespace
}  // namespace gapcheck::solver::material_orthotropic_test
