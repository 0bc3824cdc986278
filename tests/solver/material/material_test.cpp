#include "solver/material/material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gapcheck::solver::material_test {
namespace {

constexpr double young = 210000, poisson = 0.3, yield = 300, tangent = 10000;
constexpr double plastic_slope = young * tangent / (young - tangent);

Material elastic() { return {MaterialKind::elastic, 7.8e-9, young, poisson, {}, 0, 0, 0}; }
Material hardening(double beta) { return plastic_kinematic(7.8e-9, young, poisson, yield, tangent, beta); }

enum class Law { plane, solid };

double step(const Material& material, const Symmetric& increment, double dt, PointState& point, Law law) {
  if (law == Law::plane) return update_plane_stress(material, increment, dt, point);
  update_stress(material, increment, dt, point);
  return increment[zz];
}

/// One step under uniaxial stress: looks for the lateral strain that leaves no lateral stress.
void pull(const Material& material, double strain, double dt, PointState& point, Law law) {
  const PointState start = point;
  double low = -std::abs(strain), high = std::abs(strain);
  for (int i = 0; i < 200; ++i) {
    const double lateral = (low + high) / 2;
    point = start;
    step(material, {strain, lateral, law == Law::solid ? lateral : 0, 0, 0, 0}, dt, point, law);
    (point.stress[yy] > 0 ? high : low) = lateral;
  }
}

class Uniaxial : public testing::TestWithParam<Law> {};

TEST_P(Uniaxial, YieldsHardensAndUnloads) {
  for (const double beta : {0.0, 0.5, 1.0}) {
    PointState point;
    const Material material = hardening(beta);
    const double at_yield = yield / young;
    pull(material, 0.999 * at_yield, 1, point, GetParam());
    EXPECT_NEAR(point.stress[xx], 0.999 * yield, 1e-8);
    EXPECT_EQ(point.plastic_strain, 0);
    for (int i = 0; i < 10; ++i) pull(material, (0.01 - 0.999 * at_yield) / 10, 1, point, GetParam());
    const double top = yield + tangent * (0.01 - at_yield);
    EXPECT_NEAR(point.stress[xx], top, 1e-6) << beta;
    EXPECT_NEAR(point.plastic_strain, (top - yield) / plastic_slope, 1e-11) << beta;
    pull(material, -0.5 * yield / young, 1, point, GetParam());
    EXPECT_NEAR(point.stress[xx], top - 0.5 * yield, 1e-6);
    // Reversed yield: 2 σ₀ below the top when the surface shifts, at −top when it grows, in between otherwise.
    const double reversed = top - 2 * (yield + beta * (top - yield));
    pull(material, (reversed - point.stress[xx]) / young - 0.002, 1, point, GetParam());
    EXPECT_NEAR(point.stress[xx], reversed - 0.002 * tangent, 1e-6) << beta;
  }
}

// A curve crossed in one step gives what many steps give, and what the curve says.
TEST_P(Uniaxial, FollowsACurve) {
  Material material = elastic();
  material.kind = MaterialKind::plastic;
  material.yield = YieldCurve({{0, 200}, {0.002, 260}, {0.01, 300}, {0.05, 340}});
  PointState once, often;
  pull(material, 0.02, 1, once, GetParam());
  for (int i = 0; i < 50; ++i) pull(material, 0.02 / 50, 1, often, GetParam());
  for (const PointState& point : {once, often}) {
    EXPECT_NEAR(point.stress[xx], material.yield.stress(point.plastic_strain), 1e-6);
    EXPECT_NEAR(point.stress[xx] / young + point.plastic_strain, 0.02, 1e-9);
  }
}

TEST_P(Uniaxial, RateRaisesTheYieldStress) {
  Material material = hardening(1);
  material.rate_c = 100;
  material.rate_p = 5;
  PointState point;
  const Symmetric shear{0, 0, 0, 0.01, 0, 0};
  const double rate = 100;  // of √(ε:ε)
  step(material, shear, std::sqrt(contract(shear, shear)) / rate, point, GetParam());
  const Symmetric s = deviator(point.stress);
  EXPECT_NEAR(std::sqrt(1.5 * contract(s, s)), 2 * (yield + plastic_slope * point.plastic_strain), 1e-7);
}

// τ = √3 (τ-free) : yield at σ₀/√3; beyond it dτ/dγ = G Eₚ / (3 G + Eₚ).
TEST_P(Uniaxial, PureShear) {
  const Material material = hardening(0.3);
  PointState point;
  const double shear = material.shear(), at_yield = yield / std::numbers::sqrt3 / (2 * shear);
  for (const std::size_t component : {xy, yz, zx}) {
    point = {};
    Symmetric increment{};
    increment[component] = 0.01;
    step(material, increment, 1, point, GetParam());
    const double expected =
        yield / std::numbers::sqrt3 + 2 * (0.01 - at_yield) * shear * plastic_slope / (3 * shear + plastic_slope);
    EXPECT_NEAR(point.stress[component], expected, 1e-7);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, Uniaxial, testing::Values(Law::plane, Law::solid),
                         [](const auto& law) { return law.param == Law::plane ? "plane" : "solid"; });

// Plastic flow keeps the volume: the pressure is that of the elastic law however far it flows.
TEST(Material, PlasticFlowKeepsTheVolume) {
  const Material material = hardening(0.5);
  PointState point;
  const Symmetric increment{0.01, -0.004, 0.003, 0.002, 0.001, -0.003};
  for (int i = 0; i < 20; ++i) update_stress(material, increment, 1, point);
  EXPECT_NEAR(trace(point.stress) / 3, material.bulk() * 20 * trace(increment), 1e-6);
  EXPECT_GT(point.plastic_strain, 0.1);
  EXPECT_NEAR(trace(point.back_stress), 0, 1e-9);
  point = {};
  update_stress(material, {0.1, 0.1, 0.1, 0, 0, 0}, 1, point);
  EXPECT_EQ(point.plastic_strain, 0);
}

// Plane stress is the solid with the εzz that leaves σzz = 0; that εzz is what the shell's thickness follows.
TEST(Material, PlaneStressIsTheSolidWithoutNormalStress) {
  for (const double beta : {0.0, 0.4, 1.0}) {
    const Material material = hardening(beta);
    PointState plane, solid;
    Symmetric increment{0.002, -0.0007, 0, 0.0012, 0.0004, -0.0003};
    for (int i = 0; i < 8; ++i) {
      if (i == 5)
        for (double& value : increment) value = -value;
      increment[zz] = update_plane_stress(material, increment, 1, plane);
      update_stress(material, increment, 1, solid);
      for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(plane.stress[c], solid.stress[c], 1e-5) << i << " " << c;
      EXPECT_EQ(plane.stress[zz], 0);
      EXPECT_NEAR(plane.plastic_strain, solid.plastic_strain, 1e-9);
    }
  }
}

TEST(Material, ElasticClosedForms) {
  PointState point;
  const double through = update_plane_stress(elastic(), {0.001, 0.001, 0, 0, 0, 0}, 1, point);
  EXPECT_NEAR(point.stress[xx], young / (1 - poisson) * 0.001, 1e-9);
  EXPECT_NEAR(through, -2 * poisson / (1 - poisson) * 0.001, 1e-15);
  point = {};
  update_stress(elastic(), {0.001, 0, 0, 0, 0, 0}, 1, point);  // confined: the wave modulus
  EXPECT_NEAR(point.stress[xx], elastic().wave_modulus() * 0.001, 1e-9);
  EXPECT_NEAR(point.stress[yy], poisson / (1 - poisson) * elastic().wave_modulus() * 0.001, 1e-9);
}

TEST(Material, NullAndRigidHaveNoStress) {
  for (const MaterialKind kind : {MaterialKind::null, MaterialKind::rigid}) {
    Material material = elastic();
    material.kind = kind;
    PointState point;
    update_stress(material, {0.1, 0, 0, 0.1, 0, 0}, 1, point);
    EXPECT_EQ(update_plane_stress(material, {0.1, 0, 0, 0.1, 0, 0}, 1, point), 0);
    EXPECT_EQ(point.stress, Symmetric{});
  }
}

TEST(Material, Validity) {
  EXPECT_TRUE(elastic().valid());
  EXPECT_TRUE(hardening(1).valid());
  Material material = elastic();
  material.poisson = 0.5;
  EXPECT_FALSE(material.valid());
  material = elastic();
  material.density = 0;
  EXPECT_FALSE(material.valid());
  material = elastic();
  material.kind = MaterialKind::plastic;  // without a yield stress
  EXPECT_FALSE(material.valid());
  EXPECT_FALSE(plastic_kinematic(1, 100, 0.3, 1, 100, 1).valid());  // tangent = E
}

TEST(Tensor, SpinRotationIsARotation) {
  const Matrix r = spin_rotation({0.3, -0.8, 0.5});
  EXPECT_NEAR((r * r.transpose() - Matrix::Identity()).norm(), 0, 1e-15);
  EXPECT_NEAR(r.determinant(), 1, 1e-15);
  // tan(φ/2) = |w|/2 about w.
  EXPECT_NEAR(std::acos((r.trace() - 1) / 2), 2 * std::atan(std::sqrt(0.98) / 2), 1e-15);
  const Symmetric a{1, 2, 3, 4, 5, 6};
  EXPECT_NEAR((to_matrix(rotated(a, r)) - r * to_matrix(a) * r.transpose()).norm(), 0, 1e-14);
}

}  // namespace
}  // namespace gapcheck::solver::material_test
