#include "solver/material/rubber.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

namespace gapcheck::solver::rubber_test {
namespace {

constexpr double a = 0.55, b = 0.14;

Matrix random_gradient(std::mt19937& engine, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  Matrix f;
  do
    for (int i = 0; i < 9; ++i) f(i / 3, i % 3) = (i % 4 == 0 ? 1 : 0) + number(engine);
  while (f.determinant() < 0.2);
  return f;
}

// σ = J⁻¹ ∂W/∂F Fᵀ.
TEST(Rubber, StressIsTheSlopeOfTheEnergy) {
  std::mt19937 engine(7);
  for (const double nu : {0.0, 0.3, 0.495}) {
    const Rubber rubber = mooney_rivlin(a, b, nu);
    for (int trial = 0; trial < 50; ++trial) {
      const Matrix f = random_gradient(engine, 0.5);
      Matrix slope;
      constexpr double h = 1e-5;
      for (int i = 0; i < 9; ++i) {
        Matrix up = f, down = f;
        up(i / 3, i % 3) += h;
        down(i / 3, i % 3) -= h;
        slope(i / 3, i % 3) = (rubber_energy(rubber, up) - rubber_energy(rubber, down)) / (2 * h);
      }
      const Matrix expected = slope * f.transpose() / f.determinant();
      EXPECT_NEAR((to_matrix(rubber_stress(rubber, f)) - expected).norm(), 0, 1e-6 * (1 + expected.norm())) << nu;
    }
  }
}

// Small strains: G = 2 (A + B), K = 2 G (1 + ν) / (3 (1 − 2ν)), no stress and no energy at rest.
TEST(Rubber, SmallStrains) {
  constexpr double e = 1e-8;  // the curvature of W is some hundred times its slope
  for (const double nu : {-0.2, 0.0, 0.3, 0.495}) {
    const Rubber rubber = mooney_rivlin(a, b, nu);
    const double shear = 2 * (a + b), bulk = 2 * shear * (1 + nu) / (3 * (1 - 2 * nu));
    EXPECT_EQ(rubber_energy(rubber, Matrix::Identity()), 0);
    for (const double s : rubber_stress(rubber, Matrix::Identity())) EXPECT_NEAR(s, 0, 1e-15);
    Matrix sheared = Matrix::Identity(), grown = (1 + e) * Matrix::Identity();
    sheared(0, 1) = e;
    EXPECT_NEAR(rubber_stress(rubber, sheared)[xy], shear * e, 1e-5 * shear * e) << nu;
    EXPECT_NEAR(rubber_stress(rubber, grown)[xx], 3 * bulk * e, 1e-4 * bulk * e) << nu;
  }
}

// Without change of volume the pressure is free, and σ₁ − σ₃ = 2 (λ² − 1/λ) (A + B/λ) in uniaxial tension, γ 2 (A + B)
// in simple shear (Mooney 1940; Rivlin 1948).
TEST(Rubber, ConstantVolume) {
  const Rubber rubber = mooney_rivlin(a, b, 0.49);
  for (const double stretch : {0.4, 0.8, 1.5, 3.0}) {
    Matrix f = Matrix::Zero();
    f.diagonal() << stretch, 1 / std::sqrt(stretch), 1 / std::sqrt(stretch);
    const Symmetric stress = rubber_stress(rubber, f);
    const double expected = 2 * (stretch * stretch - 1 / stretch) * (a + b / stretch);
    EXPECT_NEAR(stress[xx] - stress[zz], expected, 1e-12 * (1 + std::abs(expected)));
  }
  Matrix f = Matrix::Identity();
  f(0, 1) = 1.7;
  EXPECT_NEAR(rubber_stress(rubber, f)[xy], 1.7 * 2 * (a + b), 1e-12);
}

// A turn of the axes turns the stress.
TEST(Rubber, TurnsWithTheBody) {
  std::mt19937 engine(3);
  const Rubber rubber = mooney_rivlin(a, b, 0.45);
  const Matrix f = random_gradient(engine, 0.4), turn = spin_rotation(Vector(0.3, -1.1, 0.7));
  const Symmetric expected = rotated(rubber_stress(rubber, f), turn), stress = rubber_stress(rubber, turn * f);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(stress[i], expected[i], 1e-12 * std::abs(trace(expected)));
}

// Against the largest eigenvalue of ∂²W/∂g² by differences; near its tightest without deformation.
TEST(Rubber, StiffnessBound) {
  std::mt19937 engine(11);
  for (const double nu : {0.0, 0.3, 0.49}) {
    const Rubber rubber = mooney_rivlin(a, b, nu);
    for (int trial = 0; trial < 60; ++trial) {
      const Matrix f = trial == 0 ? Matrix(Matrix::Identity()) : random_gradient(engine, 0.6);
      constexpr double h = 1e-4;
      const auto energy = [&](int i, double di, int j, double dj) {
        Matrix g = Matrix::Identity();
        g(i / 3, i % 3) += di;
        g(j / 3, j % 3) += dj;
        return rubber_energy(rubber, g * f);
      };
      Eigen::Matrix<double, 9, 9> hessian;
      for (int i = 0; i < 9; ++i)
        for (int j = 0; j < 9; ++j)
          hessian(i, j) =
              (energy(i, h, j, h) - energy(i, h, j, -h) - energy(i, -h, j, h) + energy(i, -h, j, -h)) / (4 * h * h);
      const double largest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>>(hessian).eigenvalues()[8];
      const double bound = rubber_stiffness_bound(rubber, f);
      EXPECT_GE(bound, largest * (1 - 1e-5)) << nu;
      if (trial == 0 && nu == 0.49) {
        EXPECT_LE(bound, 1.2 * largest);
        EXPECT_NEAR(largest, 3 * 4 * (a + b) * 1.49 / (3 * 0.02), 1e-3 * largest);  // 3 K
      }
    }
  }
}

}  // namespace
}  // namespace gapcheck::solver::rubber_test
