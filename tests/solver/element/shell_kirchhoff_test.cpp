// The discrete Kirchhoff triangle (ELFORM 17; ESORT 2): one element, patches, cantilevers and circular plates.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/element/shell_stiffness.hpp"

namespace gapcheck::solver::shell_kirchhoff_test {
namespace {

constexpr double young = 1000, poisson = 0.3, thickness = 0.1;

OneShell triangle(double nu = poisson, double h = thickness) {
  ShellProperties properties;
  properties.material = elastic_material(young, nu);
  properties.hourglass.kind = HourglassKind::none;
  properties.discrete_kirchhoff = true;
  OneShell shell{std::move(properties), h, kirchhoff_forces};
  shell.points.resize(3 * shell.properties.layers.size());
  return shell;
}

class Triangles {
 public:
  std::array<Vector, 4> next(double flat = 0.3, double aspect = 1) {
    std::array<Vector, 4> x{Vector(0, 0, 0), {1, 0, 0}, {0.4, 0.9, 0}, {0, 0, 0}};
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] += flat * Vector(number(), number(), 0);
      x[i].x() *= aspect;
    }
    x[3] = x[2];
    return x;
  }
  double number() { return number_(random_); }
  Vector vector() { return {number(), number(), number()}; }

 private:
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> number_{-1, 1};
};

Eigen::MatrixXd stiffness(const OneShell& shell, const std::array<Vector, 4>& x) {
  return shell_stiffness(shell, x).topLeftCorner<18, 18>();
}

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>((a + a.transpose()) / 2).eigenvalues();
}

/// Bending stiffness over w, θx = w,y and θy = −w,x of three corners in the plane, with Hx and Hy as Batoz, Bathe and
/// Ho print them: slopes βx and βy over quadratic shape functions, differences instead of derivatives.
Eigen::Matrix<double, 9, 9> published_stiffness(const std::array<Vector, 4>& x, double nu, double h) {
  const double area = (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
  std::array<double, 7> a{}, b{}, c{}, d{}, e{};  // 4: side 2-3, 5: 3-1, 6: 1-2
  for (std::size_t k = 4; k < 7; ++k) {
    const Vector s = x[(k - 3) % 3] - x[(k - 2) % 3];
    const double l = s.squaredNorm();
    a[k] = -s.x() / l;
    b[k] = 0.75 * s.x() * s.y() / l;
    c[k] = (s.x() * s.x() / 4 - s.y() * s.y() / 2) / l;
    d[k] = -s.y() / l;
    e[k] = (s.y() * s.y() / 4 - s.x() * s.x() / 2) / l;
  }
  const auto slopes = [&](double l2, double l3) {
    const double l1 = 1 - l2 - l3;
    const std::array<double, 7> n{0,           l1 * (2 * l1 - 1), l2 * (2 * l2 - 1), l3 * (2 * l3 - 1),
                                  4 * l2 * l3, 4 * l3 * l1,       4 * l1 * l2};
    Eigen::Matrix<double, 2, 9> rows;
    for (std::size_t i = 0; i < 3; ++i) {
      // The sides before and after a corner: 5 and 6 of the first, 6 and 4, 4 and 5.
      const std::size_t before = 4 + (i + 1) % 3, after = 4 + (i + 2) % 3;
      const int column = 3 * static_cast<int>(i);
      rows(0, column) = 1.5 * (a[after] * n[after] - a[before] * n[before]);
      rows(0, column + 1) = b[before] * n[before] + b[after] * n[after];
      rows(0, column + 2) = n[i + 1] - c[before] * n[before] - c[after] * n[after];
      rows(1, column) = 1.5 * (d[after] * n[after] - d[before] * n[before]);
      rows(1, column + 1) = -n[i + 1] + e[before] * n[before] + e[after] * n[after];
      rows(1, column + 2) = -rows(0, column + 1);
    }
    return rows;
  };
  Eigen::Matrix2d jacobian;
  jacobian << (x[1] - x[0]).x(), (x[1] - x[0]).y(), (x[2] - x[0]).x(), (x[2] - x[0]).y();
  const Eigen::Matrix2d inverse = jacobian.inverse();
  Eigen::Matrix3d plate;
  plate << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  plate *= young * h * h * h / 12 / (1 - nu * nu);
  Eigen::Matrix<double, 9, 9> k = Eigen::Matrix<double, 9, 9>::Zero();
  for (const auto& [l2, l3] : {std::pair{0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}}) {
    constexpr double step = 0.25;  // exact: the fields are quadratic
    const Eigen::Matrix<double, 2, 9> by2 = (slopes(l2 + step, l3) - slopes(l2 - step, l3)) / (2 * step),
                                      by3 = (slopes(l2, l3 + step) - slopes(l2, l3 - step)) / (2 * step);
    const Eigen::Matrix<double, 2, 9> by_x = inverse(0, 0) * by2 + inverse(0, 1) * by3,
                                      by_y = inverse(1, 0) * by2 + inverse(1, 1) * by3;
    Eigen::Matrix<double, 3, 9> curvature;
    curvature << by_x.row(0), by_y.row(1), by_y.row(0) + by_x.row(1);
    k += area / 3 * curvature.transpose() * plate * curvature;
  }
  return k;
}

TEST(KirchhoffTriangle, BendsAsPublished) {
  Triangles triangles;
  for (int trial = 0; trial < 30; ++trial) {
    const std::array<Vector, 4> x = triangles.next(0.2, trial % 2 == 0 ? 1 : 4);
    const double nu = trial % 3 == 0 ? 0 : 0.3;
    const Eigen::MatrixXd own = stiffness(triangle(nu), x);
    const std::array<int, 9> place{2, 3, 4, 8, 9, 10, 14, 15, 16};
    const Eigen::Matrix<double, 9, 9> published = published_stiffness(x, nu, thickness);
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j)
        EXPECT_NEAR(own(place[static_cast<std::size_t>(i)], place[static_cast<std::size_t>(j)]), published(i, j),
                    1e-7 * published.norm())
            << i << " " << j;
  }
}

// Six rigid motions and three rotations about the normal are free, no other motion is.
TEST(KirchhoffTriangle, NoOtherFreeMotions) {
  Triangles triangles;
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd values = eigenvalues(stiffness(triangle(), triangles.next(0.2)));
    EXPECT_LT(std::abs(values[8]), 1e-6 * values[17]);
    EXPECT_GT(values[9], 1e-5 * values[17]);
  }
}

TEST(KirchhoffTriangle, RigidRotationIsFree) {
  Triangles triangles;
  OneShell shell = triangle();
  ShellCorners corners = at_rest(triangles.next(0.2));
  corners.v[2] = corners.v[3] = {0.01, 0.02, 0.003};
  corners.w[1] = {0.01, -0.01, 0.02};
  const ShellForces first = shell.step(corners, 1e-3);
  const ShellForces last = turn_around(shell, corners, Vector(1, -2, 0.5).normalized(), [](const ShellForces&) {});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR((last.force[i] - first.force[i]).norm(), 0, 1e-11);
    EXPECT_NEAR((last.moment[i] - first.moment[i]).norm(), 0, 1e-11);
  }
}

TEST(KirchhoffTriangle, StoresTheWorkDone) {
  Triangles triangles;
  const std::array<Vector, 4> x = triangles.next(0.2);
  OneShell shell = triangle();
  ShellCorners corners = at_rest(x);
  constexpr double dt = 1e-6;
  for (std::size_t i = 0; i < 3; ++i) {
    corners.v[i] = triangles.vector();
    corners.w[i] = triangles.vector();
  }
  corners.v[3] = corners.v[2];
  const ShellForces forces = shell.step(corners, dt);
  double work = 0;
  for (std::size_t i = 0; i < 3; ++i)
    work += dt / 2 * (forces.force[i].dot(corners.v[i]) + forces.moment[i].dot(corners.w[i]));
  EXPECT_NEAR(kirchhoff_stored_energy(shell.properties, shell.state, shell_area(x), shell.points) / work, 1, 1e-5);
}

// Below the exact step and close to it, whatever the shape and the thickness; with nodes off the middle still below.
TEST(KirchhoffTriangle, StableStepIsABound) {
  Triangles triangles;
  double least = 1;
  for (int trial = 0; trial < 300; ++trial) {
    const std::array<Vector, 4> x = triangles.next(0.3, std::array{1.0, 3.0, 0.3}[static_cast<std::size_t>(trial % 3)]);
    const double h = trial % 2 == 0 ? 0.03 : trial % 5 == 0 ? 1.5 : 0.4, area = shell_area(x);
    OneShell shell = triangle(trial % 4 == 0 ? 0 : 0.3, h);
    shell.properties.reference = trial % 7 == 0 ? 1 : 0;
    const double step = OneShell(shell).step(at_rest(x), 0).stable_step;
    Eigen::VectorXd root(18);
    for (int i = 0; i < 18; ++i)
      root[i] = 1 / std::sqrt(area * h / 3 * (i % 6 < 3 ? 1 : shell.properties.inertia(area, h)));
    const double highest = std::sqrt(eigenvalues(root.asDiagonal() * stiffness(shell, x) * root.asDiagonal())[17]);
    EXPECT_LE(step, 2 / highest * (1 + 1e-7)) << trial;
    if (trial % 7 == 0) continue;
    EXPECT_GE(step, 0.75 * 2 / highest) << trial;
    least = std::min(least, step * highest / 2);
  }
  RecordProperty("least_share_of_the_exact_step", fmt::format("{:.3f}", least));
}

// Bent to κ far beyond yield with no strain across: 2/√3 σ₀ t²/4.
TEST(KirchhoffTriangle, PlasticMoment) {
  OneShell shell = triangle();
  shell.properties.material = plastic_kinematic(1, young, 0, 1, 0, 1);
  shell.properties.layers = gauss_rule(10);
  shell.points.resize(30);
  std::array<Vector, 4> x{Vector(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
  ShellCorners corners = at_rest(x);
  corners.w[1].y() = 1;
  corners.v[1].z() = -0.5;  // w = −x²/2
  ShellForces forces;
  for (int i = 0; i < 200; ++i) forces = shell.step(corners, 0.01);
  const double power = forces.moment[1].y() - forces.force[1].z() / 2, area = 0.5;
  EXPECT_NEAR(power / (area * 2 / std::numbers::sqrt3 * thickness * thickness / 4), 1, 0.015);
}

/// A plate in the plane by dense matrices: w, θx and θy of each node.
class Plate {
 public:
  std::vector<Vector> x;

  explicit Plate(std::vector<Vector> nodes) : x(std::move(nodes)) {
    const auto size = static_cast<Eigen::Index>(3 * x.size());
    k_ = Eigen::MatrixXd::Zero(size, size);
    load_ = Eigen::VectorXd::Zero(size);
    held_.assign(3 * x.size(), false);
  }
  void add(const std::array<std::size_t, 3>& n, double nu = poisson) {
    const Eigen::MatrixXd own = stiffness(triangle(nu), {x[n[0]], x[n[1]], x[n[2]], x[n[2]]});
    for (std::size_t i = 0; i < 9; ++i)
      for (std::size_t j = 0; j < 9; ++j) k_(at(n[i / 3], i % 3), at(n[j / 3], j % 3)) += own(place(i), place(j));
  }
  void hold(std::size_t node, std::size_t what) { held_[3 * node + what] = true; }
  double& load(std::size_t node, std::size_t what = 0) { return load_[at(node, what)]; }
  [[nodiscard]] Eigen::VectorXd solve() const {
    Eigen::MatrixXd k = k_;
    Eigen::VectorXd load = load_;
    for (std::size_t i = 0; i < held_.size(); ++i)
      if (held_[i]) {
        const auto row = static_cast<Eigen::Index>(i);
        k.row(row).setZero();
        k.col(row).setZero();
        k(row, row) = 1;
        load[row] = 0;
      }
    return k.ldlt().solve(load);
  }
  [[nodiscard]] Eigen::VectorXd forces(const Eigen::VectorXd& u) const { return k_ * u; }

 private:
  static Eigen::Index at(std::size_t node, std::size_t what) { return static_cast<Eigen::Index>(3 * node + what); }
  static Eigen::Index place(std::size_t i) { return static_cast<Eigen::Index>(6 * (i / 3) + 2 + i % 3); }
  Eigen::MatrixXd k_;
  Eigen::VectorXd load_;
  std::vector<bool> held_;
};

// Constant curvature and twist: nothing inside an irregular patch, the plate's moments on the sides, forces of the
// twist at the corners.
TEST(KirchhoffPatch, Bending) {
  constexpr double twist = 0.7;
  Plate plate({{0, 0, 0}, {10, 0, 0}, {10, 6, 0}, {0, 6, 0}, {4, 2.5, 0}});
  for (const std::array<std::size_t, 3>& n : {std::array<std::size_t, 3>{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}})
    plate.add(n);
  Eigen::VectorXd u(15);
  for (int i = 0; i < 5; ++i) {
    const Vector& p = plate.x[static_cast<std::size_t>(i)];
    u.segment<3>(3 * i) = Vector(p.x() * p.x() / 2 + twist * p.x() * p.y(), twist * p.x(), -p.x() - twist * p.y());
  }
  const Eigen::VectorXd f = plate.forces(u);
  const double stiff = young * std::pow(thickness, 3) / 12 / (1 - poisson * poisson);
  EXPECT_NEAR(f.tail<3>().norm(), 0, 1e-6);
  EXPECT_NEAR(f[5] + f[8], -stiff * 6, 1e-6);
  // A twist is carried by forces at the corners, twice its moment each.
  for (int corner = 0; corner < 4; ++corner)
    EXPECT_NEAR(f[3 * corner], (corner % 2 == 0 ? 2 : -2) * stiff * (1 - poisson) * twist, 1e-6);
}

// A strip of two triangles per square, ν = 0: P l³ / 3 E I.
TEST(KirchhoffTriangle, Cantilever) {
  std::vector<double> error;
  for (const std::size_t n : {4u, 8u, 16u}) {
    const double length = 10, side = length / static_cast<double>(n);
    std::vector<Vector> nodes;
    for (std::size_t i = 0; i <= n; ++i)
      for (const double y : {0.0, side}) nodes.emplace_back(static_cast<double>(i) * side, y, 0);
    Plate plate(nodes);
    for (std::size_t i = 0; i < n; ++i) {
      plate.add({2 * i, 2 * i + 2, 2 * i + 3}, 0);
      plate.add({2 * i, 2 * i + 3, 2 * i + 1}, 0);
    }
    for (std::size_t node : {0u, 1u})
      for (std::size_t what = 0; what < 3; ++what) plate.hold(node, what);
    plate.load(2 * n) = plate.load(2 * n + 1) = 0.5;
    const double exact = std::pow(length, 3) / (3 * young * side * std::pow(thickness, 3) / 12);
    error.push_back(std::abs(plate.solve()[static_cast<Eigen::Index>(6 * n)] / exact - 1));
    RecordProperty(fmt::format("cantilever_{}", n), fmt::format("{:.5f}", 1 + error.back()));
  }
  EXPECT_LT(error[0], 0.02);
  EXPECT_LT(error[2], error[0] / 4);
}

/// Deflection of the middle over that of a clamped circular plate with a load in its middle, P R² / 16 π D, or with an
/// even pressure, p R⁴ / 64 D; `rings` of triangles.
double circular_plate(std::size_t rings, bool even) {
  std::vector<Vector> nodes{{0, 0, 0}};
  const auto first = [](std::size_t ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); };
  for (std::size_t ring = 1; ring <= rings; ++ring)
    for (std::size_t i = 0; i < 6 * ring; ++i) {
      const double angle = std::numbers::pi * static_cast<double>(i) / (3 * static_cast<double>(ring));
      nodes.push_back(static_cast<double>(ring) / static_cast<double>(rings) *
                      Vector(std::cos(angle), std::sin(angle), 0));
    }
  Plate plate(nodes);
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    plate.add({a, b, c});
    const double third = (nodes[b] - nodes[a]).cross(nodes[c] - nodes[a]).norm() / 6;
    if (even)
      for (const std::size_t node : {a, b, c}) plate.load(node) += third;
  };
  for (std::size_t ring = 1; ring <= rings; ++ring)
    for (std::size_t sector = 0; sector < 6; ++sector)
      for (std::size_t i = 0; i < ring; ++i) {
        const auto outer = [&](std::size_t k) { return first(ring) + (sector * ring + k) % (6 * ring); };
        const auto inner = [&](std::size_t k) {
          return ring == 1 ? 0 : first(ring - 1) + (sector * (ring - 1) + k) % (6 * (ring - 1));
        };
        add(outer(i), outer(i + 1), inner(i));
        if (i > 0) add(inner(i - 1), outer(i), inner(i));
      }
  if (!even) plate.load(0) = 1;
  for (std::size_t i = 0; i < 6 * rings; ++i)
    for (std::size_t what = 0; what < 3; ++what) plate.hold(first(rings) + i, what);
  const double stiff = young * std::pow(thickness, 3) / 12 / (1 - poisson * poisson);
  return plate.solve()[0] * stiff * (even ? 64 : 16 * std::numbers::pi);
}

TEST(KirchhoffTriangle, ClampedCircularPlateConverges) {
  for (const bool even : {true, false}) {
    std::array<double, 3> error;
    for (std::size_t i = 0; i < 3; ++i) error[i] = std::abs(circular_plate(std::size_t{2} << i, even) - 1);
    const double order = std::log2(error[1] / error[2]);
    RecordProperty(even ? "pressure_order" : "load_order", fmt::format("{:.2f}", order));
    RecordProperty(even ? "pressure_error" : "load_error", fmt::format("{:.5f}", error[2]));
    // A single load is singular: h² log h.
    EXPECT_GT(order, even ? 1.8 : 1.2) << error[0] << " " << error[1] << " " << error[2];
    EXPECT_LT(error[2], 0.02);
  }
}

}  // namespace
}  // namespace gapcheck::solver::shell_kirchhoff_test
