// The stable step of warped quads with four points against all eigenvalues of their stiffness by finite differences.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "solver/element/shell_stiffness.hpp"

namespace gapcheck::solver::warped_frequency_test {
namespace {

constexpr double poisson = 0.3;

OneShell shell_of(double young, double density, double thickness) {
  ShellProperties properties;
  properties.material = elastic_material(young, poisson, density);
  properties.hourglass.kind = HourglassKind::none;
  properties.shear_factor = 5.0 / 6;
  properties.form = ShellForm::full;
  return {std::move(properties), thickness, full_forces};
}

OneShell steel() { return shell_of(210, 7.85e-6, 1.5); }

/// 2 / the highest frequency of the free shell.
double exact_step(const OneShell& shell, const std::array<Vector, 4>& x, double dt = 1e-8) {
  const Eigen::MatrixXd k = shell_stiffness(shell, x, dt);
  const double thickness = shell.state.thickness, area = shell_area(x);
  const double share = shell.properties.material.density * area * thickness / 4;
  Eigen::VectorXd root(24);
  for (int i = 0; i < 24; ++i)
    root[i] = 1 / std::sqrt(share * (i % 6 < 3 ? 1 : shell.properties.inertia(area, thickness)));
  const Eigen::MatrixXd scaled = root.asDiagonal() * (k + k.transpose()) / 2 * root.asDiagonal();
  return 2 / std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues()[23]);
}

double bound(OneShell shell, const std::array<Vector, 4>& x) { return shell.step(at_rest(x), 0).stable_step; }

std::array<Vector, 4> square(double side, double warp) {
  return {Vector(0, 0, warp), {side, 0, -warp}, {side, side, warp}, {0, side, -warp}};
}

/// Quads of sides 1 : 1 to 6 : 1 with corners moved in their plane and out of it.
class WarpedShapes {
 public:
  std::array<Vector, 4> next(double flat, double warp) {
    const double aspect = std::pow(6, std::abs(number()));
    std::array<Vector, 4> x = square(1, warp * number());
    for (Vector& corner : x) {
      corner += Vector(flat * number(), flat * number(), warp / 4 * number());
      corner.x() *= aspect;
    }
    return x;
  }
  double number() { return number_(random_); }

 private:
  std::mt19937 random_{11};
  std::uniform_real_distribution<double> number_{-1, 1};
};

// Corners of a 5 mm square at ± 1 and ± 3 mm, ms, steel.
TEST(WarpedFrequency, SquareOfSteel) {
  for (const double warp : {0.0, 1.0, 3.0}) {
    const OneShell shell = steel();
    const double exact = exact_step(shell, square(5, warp)), own = bound(shell, square(5, warp));
    RecordProperty(fmt::format("share_of_the_exact_step_{:.0f}_mm", warp), fmt::format("{:.3f}", own / exact));
    EXPECT_LE(own, exact * (1 + 1e-9));
    EXPECT_GE(own, 0.88 * exact) << warp << ": " << own << " of " << exact;
  }
}

TEST(WarpedFrequency, NeverAboveTheExactStepAndCloseToIt) {
  WarpedShapes shapes;
  double least = 1, most = 0;
  int tried = 0;
  for (int trial = 0; trial < 800; ++trial) {
    const std::array<Vector, 4> x = shapes.next(trial % 2 == 0 ? 0.05 : 0.25, trial % 3 == 0 ? 0.6 : 0.2);
    const OneShell shell = shell_of(1000, 1, std::array{0.02, 0.2, 1.0}[static_cast<std::size_t>(trial % 3)]);
    if (!OneShell(shell).step(at_rest(x), 0).good) continue;  // not convex
    ++tried;
    const double share = bound(shell, x) / exact_step(shell, x);
    EXPECT_LE(share, 1 + 1e-7) << trial;
    EXPECT_GE(share, 0.8) << trial;
    least = std::min(least, share);
    most = std::max(most, share);
  }
  EXPECT_GT(tried, 600);
  RecordProperty("least_share_of_the_exact_step", fmt::format("{:.3f}", least));
  RecordProperty("largest_share_of_the_exact_step", fmt::format("{:.3f}", most));
}

// What is kept while the shape changes a little still is a bound.
TEST(WarpedFrequency, KeptBoundsHold) {
  WarpedShapes shapes;
  for (int trial = 0; trial < 100; ++trial) {
    std::array<Vector, 4> x = shapes.next(0.2, 0.6), way;
    for (Vector& w : way) w = Vector(shapes.number(), shapes.number(), shapes.number());
    OneShell shell = shell_of(1000, 1, trial % 2 == 0 ? 0.02 : 0.4);
    for (int step = 0; step < 60; ++step) {
      for (std::size_t i = 0; i < 4; ++i) x[i] += 5e-4 * way[i];
      const ShellForces forces = shell.step(at_rest(x), 0);
      if (!forces.good) break;
      EXPECT_LE(forces.stable_step, exact_step(shell_of(1000, 1, shell.state.thickness), x) * (1 + 1e-7)) << trial;
    }
  }
}

// One point of a warped quad is about to fold over: its step, the exact one too, falls with the power 3/2 of the
// Jacobian there.
TEST(WarpedFrequency, NearlyFoldedOver) {
  for (const double in : {0.45, 0.37, 0.367, 0.3661, 0.36604}) {
    const OneShell shell = steel();
    std::array<Vector, 4> x = square(5, 1);
    x[2].x() = x[2].y() = 5 * in;
    const ShellForces forces = OneShell(shell).step(at_rest(x), 0);
    ASSERT_TRUE(forces.good) << in;
    const double exact = exact_step(shell, x, 1e-10);
    EXPECT_LE(forces.stable_step, exact * (1 + 1e-6));
    EXPECT_GE(forces.stable_step, 0.8 * exact) << in << ": " << forces.stable_step << " of " << exact;
    RecordProperty(fmt::format("step_{:g}", in), fmt::format("{:.3g}", forces.stable_step));
  }
}

// A shell that allows much more than the last step keeps its cheap bound, one that may limit the step gets the sharp
// one.
TEST(WarpedFrequency, SharpWhereItMayLimitTheStep) {
  const std::array<Vector, 4> x = square(5, 3);
  OneShell shell = steel();
  const double sharp = bound(shell, x), cheap = shell.step(at_rest(x), 1e-9).stable_step;
  EXPECT_LT(cheap, 0.7 * sharp);
  EXPECT_EQ(shell.step(at_rest(x), cheap / 1.06).stable_step, cheap);
  EXPECT_EQ(shell.step(at_rest(x), cheap / 1.04).stable_step, sharp);
}

// Reference surface off the nodes, and plies: bounds, too.
TEST(WarpedFrequency, NodesOffTheMiddle) {
  WarpedShapes shapes;
  for (int trial = 0; trial < 100; ++trial) {
    const std::array<Vector, 4> x = shapes.next(0.2, 0.6);
    OneShell shell = shell_of(1000, 1, 0.3);
    shell.properties.reference = trial % 2 == 0 ? 1 : -0.5;
    if (!OneShell(shell).step(at_rest(x), 0).good) continue;
    EXPECT_LE(bound(shell, x), exact_step(shell, x) * (1 + 1e-7)) << trial;
  }
}

}  // namespace
}  // namespace gapcheck::solver::warped_frequency_test
