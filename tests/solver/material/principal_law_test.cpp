#include "solver/material/principal_law.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "solver/material/finite_law.hpp"
#include "solver/material/rubber.hpp"

namespace gapcheck::solver::principal_law_test {
namespace {

using Points = std::vector<std::array<double, 2>>;

struct Named {
  std::string name;
  std::shared_ptr<const PrincipalLaw> law;
};

/// A smooth law of each kind, at some 1 per strain.
std::vector<Named> laws() {
  const auto nominal = [](double strain) { return strain > 0 ? strain : std::expm1(2 * strain) / 2; };
  return {{"ogden", std::make_shared<OgdenLaw>(StretchFunction::terms({{0.63, 1.3}, {0.0012, 5}, {-0.01, -2}}), 20)},
          {"blatz_ko", std::make_shared<HillLaw>(StretchFunction::terms({{1, 2}}), 0.463)},
          {"hill", std::make_shared<HillLaw>(tabulated_stretch(nominal, 0.2), 0.2)},
          {"invariants", std::make_shared<InvariantLaw>(std::array{0.3, 0.1, 0.02, -0.01, 0.003, 0.002}, 15)},
          {"foam", std::make_shared<LowDensityFoamLaw>(Points{{0, 0}, {1, 1}}, 2, 1e20, false)}};
}

Matrix random_gradient(std::mt19937& engine, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  Matrix f;
  do
    for (int i = 0; i < 9; ++i) f(i / 3, i % 3) = (i % 4 == 0 ? 1 : 0) + number(engine);
  while (f.determinant() < 0.2);
  return f;
}

FinitePoint point_of(const std::shared_ptr<const PrincipalLaw>& law, const Matrix& f) {
  FiniteLaw finite;
  finite.elastic = law;
  FiniteHistory history;
  return update_finite(finite, f, Matrix::Zero(), 0, history);
}

// σ = J⁻¹ ∂W/∂F Fᵀ, and no stress or energy at rest.
TEST(PrincipalLaw, StressIsTheSlopeOfTheEnergy) {
  std::mt19937 engine(7);
  for (const auto& [name, law] : laws()) {
    for (const double s : point_of(law, Matrix::Identity()).stress) EXPECT_NEAR(s, 0, 1e-14) << name;
    EXPECT_NEAR(point_of(law, Matrix::Identity()).energy, 0, 1e-14) << name;
    for (int trial = 0; trial < 20; ++trial) {
      const Matrix f = random_gradient(engine, 0.5);
      Matrix slope;
      constexpr double h = 1e-5;
      for (int i = 0; i < 9; ++i) {
        Matrix up = f, down = f;
        up(i / 3, i % 3) += h;
        down(i / 3, i % 3) -= h;
        slope(i / 3, i % 3) = (point_of(law, up).energy - point_of(law, down).energy) / (2 * h);
      }
      const Matrix expected = slope * f.transpose() / f.determinant();
      EXPECT_NEAR((to_matrix(point_of(law, f).stress) - expected).norm(), 0, 1e-5 * (1 + expected.norm())) << name;
    }
  }
}

// Against the largest eigenvalue of ∂²W/∂g² by differences, also where two stretches are equal.
TEST(PrincipalLaw, StiffnessBound) {
  std::mt19937 engine(11);
  for (const auto& [name, law] : laws())
    for (int trial = 0; trial < 30; ++trial) {
      Matrix f = random_gradient(engine, 0.5);
      if (trial == 0) f = Matrix::Identity();
      if (trial == 1) f = Vector(0.7, 0.7, 1.2).asDiagonal();
      constexpr double h = 1e-4;
      const auto energy = [&, &law = law](int i, double di, int j, double dj) {
        Matrix g = Matrix::Identity();
        g(i / 3, i % 3) += di;
        g(j / 3, j % 3) += dj;
        return point_of(law, g * f).energy;
      };
      Eigen::Matrix<double, 9, 9> hessian;
      for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j)
          hessian(i, j) =
              (energy(i, h, j, h) - energy(i, h, j, -h) - energy(i, -h, j, h) + energy(i, -h, j, -h)) / (4 * h * h);
      const double largest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>>(hessian).eigenvalues()[8];
      const double bound = point_of(law, f).bound;
      EXPECT_GE(bound, largest * (1 - 1e-3) - 1e-6) << name << trial;
      EXPECT_LE(bound, 4 * largest + 1) << name << trial;
    }
}

// Two Ogden terms are the rubber of Mooney and Rivlin without change of volume: A = μ₁/2, B = −μ₂/2.
TEST(PrincipalLaw, OgdenIsMooneyRivlinAtConstantVolume) {
  const OgdenLaw law(StretchFunction::terms({{1.1, 2}, {-0.28, -2}}), 1000);
  const InvariantLaw invariants({0.55, 0.14, 0, 0, 0, 0}, 1000);
  const Rubber rubber = mooney_rivlin(0.55, 0.14, 0.49);
  for (const double stretch : {0.5, 0.9, 1.7, 2.5}) {
    const Vector x = std::log(stretch) * Vector(1, -0.3, -0.7);
    const Matrix f = x.array().exp().matrix().asDiagonal();
    const Symmetric expected = rubber_stress(rubber, f);
    for (const PrincipalLaw* one :
         {static_cast<const PrincipalLaw*>(&law), static_cast<const PrincipalLaw*>(&invariants)}) {
      const Vector force = one->shape(x, false).force;
      EXPECT_NEAR(force[0] - force[1], expected[xx] - expected[yy], 1e-12);
      EXPECT_NEAR(force[1] - force[2], expected[yy] - expected[zz], 1e-12);
    }
  }
}

/// The lateral logarithm at which a law under uniaxial load has no lateral stress, and the axial nominal stress.
std::pair<double, double> uniaxial(const PrincipalLaw& law, double stretch) {
  const double x = std::log(stretch);
  double lateral = -x / 3;
  for (int step = 0; step < 100; ++step) {
    const Vector at(x, lateral, lateral);
    const PrincipalResponse shape = law.shape(at, false), volume = law.volume(at);
    const double slope = shape.slope(1, 1) + shape.slope(1, 2) + volume.slope(1, 1) + volume.slope(1, 2);
    lateral -= (shape.force[1] + volume.force[1]) / std::abs(slope);
  }
  const Vector at(x, lateral, lateral);
  return {lateral, (law.shape(at, false).force[0] + law.volume(at).force[0]) / stretch};
}

// The law of a test's curve gives the curve back under uniaxial load, with λ^−ν as lateral stretch.
TEST(PrincipalLaw, TabulatedLawGivesItsCurveBack) {
  const auto nominal = [](double strain) {
    return 2 * strain + 3 * strain * strain * strain + (strain < 0 ? 4 : 0) * strain;
  };
  const HillLaw foam(tabulated_stretch(nominal, 0.15), 0.15);
  const OgdenLaw rubber(tabulated_stretch(nominal, 0.5), 1e6);
  for (const double stretch : {0.35, 0.6, 0.95, 1.2, 2.0}) {
    const auto [lateral, stress] = uniaxial(foam, stretch);
    EXPECT_NEAR(lateral, -0.15 * std::log(stretch), 1e-5);
    EXPECT_NEAR(stress, nominal(stretch - 1), 1e-4 * (1 + std::abs(stress)));
    EXPECT_NEAR(uniaxial(rubber, stretch).second, nominal(stretch - 1), 3e-4 * (1 + std::abs(stress)));
  }
}

// G (λ − λ^(−1/(1−2ν)·…)): of a Blatz-Ko rubber under pure volume change J = λ³: σ = G (λ² − J^(−2n)) / J.
TEST(PrincipalLaw, BlatzKo) {
  const auto law = std::make_shared<HillLaw>(StretchFunction::terms({{1.5, 2}}), 0.463);
  const double n = 0.463 / (1 - 2 * 0.463);
  Matrix f = Matrix::Identity();
  f(0, 1) = 0.8;
  EXPECT_NEAR(point_of(law, f).stress[xy], 1.5 * 0.8, 1e-12);  // simple shear: G γ
  EXPECT_NEAR(point_of(law, f).stress[xx], 1.5 * 0.8 * 0.8, 1e-12);
  for (const double stretch : {0.9, 1.1}) {
    const double volume = stretch * stretch * stretch;
    const double expected = 1.5 / volume * (stretch * stretch - std::pow(volume, -2 * n));
    EXPECT_NEAR(point_of(law, stretch * Matrix::Identity()).stress[zz], expected, 1e-12 * std::abs(expected));
  }
}

// The foam has no lateral stress; nominal stress is Cauchy stress times the present lateral area.
TEST(PrincipalLaw, LowDensityFoam) {
  const auto law =
      std::make_shared<LowDensityFoamLaw>(Points{{0, 0}, {0.1, 0.4}, {0.6, 0.5}, {0.8, 2.5}}, 3, 0.6, false);
  const auto stress = [&](double a, double b, double c) {
    return point_of(law, Matrix(Vector(a, b, c).asDiagonal())).stress;
  };
  EXPECT_NEAR(stress(0.95, 1, 1)[xx], -0.2, 1e-13);
  EXPECT_NEAR(stress(0.65, 1, 1)[xx], -0.45, 1e-13);
  EXPECT_NEAR(stress(0.1, 1, 1)[xx], -3.5, 1e-13);  // the last slope continues
  EXPECT_NEAR(stress(0.65, 1, 1)[yy], 0, 1e-15);
  EXPECT_NEAR(stress(0.65, 0.8, 1.1)[xx], -0.45 / (0.8 * 1.1), 1e-13);
  EXPECT_NEAR(stress(1.1, 1, 1)[xx], 0.3, 1e-13);
  EXPECT_NEAR(stress(1.7, 1, 1)[xx], 0.6, 1e-13);  // TC
  EXPECT_NEAR(point_of(law, Matrix(Vector(0.4, 1, 1).asDiagonal())).energy, 0.02 + 0.5 * 0.45, 1e-13);
  EXPECT_NEAR(point_of(law, Matrix(Vector(1.7, 1, 1).asDiagonal())).energy, 0.06 + 0.5 * 0.6, 1e-13);
}

}  // namespace
}  // namespace gapcheck::solver::principal_law_test
