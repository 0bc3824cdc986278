// One solid with eight points: ELFORM 2, -1, -2 and 15.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "solver/element/solid_stiffness.hpp"

namespace gapcheck::solver::solid_eight_test {
namespace {

constexpr double young = 1000;
constexpr SolidRule all_rules[] = {SolidRule::eight_points, SolidRule::efficient, SolidRule::accurate,
                                   SolidRule::wedge};

Bricks stretched(const Vector& by) {
  Bricks x = brick_of_unit_size;
  for (Vector& corner : x) corner = corner.cwiseProduct(by);
  return x;
}

/// The wedge whose corners 4, 5 and 6, 7 are one.
Bricks as_wedge(Bricks x) {
  x[4] = x[5] = (x[4] + x[5]) / 2;
  x[6] = x[7] = (x[6] + x[7]) / 2;
  return x;
}

Bricks shape_of(SolidRule rule, const Bricks& x) { return rule == SolidRule::wedge ? as_wedge(x) : x; }

/// An independent twin of ELFORM 2, -1 and the wedge in small strains: ∂N/∂x of every corner at every point, the 6 x 24
/// matrix of Hughes with the volume part averaged, and its product with the elastic one.
Eigen::MatrixXd slow_stiffness(SolidRule rule, const Bricks& x, double nu) {
  constexpr int signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                               {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  Eigen::Matrix<double, 8, 3> corners;
  for (int a = 0; a < 8; ++a) corners.row(a) = x[static_cast<std::size_t>(a)];
  Eigen::Matrix<double, 8, 3> centre;
  for (int a = 0; a < 8; ++a)
    for (int j = 0; j < 3; ++j) centre(a, j) = signs[a][j] / 8.0;
  const Matrix sides = corners.transpose() * centre;
  std::array<Eigen::Matrix<double, 8, 3>, 8> exact, scaled;
  std::array<double, 8> volume{};
  for (std::size_t p = 0; p < 8; ++p) {
    Eigen::Matrix<double, 8, 3> full, reduced;
    for (int a = 0; a < 8; ++a)
      for (int j = 0; j < 3; ++j) {
        const int k = (j + 1) % 3, l = (j + 2) % 3;
        const double s = signs[p][k] / std::sqrt(3.0), t = signs[p][l] / std::sqrt(3.0);
        full(a, j) = signs[a][j] * (1 + signs[a][k] * s) * (1 + signs[a][l] * t) / 8;
        const auto ratio = [&](int other) { return std::min(1.0, sides.col(j).norm() / sides.col(other).norm()); };
        const double ks = rule == SolidRule::efficient ? ratio(k) : 1, kt = rule == SolidRule::efficient ? ratio(l) : 1;
        reduced(a, j) = signs[a][j] * (1 + signs[a][k] * s * ks) * (1 + signs[a][l] * t * kt) / 8;
      }
    const Matrix jacobian = corners.transpose() * full, other = corners.transpose() * reduced;
    volume[p] = jacobian.determinant();
    exact[p] = full * jacobian.inverse();
    scaled[p] = reduced * other.inverse();
  }
  double total = 0;
  for (const double v : volume) total += v;
  Eigen::Matrix<double, 8, 3> mean = Eigen::Matrix<double, 8, 3>::Zero(), mean_scaled = mean;
  for (std::size_t p = 0; p < 8; ++p) {
    mean += volume[p] / total * exact[p];
    mean_scaled += volume[p] / total * scaled[p];
  }
  Eigen::Matrix<double, 6, 6> elastic = Eigen::Matrix<double, 6, 6>::Zero();
  const double shear = young / (2 * (1 + nu)), lame = young * nu / ((1 + nu) * (1 - 2 * nu));
  elastic.topLeftCorner<3, 3>().setConstant(lame);
  for (int i = 0; i < 6; ++i) elastic(i, i) += i < 3 ? 2 * shear : shear;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(24, 24);
  for (std::size_t p = 0; p < 8; ++p) {
    const Eigen::Matrix<double, 8, 3> g = scaled[p] + mean - mean_scaled;
    Eigen::Matrix<double, 6, 24> b = Eigen::Matrix<double, 6, 24>::Zero();
    for (int a = 0; a < 8; ++a)
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        b(i, 3 * a + i) += g(a, i);
        b(3 + i, 3 * a + i) += g(a, j);
        b(3 + i, 3 * a + j) += g(a, i);
        for (int row = 0; row < 3; ++row) b(row, 3 * a + i) += (mean(a, i) - g(a, i)) / 3;
      }
    stiffness += volume[p] * b.transpose() * elastic * b;
  }
  return stiffness;
}

TEST(SolidEight, StiffnessIsThatOfTheSlowTwin) {
  BrickRandom random(4);
  for (const SolidRule rule : {SolidRule::eight_points, SolidRule::efficient, SolidRule::wedge})
    for (int trial = 0; trial < 10; ++trial) {
      const Bricks x = shape_of(rule, random.moved(stretched({1, 2, trial < 5 ? 1.0 : 6.0}), 0.2));
      const double nu = trial % 2 == 0 ? 0.3 : 0.499;
      const Eigen::MatrixXd fast = brick_stiffness({elastic_eight(young, nu), rule, x}, x),
                            slow = slow_stiffness(rule, x, nu);
      EXPECT_LT((fast - slow).norm(), 1e-6 * slow.norm()) << trial;
    }
}

// In a box the terms of ELFORM -2 are known: true strains have their full gradients, shear the scaled ones. The
// energies of the modes ξη, ηζ, ζξ and ξηζ by hand, of each component; ELFORM 2 with κ = 1.
TEST(SolidEight, EnergiesOfTheModesOfABox) {
  const Vector sides(3, 1, 0.1);
  const Bricks x = stretched(sides);
  const double nu = 0.3, shear = young / (2 * (1 + nu)), volume = sides.prod();
  constexpr int signs[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                               {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  for (const SolidRule rule : all_rules) {
    if (rule == SolidRule::wedge) continue;
    const Eigen::MatrixXd stiffness = brick_stiffness({elastic_eight(young, nu), rule, x}, x);
    const auto ratio = [&](int j, int k) {
      return rule == SolidRule::eight_points ? 1 : std::min(1.0, sides[j] / sides[k]);
    };
    for (int m = 0; m < 4; ++m)
      for (int i = 0; i < 3; ++i) {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
        for (int a = 0; a < 8; ++a) {
          const int *s = signs[a], all = s[0] * s[1] * s[2];
          u(3 * a + i) = m == 3 ? all : all * s[m];
        }
        // Mean squares of ∂u/∂x, ∂u/∂y and ∂u/∂z: (2 / side)² times 1/3 for each other coordinate in the mode.
        double energy = 0;
        for (int j = 0; j < 3; ++j) {
          if (j == m) continue;
          double square = 4 / (sides[j] * sides[j]);
          for (int k = 0; k < 3; ++k)
            if (k != j && k != m) square *= (rule == SolidRule::accurate && i == j ? 1 : std::pow(ratio(j, k), 2)) / 3;
          // σ : ε of a lone uᵢ,ⱼ without its volume part: 2 G (2/3) along, G across.
          energy += volume * (i == j ? 4 * shear / 3 : shear) * square;
        }
        EXPECT_NEAR(u.dot(stiffness * u), energy, 1e-6 * energy) << m << i << static_cast<int>(rule);
      }
  }
}

// Bending about z of a bar of sides l, h: u = ξη has the stiffness E' = 4 G / 3 of a strain without volume, and the
// shear energy adds G (l / h)²: 1 : 20 is 139 times too stiff. ELFORM -1 and -2 add G only, whatever the ratio.
TEST(SolidEight, ShearLocksInLongBricksUnlessScaled) {
  for (const double length : {1.0, 10.0, 20.0, 50.0}) {
    const Bricks x = stretched({length, 1, 1});
    const double nu = 0.3, shear = young / (2 * (1 + nu));
    for (const SolidRule rule : {SolidRule::eight_points, SolidRule::efficient, SolidRule::accurate}) {
      const Eigen::MatrixXd stiffness = brick_stiffness({elastic_eight(young, nu), rule, x}, x);
      Eigen::VectorXd u = Eigen::VectorXd::Zero(24);
      for (int a = 0; a < 8; ++a) {
        const Vector& c = x[static_cast<std::size_t>(a)];
        u(3 * a) = (2 * c.x() / length - 1) * (2 * c.y() - 1);
      }
      // ε = (2 / l) η: E' A (2 / l)² / 3 with A l the volume.
      const double modulus = u.dot(stiffness * u) / (length * 4 / (length * length) / 3);
      const double locked = rule == SolidRule::eight_points ? length * length : 1;
      EXPECT_NEAR(modulus / (4 * shear / 3 + shear * locked), 1, 1e-6) << length;
      if (rule == SolidRule::eight_points)
        EXPECT_GE(modulus / young, length < 10 ? 0.8 : 0.38 * length * length);
      else
        EXPECT_NEAR(modulus / young, 0.897, 0.001);
    }
  }
}

// Six motions without strain and no others. ELFORM -1 is soft in u_z = ξζ of flat bricks: (h / l)² of ELFORM 2.
TEST(SolidEight, NoOtherModeIsFree) {
  BrickRandom random(8);
  for (const SolidRule rule : all_rules)
    for (int trial = 0; trial < 6; ++trial) {
      const Bricks x = shape_of(rule, random.moved(brick_of_unit_size, 0.2));
      Eigen::MatrixXd stiffness = brick_stiffness({elastic_eight(young, 0.3), rule, x}, x);
      EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-6 * stiffness.norm());
      stiffness = (stiffness + stiffness.transpose()) / 2;
      const int free = rule == SolidRule::wedge ? 12 : 6;  // two corners move against their twins
      Eigen::MatrixXd joined = stiffness;
      if (rule == SolidRule::wedge) {
        Eigen::MatrixXd same = Eigen::MatrixXd::Zero(24, 18);
        constexpr int node[8] = {0, 1, 2, 3, 4, 4, 5, 5};
        for (int a = 0; a < 8; ++a) same.block<3, 3>(3 * a, 3 * node[a]).setIdentity();
        joined = same.transpose() * stiffness * same;
      }
      const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(joined).eigenvalues();
      EXPECT_NEAR(values[5] / young, 0, 1e-6);
      EXPECT_GT(values[6] / young, 0.005) << static_cast<int>(rule) << free;
    }
}

TEST(SolidEight, RigidRotationIsFree) {
  const Vector axis = Vector(0.3, -1, 0.6).normalized();
  constexpr int steps = 100;
  const Matrix turn = Eigen::AngleAxisd(2 * std::numbers::pi / steps, axis).toRotationMatrix();
  for (const SolidRule rule : all_rules) {
    BrickRandom random(5);
    const Bricks start = shape_of(rule, random.moved(stretched({1, 1, 0.3}), 0.08));
    EightPoints solid(elastic_eight(young, 0.3), rule, start);
    Bricks x = shape_of(rule, random.moved(start, 0.01));
    const SolidForces first = solid.move(start, x);
    ASSERT_TRUE(first.good) << static_cast<int>(rule);
    const std::array<PointState, 8> points = solid.points;
    for (int step = 0; step < steps; ++step) {
      Bricks next;
      for (std::size_t a = 0; a < 8; ++a) next[a] = turn * x[a];
      const SolidForces forces = solid.move(x, next);
      x = next;
      if (step != steps / 4 - 1) continue;
      const Matrix quarter = Eigen::AngleAxisd(std::numbers::pi / 2, axis).toRotationMatrix();
      for (std::size_t p = 0; p < 8; ++p)
        for (std::size_t c = 0; c < 6; ++c)
          EXPECT_NEAR(solid.points[p].stress[c], rotated(points[p].stress, quarter)[c], 1e-10);
      for (std::size_t a = 0; a < 8; ++a)
        EXPECT_NEAR((forces.force[a] - quarter * first.force[a]).norm(), 0, 1e-11) << first.force[a].norm();
    }
    for (std::size_t p = 0; p < 8; ++p)
      for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(solid.points[p].stress[c], points[p].stress[c], 1e-10);
  }
}

TEST(SolidEight, ForcesAreInBalance) {
  BrickRandom random(9);
  for (int trial = 0; trial < 30; ++trial)
    for (const SolidRule rule : all_rules)
      for (const bool rubber : {false, true}) {
        if (rubber && rule == SolidRule::accurate) continue;
        const Bricks start = shape_of(rule, random.moved(stretched({1, 1, 0.5}), 0.1));
        SolidProperties properties = elastic_eight(young, 0.3);
        properties.linear_viscosity = 0.06;
        properties.quadratic_viscosity = 1.5;
        if (rubber) {
          properties.material.kind = MaterialKind::rubber;
          properties.material.rubber = mooney_rivlin(100, 50, 0.45);
        }
        EightPoints solid(properties, rule, start);
        const Bricks x = shape_of(rule, random.moved(start, 0.05));
        const SolidForces forces = solid.move(start, x);
        ASSERT_TRUE(forces.good) << trial << static_cast<int>(rule);
        Vector force = Vector::Zero(), moment = Vector::Zero();
        double size = 0;
        for (std::size_t a = 0; a < 8; ++a) {
          force += forces.force[a];
          moment += x[a].cross(forces.force[a]);
          size += forces.force[a].norm();
        }
        EXPECT_LT(force.norm(), 1e-13 * size);
        EXPECT_LT(moment.norm(), 1e-12 * size);
        EXPECT_GT(size, 1);
      }
}

// The bound of the step holds for the exact highest frequency of shapes of all kinds, and is not far from it. Wedges
// with the masses of six corners.
TEST(SolidEight, StableStepIsABound) {
  BrickRandom random(21);
  double worst = 1, best = 0;
  for (int trial = 0; trial < 400; ++trial)
    for (const SolidRule rule : all_rules) {
      const Vector sides(1, std::pow(10, -std::abs(random.number(2))), std::pow(10, -std::abs(random.number(2))));
      Bricks x = brick_of_unit_size;
      if (trial > 0) x = random.moved(x, 0.25);
      if (trial > 1)
        for (Vector& corner : x) corner = corner.cwiseProduct(sides);
      x = shape_of(rule, x);
      const double nu = trial % 2 == 0 ? 0.3 : trial % 3 == 0 ? 0 : 0.49;
      const EightPoints solid(elastic_eight(young, nu), rule, x);
      if (!brick_map(rule, brick_modes(x)).good) continue;
      Eigen::MatrixXd stiffness = brick_stiffness(solid, x);
      stiffness = (stiffness + stiffness.transpose()) / 2;
      for (int row = 0; row < 24; ++row)
        for (int column = 0; column < 24; ++column) {
          const auto share = [&](int freedom) { return rule != SolidRule::wedge ? 8 : freedom < 12 ? 6 : 12; };
          stiffness(row, column) *= std::sqrt(share(row) * share(column)) / solid.state.mass;
        }
      const double highest =
          std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness).eigenvalues().tail(1)[0]);
      EightPoints copy = solid;
      const double ratio = copy.step(x, nothing(), 0).stable_step * highest / 2;
      EXPECT_LE(ratio, 1 + 1e-5) << trial << " " << static_cast<int>(rule);
      worst = std::min(worst, ratio);
      best = std::max(best, ratio);
    }
  RecordProperty("stable_step_over_exact_least", std::to_string(worst));
  RecordProperty("stable_step_over_exact_greatest", std::to_string(best));
  EXPECT_GT(worst, 0.4);
  EXPECT_GT(best, 0.99);
}

}  // namespace
}  // namespace gapcheck::solver::solid_eight_test
