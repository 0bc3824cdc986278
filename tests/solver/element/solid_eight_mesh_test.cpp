// Meshes of solids with eight points: patches, cantilevers and frequencies by their assembled stiffness.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "solver/element/solid_stiffness.hpp"

namespace gapcheck::solver::solid_eight_mesh_test {
namespace {

constexpr double young = 1000;

/// A box of cells; wedges: each cell is two of them, split along a diagonal of z.
struct Mesh {
  std::vector<Vector> x;
  std::vector<std::array<int, 8>> cells;
  std::array<int, 3> counts;

  Mesh(std::array<int, 3> n, const Vector& size, bool wedges = false) : counts(n) {
    for (int k = 0; k <= n[2]; ++k)
      for (int j = 0; j <= n[1]; ++j)
        for (int i = 0; i <= n[0]; ++i) x.emplace_back(size.x() * i / n[0], size.y() * j / n[1], size.z() * k / n[2]);
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i) {
          const int a = id(i, j, k), b = id(i + 1, j, k), c = id(i + 1, j + 1, k), d = id(i, j + 1, k);
          const int up = id(0, 0, 1) - id(0, 0, 0);
          if (wedges) {
            cells.push_back({a, b, c, c, a + up, b + up, c + up, c + up});
            cells.push_back({c, d, a, a, c + up, d + up, a + up, a + up});
          } else {
            cells.push_back({a, b, c, d, a + up, b + up, c + up, d + up});
          }
        }
  }
  [[nodiscard]] int id(int i, int j, int k) const { return i + (counts[0] + 1) * (j + (counts[1] + 1) * k); }
  [[nodiscard]] Bricks corners(std::size_t cell) const {
    Bricks all;
    for (std::size_t a = 0; a < 8; ++a) all[a] = x[static_cast<std::size_t>(cells[cell][a])];
    return all;
  }
  [[nodiscard]] bool on_surface(int node) const {
    const int i = node % (counts[0] + 1), j = node / (counts[0] + 1) % (counts[1] + 1),
              k = node / (counts[0] + 1) / (counts[1] + 1);
    return i == 0 || j == 0 || k == 0 || i == counts[0] || j == counts[1] || k == counts[2];
  }
  void move_inner(double size) {
    BrickRandom random(17);
    for (std::size_t node = 0; node < x.size(); ++node)
      if (!on_surface(static_cast<int>(node))) x[node] += random.vector(size);
  }
};

/// A linear field in a patch of moved inner nodes: the exact stress at every point, no force on inner nodes.
TEST(SolidEightPatch, LinearFieldIsExact) {
  constexpr double dt = 1e-9, nu = 0.3;
  Matrix gradient;
  gradient << 1, 0.5, -0.2, 0.3, -0.4, 0.7, 0.1, -0.6, 0.8;
  for (const double height : {3.0, 0.3})
    for (const SolidRule rule :
         {SolidRule::eight_points, SolidRule::efficient, SolidRule::accurate, SolidRule::wedge}) {
      Mesh mesh({3, 3, 3}, {3, 3, height}, rule == SolidRule::wedge);
      mesh.move_inner(0.08 * height);
      std::vector<Vector> force(mesh.x.size(), Vector::Zero());
      double volume = 0;
      for (std::size_t e = 0; e < mesh.cells.size(); ++e) {
        const Bricks x = mesh.corners(e);
        EightPoints solid(elastic_eight(young, nu), rule, x);
        Bricks v;
        for (std::size_t a = 0; a < 8; ++a) v[a] = gradient * x[a];
        const SolidForces forces = solid.step(x, v, dt);
        ASSERT_TRUE(forces.good);
        volume += forces.volume;
        constexpr double shear = young / 2.6, lame = young * nu / 1.3 / 0.4;
        const Symmetric rate = to_symmetric(gradient);
        for (const PointState& point : solid.points)
          for (std::size_t c = 0; c < 6; ++c)
            EXPECT_NEAR(point.stress[c] / dt, 2 * shear * rate[c] + (c < 3 ? lame * gradient.trace() : 0), 1e-5);
        for (std::size_t a = 0; a < 8; ++a) force[static_cast<std::size_t>(mesh.cells[e][a])] += forces.force[a];
      }
      EXPECT_NEAR(volume, 9 * height, 1e-9);
      for (std::size_t node = 0; node < force.size(); ++node)
        EXPECT_NEAR(mesh.on_surface(static_cast<int>(node)) ? 0 : force[node].norm() / dt, 0, 1e-4) << node;
    }
}

using Sparse = Eigen::SparseMatrix<double>;

Sparse assemble(const Mesh& mesh, SolidRule rule, double nu) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t e = 0; e < mesh.cells.size(); ++e) {
    const Bricks x = mesh.corners(e);
    const Eigen::MatrixXd own = brick_stiffness({elastic_eight(young, nu), rule, x}, x);
    for (int row = 0; row < 24; ++row)
      for (int column = 0; column < 24; ++column)
        entries.emplace_back(3 * mesh.cells[e][static_cast<std::size_t>(row / 3)] + row % 3,
                             3 * mesh.cells[e][static_cast<std::size_t>(column / 3)] + column % 3,
                             (own(row, column) + own(column, row)) / 2);
  }
  Sparse stiffness(3 * static_cast<int>(mesh.x.size()), 3 * static_cast<int>(mesh.x.size()));
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

/// Mean deflection in z of the end x = l of a bar held at x = 0 under a shear force of 1; the held end may contract
/// sideways.
double tip(const Mesh& mesh, SolidRule rule, double nu) {
  Sparse stiffness = assemble(mesh, rule, nu);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(stiffness.rows());
  const auto& n = mesh.counts;
  double weights = 0;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j) {
      const double w = (k == 0 || k == n[2] ? 0.5 : 1) * (j == 0 || j == n[1] ? 0.5 : 1);
      load[3 * mesh.id(n[0], j, k) + 2] = w;
      weights += w;
    }
  load /= weights;
  const Eigen::VectorXd ends = load;
  const double stiff = 1e9 * young;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j) {
      const int node = mesh.id(0, j, k);
      stiffness.coeffRef(3 * node, 3 * node) += stiff;
      if (j == 0 && k == 0) stiffness.coeffRef(3 * node + 1, 3 * node + 1) += stiff;
      if (k == 0) stiffness.coeffRef(3 * node + 2, 3 * node + 2) += stiff;
      if (j == 0) stiffness.coeffRef(3 * node + 1, 3 * node + 1) += stiff;
    }
  const Eigen::SimplicialLDLT<Sparse> solver(stiffness);
  return ends.dot(Eigen::VectorXd(solver.solve(load)));
}

/// Timoshenko: l³ / 3 E I + l / (5/6 G A), without the shear at the end that is free to warp.
double beam_tip(const Vector& size, double nu) {
  const double inertia = size.y() * std::pow(size.z(), 3) / 12, area = size.y() * size.z();
  return std::pow(size.x(), 3) / (3 * young * inertia) + size.x() / (5.0 / 6 * young / (2 * (1 + nu)) * area);
}

// One layer of bricks 1 : 10 to 1 : 50: ELFORM 2 locks with the square of the ratio, ELFORM -1 and -2 have the same tip
// for every ratio: 21 % too far, as the mean dilatation leaves bending without pressure.
TEST(SolidEightCantilever, LongBricksLockOnlyWithoutScaling) {
  for (const double ratio : {10.0, 20.0, 50.0}) {
    const Vector size(10 * ratio, 2, 1);
    const Mesh mesh({10, 1, 1}, size);
    const double exact = beam_tip(size, 0.3);
    const double locked = tip(mesh, SolidRule::eight_points, 0.3) / exact,
                 efficient = tip(mesh, SolidRule::efficient, 0.3) / exact,
                 accurate = tip(mesh, SolidRule::accurate, 0.3) / exact;
    RecordProperty("tip_1_to_" + std::to_string(static_cast<int>(ratio)),
                   std::to_string(locked) + " " + std::to_string(efficient) + " " + std::to_string(accurate));
    EXPECT_LT(locked, 3 / (ratio * ratio));
    EXPECT_NEAR(efficient, 1.21, 0.005) << ratio;
    EXPECT_NEAR(accurate, 1.21, 0.005) << ratio;
  }
}

// With the mesh the tip goes to that of the beam: every halving cuts the error to less than a half.
TEST(SolidEightCantilever, TipsConverge) {
  const Vector size(10, 1, 1);
  const double exact = beam_tip(size, 0.3);
  for (const SolidRule rule : {SolidRule::eight_points, SolidRule::efficient, SolidRule::accurate, SolidRule::wedge}) {
    std::vector<double> errors;
    for (const int n : {1, 2, 4})
      errors.push_back(tip(Mesh({5 * n, n, n}, size, rule == SolidRule::wedge), rule, 0.3) / exact - 1);
    RecordProperty("tip_errors_" + std::to_string(static_cast<int>(rule)),
                   std::to_string(errors[0]) + " " + std::to_string(errors[1]) + " " + std::to_string(errors[2]));
    EXPECT_LT(std::abs(errors[2]), 0.08) << static_cast<int>(rule);
    EXPECT_LT(std::abs(errors[1]), std::abs(errors[0]) / 1.9) << static_cast<int>(rule);
    EXPECT_LT(std::abs(errors[2]), std::abs(errors[1]) / 1.9) << static_cast<int>(rule);
  }
}

// Nearly without change of volume the deflection is that of ν = 0.4999: no volume locking. Bricks without the mean
// dilatation would be stiffer by orders of magnitude (K / G = 5,000).
TEST(SolidEightCantilever, NearlyIncompressibleBendsAsFar) {
  const Vector size(10, 1, 1);
  for (const SolidRule rule : {SolidRule::eight_points, SolidRule::efficient, SolidRule::accurate}) {
    const Mesh mesh({20, 2, 4}, size);
    const double soft = tip(mesh, rule, 0.3) / beam_tip(size, 0.3),
                 full = tip(mesh, rule, 0.4999) / beam_tip(size, 0.4999);
    RecordProperty("tip_incompressible_" + std::to_string(static_cast<int>(rule)), std::to_string(full));
    EXPECT_NEAR(full, 1, 0.1) << static_cast<int>(rule);
    EXPECT_NEAR(full, soft, 0.05) << static_cast<int>(rule);
  }
}

// First bending frequency of a free bar of 40 x 3 x 1 with lumped masses: (4.7300 / l)² √(E I / ρ A), of which shear
// and rotary inertia take 0.4 %. In two layers three quarters of the stiffness are stretch, with E, and one quarter
// bending of the bricks, with their own modulus (ShearLocksInLongBricksUnlessScaled).
TEST(SolidEightFrequency, OfAFreeBar) {
  const Vector size(40, 3, 1);
  const double plain = std::pow(4.7300407 / 40, 2) * std::sqrt(young / 12), shear = 1 / 2.6;
  for (const SolidRule rule : {SolidRule::eight_points, SolidRule::efficient, SolidRule::accurate}) {
    const Mesh mesh({30, 2, 2}, size);
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(3 * static_cast<int>(mesh.x.size()));
    for (const auto& cell : mesh.cells)
      for (const int node : cell)
        mass.segment<3>(3 * node).array() += size.prod() / static_cast<double>(mesh.cells.size()) / 8;
    const Eigen::VectorXd root = mass.cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = root.asDiagonal() * Eigen::MatrixXd(assemble(mesh, rule, 0.3)) * root.asDiagonal();
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
    const double locked = rule == SolidRule::eight_points ? 64.0 / 9 : 1;  // of bricks of 4/3 by 1/2
    const double expected = std::sqrt(0.75 + 0.25 * (4 * shear / 3 + shear * locked));
    const double found = std::sqrt(values[6]) / plain;
    RecordProperty("frequency_" + std::to_string(static_cast<int>(rule)), std::to_string(found / expected));
    EXPECT_LT(std::abs(values[5]), 1e-3 * values[6]);
    EXPECT_NEAR(found / expected, 0.996, 0.03) << static_cast<int>(rule);
  }
}

}  // namespace
}  // namespace gapcheck::solver::solid_eight_mesh_test
