#include "solver/thick/thick_shell.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/thick/thick_shell_elements.hpp"

namespace gapcheck::solver::thick_shell_test {
namespace {

using Eight = std::array<Vector, 8>;

constexpr double young = 1000, poisson = 0.3;

ShellProperties properties_of(double nu = poisson, HourglassKind kind = HourglassKind::stiffness) {
  ShellProperties all;
  all.material = {MaterialKind::elastic, 2, young, nu, {}, 0, 0, 0};
  all.layers = gauss_rule(3);
  all.shear_factor = 5.0 / 6;
  all.thins = true;
  all.hourglass.kind = kind;
  return all;
}

Eight box(const Vector& size) {
  Eight x;
  const int signs[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (std::size_t k = 0; k < 8; ++k)
    x[k] = Vector(signs[k][0] * size.x(), signs[k][1] * size.y(), signs[k][2] * size.z());
  return x;
}

class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}
  Vector vector(double size) {
    std::uniform_real_distribution<double> between(-size, size);
    return {between(generator_), between(generator_), between(generator_)};
  }

 private:
  std::mt19937 generator_;
};

/// One thick shell that is moved.
struct One {
  ShellProperties properties;
  Eight x;
  ThickShellState state;
  std::vector<PointState> points;

  One(ShellProperties all, const Eight& start) : properties(std::move(all)), x(start) {
    state = begin_thick_shell(properties, start);
    points.resize(properties.layers.size());
  }
  ThickShellForces move(const Eight& v, double dt) {
    for (std::size_t k = 0; k < 8; ++k) x[k] += dt * v[k];
    return thick_shell_forces(properties, {x, v}, dt, state, points);
  }
};

// Stretched in the plane and thinned as plane stress asks: the stress of plane stress in all layers, none through it.
TEST(ThickShell, MembraneStressIsThatOfPlaneStress) {
  constexpr double dt = 1e-7;
  Eight x = box({2, 1.5, 0.4});
  One shell(properties_of(), x);
  Matrix gradient = Matrix::Zero();
  gradient.topLeftCorner<2, 2>() << 0.7, 0.2, 0.4, -0.1;
  gradient(2, 2) = -poisson / (1 - poisson) * (gradient(0, 0) + gradient(1, 1));
  Eight v;
  for (std::size_t k = 0; k < 8; ++k) v[k] = gradient * x[k];
  const ThickShellForces forces = shell.move(v, dt);
  ASSERT_TRUE(forces.good);
  for (const PointState& point : shell.points) {
    EXPECT_NEAR(point.stress[xx] / dt, young / (1 - poisson * poisson) * (0.7 - 0.1 * poisson), 1e-3);
    EXPECT_NEAR(point.stress[yy] / dt, young / (1 - poisson * poisson) * (0.7 * poisson - 0.1), 1e-3);
    EXPECT_NEAR(point.stress[xy] / dt, young / (2 + 2 * poisson) * 0.6, 1e-3);
    EXPECT_NEAR(point.stress[yz] / dt, 0, 1e-3);
  }
  for (const double pressed : shell.state.pressed) EXPECT_NEAR(pressed / dt, 0, 1e-3);
}

// A patch of four shells, in-plane irregular and with leaning fibres inside: an even strain gives no force on the inner
// nodes.
TEST(ThickShell, PatchOfFour) {
  constexpr double dt = 1e-8;
  std::vector<Vector> x;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) x.emplace_back(i, j, 0.3 * k);
  x[4] += Vector(0.2, -0.15, 0);
  x[13] += Vector(0.2, -0.15, 0);
  Matrix gradient = Matrix::Zero();
  gradient.topLeftCorner<2, 2>() << 0.7, 0.2, 0.4, -0.1;
  gradient(2, 2) = -poisson / (1 - poisson) * 0.6;
  std::vector<Vector> force(x.size(), Vector::Zero());
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const std::size_t a = static_cast<std::size_t>(i + 3 * j);
      const std::array<std::size_t, 8> nodes{a, a + 1, a + 4, a + 3, a + 9, a + 10, a + 13, a + 12};
      Eight own, v;
      for (std::size_t k = 0; k < 8; ++k) v[k] = gradient * (own[k] = x[nodes[k]]);
      One shell(properties_of(), own);
      const ThickShellForces forces = shell.move(v, dt);
      ASSERT_TRUE(forces.good);
      for (std::size_t k = 0; k < 8; ++k) force[nodes[k]] += forces.force[k];
    }
  for (const std::size_t inner : {4u, 13u}) EXPECT_NEAR(force[inner].norm() / dt, 0, 1e-4);
}

/// A warped shell with leaning fibres of different lengths.
Eight leaning(Random& random) {
  Eight x = box({1.2, 1, 0.4});
  for (std::size_t k = 0; k < 4; ++k) x[k + 4] += Vector(0.15, -0.1, 0);
  for (Vector& corner : x) corner += random.vector(0.05);
  return x;
}

TEST(ThickShell, AFullTurnTurnsTheForces) {
  Random random(5);
  for (int round = 0; round < 3; ++round) {
    One shell(properties_of(), leaning(random));
    Eight v;
    for (Vector& one : v) one = random.vector(0.05);
    (void)shell.move(v, 1);
    v.fill(Vector::Zero());  // the axes of the middle of a step of no motion
    const ThickShellForces before = shell.move(v, 1);
    const double thickness = shell.state.shell.thickness;
    ASSERT_TRUE(before.good);
    constexpr int steps = 600;
    const Vector axis = random.vector(1).normalized();
    ThickShellForces after;
    for (int step = 0; step < steps; ++step) {
      const Matrix turn = spin_rotation(2 * std::tan(std::numbers::pi / steps) * axis);
      for (std::size_t k = 0; k < 8; ++k) v[k] = turn * shell.x[k] - shell.x[k];
      after = shell.move(v, 1);
    }
    double size = 0;
    for (std::size_t k = 0; k < 8; ++k) size = std::max(size, before.force[k].norm());
    for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR((after.force[k] - before.force[k]).norm() / size, 0, 1e-8);
    EXPECT_NEAR(shell.state.shell.thickness, thickness, 1e-10);
  }
}

TEST(ThickShell, ForcesAndMomentsBalance) {
  Random random(7);
  for (int round = 0; round < 20; ++round) {
    One shell(properties_of(), leaning(random));
    Eight v;
    for (Vector& one : v) one = random.vector(1e-3);
    const ThickShellForces forces = shell.move(v, 1);
    ASSERT_TRUE(forces.good);
    Vector sum = Vector::Zero(), moment = Vector::Zero();
    for (std::size_t k = 0; k < 8; ++k) {
      sum += forces.force[k];
      moment += shell.x[k].cross(forces.force[k]);
    }
    EXPECT_NEAR(sum.norm(), 0, 1e-12);
    EXPECT_NEAR(moment.norm(), 0, 1e-10);
  }
}

TEST(ThickShell, StoredEnergyIsTheWork) {
  Random random(9);
  ShellProperties properties = properties_of();
  properties.shear_factor = 1;  // it is on the resultants alone
  One shell(properties, leaning(random));
  Eight v;
  for (Vector& one : v) one = random.vector(1);
  const ThickShellForces forces = shell.move(v, 1e-7);
  double work = 0;
  for (std::size_t k = 0; k < 8; ++k) work += 1e-7 / 2 * forces.force[k].dot(v[k]);
  EXPECT_NEAR(stored_energy(shell.properties, shell.state, shell.x, shell.points) / work, 1, 1e-5);
}

/// ∂force / ∂position at rest, 24 x 24.
Eigen::MatrixXd stiffness(const ShellProperties& properties, const Eight& x) {
  Eigen::MatrixXd matrix(24, 24);
  for (int column = 0; column < 24; ++column) {
    One shell(properties, x);
    Eight v;
    v.fill(Vector::Zero());
    v[static_cast<std::size_t>(column / 3)][column % 3] = 1;
    const ThickShellForces forces = thick_shell_forces(properties, {x, v}, 1e-8, shell.state, shell.points);
    for (std::size_t k = 0; k < 8; ++k) matrix.block<3, 1>(3 * static_cast<int>(k), column) = forces.force[k] / 1e-8;
  }
  return matrix;
}

TEST(ThickShell, StableStepBoundsTheHighestFrequency) {
  Random random(13);
  double worst = 1e9;
  for (const double thickness : {0.05, 0.4, 2.0})
    for (int round = 0; round < 30; ++round) {
      Eight x = box({1.2, 1, thickness});
      if (round > 0)
        for (std::size_t k = 0; k < 4; ++k) x[k + 4] += Vector(0.3, -0.2, 0) * thickness;
      if (round > 0)
        for (Vector& corner : x) corner += random.vector(0.1 * std::min(thickness, 1.0));
      One shell(properties_of(), x);
      Eight v;
      v.fill(Vector::Zero());
      const ThickShellForces forces = shell.move(v, 0);
      ASSERT_TRUE(forces.good);
      const Eigen::MatrixXd k = stiffness(shell.properties, x);
      EXPECT_NEAR((k - k.transpose()).norm() / k.norm(), 0, 1e-4);
      const Eigen::VectorXd values =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>((k + k.transpose()) / 2).eigenvalues();
      const double exact = 2 / std::sqrt(values[23] / (shell.state.mass / 8));
      EXPECT_LE(forces.stable_step, exact * (1 + 1e-4)) << thickness << " " << round;
      worst = std::min(worst, forces.stable_step / exact);
      if (round == 0 && thickness > 0.1) {
        EXPECT_GT(values[7], 1e-6 * values[23]) << "rigid motions and one twist have no stiffness";
      }
    }
  EXPECT_GT(worst, 0.2);
}

/// Tip of a strip of n shells under an end force, over that of the beam with shear.
double tip(int n, double thickness) {
  constexpr double length = 10;
  const ShellProperties properties = properties_of(0);
  const int nodes = 4 * (n + 1);  // per station: lower y = 0, 1; upper y = 0, 1
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
  const Eigen::MatrixXd own = stiffness(properties, box({length / n, 1, thickness}));
  for (int e = 0; e < n; ++e) {
    const int a = 4 * e, b = 4 * (e + 1);
    const std::array<int, 8> at{a, b, b + 1, a + 1, a + 2, b + 2, b + 3, a + 3};
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 24; ++j)
        matrix(3 * at[static_cast<std::size_t>(i / 3)] + i % 3, 3 * at[static_cast<std::size_t>(j / 3)] + j % 3) +=
            (own(i, j) + own(j, i)) / 2;
  }
  for (int i = 0; i < 12; ++i) matrix(i, i) += 1e9;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * nodes);
  for (int k = 0; k < 4; ++k) load[3 * (4 * n + k) + 2] = 0.25;
  const Eigen::VectorXd u = matrix.ldlt().solve(load);
  const double bending = std::pow(length, 3) / (3 * young * std::pow(thickness, 3) / 12),
               shear = length / (5.0 / 6 * young / 2 * thickness);
  return load.dot(u) / (bending + shear);
}

TEST(ThickShell, CantileverConvergesWithSecondOrder) {
  for (const double thickness : {0.2, 1.0}) {
    const double coarse = 1 - tip(4, thickness), fine = 1 - tip(8, thickness), finest = 1 - tip(16, thickness);
    RecordProperty(thickness < 1 ? "thin" : "thick", fmt::format("{:.2g}", finest));
    EXPECT_NEAR(fine, 1.0 / (4 * 64), 2e-3);
    EXPECT_NEAR(coarse / fine, 4, 0.3) << thickness;
    EXPECT_NEAR(fine / finest, 4, 0.3) << thickness;
  }
}

}  // namespace
}  // namespace gapcheck::solver::thick_shell_test
