#include "solver/material/finite_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gapcheck::solver::finite_law_test {
namespace {

using Points = std::vector<std::array<double, 2>>;

/// A foam with the stress 2 ε in compression.
FiniteLaw linear_foam(bool tears = false) {
  FiniteLaw law;
  law.elastic = std::make_shared<LowDensityFoamLaw>(Points{{0, 0}, {1, 2}}, 3, tears ? 0.6 : 1e20, tears);
  return law;
}

/// Compresses along x step by step; turns the axes along the way.
struct Specimen {
  FiniteLaw law;
  FiniteHistory history;
  FinitePoint point;
  double strain = 0, work = 0, stress = 0;  ///< nominal, compression positive

  void go(double to, double time, int steps = 2000) {
    const double from = strain;
    for (int i = 1; i <= steps; ++i) {
      const double before = strain, before_stress = stress;
      strain = from + (to - from) * i / steps;
      Matrix gradient = Matrix::Zero();
      gradient(0, 0) = time > 0 ? -(strain - before) / (1 - (strain + before) / 2) / (time / steps) : 0;
      const Matrix f = Matrix(Vector(1 - strain, 1, 1).asDiagonal());
      point = update_finite(law, f, gradient, time / steps, history);
      stress = -point.stress[xx];
      work += (strain - before) * (stress + before_stress) / 2;
    }
  }
};

// Unloading follows σ (HU + (1 − HU) (W/W_max)^SHAPE); a loop takes W_max (1 − HU) SHAPE / (SHAPE + 1); reloading
// follows the unloading path up to W_max.
TEST(FiniteLaw, Hysteresis) {
  for (const double shape : {0.5, 1.0, 3.0}) {
    Specimen one{linear_foam(), {}, {}};
    one.law.unloading = 0.2;
    one.law.shape = shape;
    one.go(0.5, 0);
    EXPECT_NEAR(one.stress, 1, 1e-12);
    EXPECT_NEAR(one.work, 0.25, 1e-9);
    one.go(0.3, 0);
    EXPECT_NEAR(one.stress, 0.6 * (0.2 + 0.8 * std::pow(0.36, shape)), 1e-12);
    one.go(0.4, 0);
    EXPECT_NEAR(one.stress, 0.8 * (0.2 + 0.8 * std::pow(0.64, shape)), 1e-12);
    const double lost = 0.25 * 0.8 * shape / (shape + 1);
    EXPECT_NEAR(one.point.energy + one.history.lost, one.work, 1e-6);
    one.go(0, 0);
    EXPECT_NEAR(one.work, lost, 1e-5);
    EXPECT_NEAR(one.history.lost, lost, 1e-12);
    EXPECT_NEAR(one.point.energy, 0, 1e-12);
  }
}

// With BETA the law heals: after a time t at a small strain W_max is W + (W_max − W) exp(−BETA t).
TEST(FiniteLaw, Healing) {
  Specimen one{linear_foam(), {}, {}};
  one.law.unloading = 0.2;
  one.law.healing = 2;
  one.go(0.5, 0);
  one.go(0.3, 0);
  one.go(0.3, 0.7);
  const double most = 0.09 + 0.16 * std::exp(-1.4);
  EXPECT_NEAR(one.stress, 0.6 * (0.2 + 0.8 * 0.09 / most), 1e-9);
}

// A Maxwell branch under constant engineering rate of 1D: it is driven by the true rate; at rest it decays.
TEST(FiniteLaw, MaxwellBranch) {
  Specimen one{linear_foam(), {}, {}};
  one.law.branch_modulus = 5;
  one.law.branch_decay = 3;
  constexpr double rate = 1e-3, time = 1;  // so small that strains are the same
  one.go(rate * time, time);
  const double relaxing = 5 * rate * (1 - std::exp(-3.0)) / 3;
  EXPECT_NEAR(one.stress, 2 * rate + relaxing, 1e-3 * relaxing);
  one.go(rate * time, 0.5);
  EXPECT_NEAR(one.stress, 2 * rate + relaxing * std::exp(-1.5), 1e-3 * relaxing);
  EXPECT_NEAR(one.work - one.point.energy - one.history.lost, 0, 1e-3 * one.work);
}

// FAIL = 1: beyond TC there is no tension any more, but compression as before; what it held is lost.
TEST(FiniteLaw, TearsOnce) {
  Specimen one{linear_foam(true), {}, {}};
  one.go(-0.19, 0);
  EXPECT_NEAR(one.stress, -0.57, 1e-12);
  one.go(-0.3, 0);
  EXPECT_EQ(one.stress, 0);
  EXPECT_NEAR(one.history.lost, 0.06, 1e-3);
  one.go(-0.1, 0);
  EXPECT_EQ(one.stress, 0);
  one.go(0.4, 0);
  EXPECT_NEAR(one.stress, 0.8, 1e-12);
}

}  // namespace
}  // namespace gapcheck::solver::finite_law_test
