#include "solver/element/shell.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/element/shell_stiffness.hpp"

namespace gapcheck::solver::shell_test {
namespace {

constexpr double young = 1000, poisson = 0.3, thickness = 0.2;

ShellProperties elastic_shell(double nu = poisson, HourglassKind hourglass = HourglassKind::stiffness) {
  ShellProperties properties;
  properties.material = elastic_material(young, nu);
  properties.hourglass = {hourglass, 0.1};
  properties.shear_factor = 5.0 / 6;
  return properties;
}

/// A patch of five quads, or ten triangles, with four free corners inside; all in the plane z = 0.
struct Patch {
  std::vector<Vector> x{{0, 0, 0}, {10, 0, 0}, {10, 6, 0}, {0, 6, 0}, {2, 1.5, 0}, {7, 2, 0}, {6.5, 4, 0}, {3, 4.5, 0}};
  std::vector<std::array<std::size_t, 4>> elements{
      {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};

  void make_rectangles() {
    x = {{0, 0, 0}, {9, 0, 0}, {9, 6, 0}, {0, 6, 0}, {3, 0, 0}, {3, 6, 0},
         {6, 0, 0}, {6, 6, 0}, {0, 3, 0}, {3, 3, 0}, {6, 3, 0}, {9, 3, 0}};
    elements = {{0, 4, 9, 8}, {4, 6, 10, 9}, {6, 1, 11, 10}, {8, 9, 5, 3}, {9, 10, 7, 5}, {10, 11, 2, 7}};
  }
  void make_triangles() {
    std::vector<std::array<std::size_t, 4>> triangles;
    for (const auto& e : elements) {
      triangles.push_back({e[0], e[1], e[2], e[2]});
      triangles.push_back({e[2], e[3], e[0], e[0]});
    }
    elements = triangles;
  }
};

/// Net force and moment on every node of the patch after one small step of the fields v(x), w(x).
template <class V, class W>
std::pair<std::vector<Vector>, std::vector<Vector>> patch_forces(const Patch& patch, ShellKernel kernel, double dt,
                                                                 const V& v, const W& w) {
  std::vector<Vector> force(patch.x.size(), Vector::Zero()), moment(patch.x.size(), Vector::Zero());
  for (const auto& element : patch.elements) {
    ShellCorners corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector& x = patch.x[element[i]];
      corners.v[i] = v(x);
      corners.w[i] = w(x);
      corners.x[i] = x;
    }
    OneShell shell(elastic_shell(), thickness, kernel);
    const ShellForces forces = shell.step(corners, dt);
    EXPECT_TRUE(forces.good);
    EXPECT_NEAR(forces.hourglass_work, 0, 1e-20);
    for (std::size_t i = 0; i < 4; ++i) {
      force[element[i]] += forces.force[i];
      moment[element[i]] += forces.moment[i];
    }
  }
  return {force, moment};
}

TEST(Gauss, ExactToItsDegree) {
  for (int n = 1; n <= 10; ++n)
    for (int degree = 0; degree < 2 * n; ++degree) {
      double sum = 0;
      for (const GaussPoint& point : gauss_rule(n)) sum += point.weight * std::pow(point.place, degree);
      EXPECT_NEAR(sum, degree % 2 == 0 ? 2.0 / (degree + 1) : 0, 2e-15) << n << " " << degree;
    }
  EXPECT_EQ(gauss_rule(0).size(), 1u);
  EXPECT_EQ(gauss_rule(1000).size(), 10u);
}

// Stretched linearly, no corner inside feels a force, and the side x = 10 carries σxx t · height.
TEST(ShellPatch, Membrane) {
  constexpr double dt = 1e-9, rate = 1;
  for (const ShellKernel kernel : {quad_forces, triangle_forces}) {
    Patch patch;
    if (kernel == triangle_forces) patch.make_triangles();
    const auto v = [](const Vector& x) { return Vector(rate * x.x() + 0.5 * x.y(), -0.4 * x.y(), 0); };
    const auto w = [](const Vector&) { return Vector(0, 0, 0); };
    const auto [force, moment] = patch_forces(patch, kernel, dt, v, w);
    for (std::size_t i = 4; i < 8; ++i) EXPECT_NEAR(force[i].norm() / dt, 0, 1e-5) << i;
    const double stress = young / (1 - poisson * poisson) * (1 - poisson * 0.4), shear = young / (2 * 1.3) * 0.5;
    EXPECT_NEAR((force[1] + force[2]).x() / dt, stress * thickness * 6, 1e-4);
    EXPECT_NEAR((force[1] + force[2]).y() / dt, shear * thickness * 6, 1e-4);
    for (const Vector& m : moment) EXPECT_NEAR(m.norm() / dt, 0, 1e-6);
  }
}

// Bent to a constant curvature (w = κ x²/2, θy = −κ x) and twisted (w = τ x y): no forces, no moments inside, the
// plate's moments on the sides. The one-point quad does so on rectangles only, the triangle on any mesh.
TEST(ShellPatch, Bending) {
  constexpr double dt = 1e-12, twist = 0.7;
  for (const ShellKernel kernel : {quad_forces, triangle_forces}) {
    Patch patch;
    if (kernel == quad_forces) patch.make_rectangles();
    if (kernel == triangle_forces) patch.make_triangles();
    const bool quads = kernel == quad_forces;
    const double tau = quads ? 0 : twist;  // on rectangles the twist is an hourglass mode of w
    const auto v = [&](const Vector& x) { return Vector(0, 0, x.x() * x.x() / 2 + tau * x.x() * x.y()); };
    const auto w = [&](const Vector& x) { return Vector(tau * x.x(), -x.x() - tau * x.y(), 0); };
    const auto [force, moment] = patch_forces(patch, kernel, dt, v, w);
    for (const std::size_t i : quads ? std::vector<std::size_t>{9, 10} : std::vector<std::size_t>{4, 5, 6, 7})
      EXPECT_NEAR(moment[i].norm() / dt, 0, 1e-7) << i;
    for (const Vector& f : force) EXPECT_NEAR(f.norm() / dt, 0, 1e-6);
    const double plate = young * std::pow(thickness, 3) / 12 / (1 - poisson * poisson);
    Vector side = Vector::Zero();
    for (std::size_t i = 0; i < patch.x.size(); ++i)
      if (patch.x[i].x() > (quads ? 8.9 : 9.9)) side += moment[i];
    EXPECT_NEAR(side.y() / dt, -plate * 6, 1e-6);
  }
}

// Turned through a whole circle about any axis, a warped and stressed quad keeps its stresses: forces turn with it.
TEST(Shell, RigidRotationIsFree) {
  const Vector axis = Vector(1, -2, 0.5).normalized();
  for (const ShellKernel kernel : {quad_forces, triangle_forces}) {
    std::array<Vector, 4> x{Vector(0, 0, 0.1), {2, 0.1, -0.1}, {2.3, 1.7, 0.2}, {-0.2, 1.5, -0.2}};
    if (kernel == triangle_forces) x[3] = x[2];
    OneShell shell(elastic_shell(), thickness, kernel);
    ShellCorners corners = at_rest(x);
    corners.v[2] = {0.01, 0.02, 0.003};
    corners.w[1] = {0.01, -0.01, 0};
    const ShellForces first = shell.step(corners, 1e-3);
    const std::vector<PointState> stressed = shell.points;
    const ShellForces last = turn_around(
        shell, corners, axis, [](const ShellForces& forces) { EXPECT_NEAR(forces.hourglass_work, 0, 1e-16); });
    for (std::size_t p = 0; p < stressed.size(); ++p)
      for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(shell.points[p].stress[c], stressed[p].stress[c], 1e-11);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR((last.force[i] - first.force[i]).norm(), 0, 1e-10);
      EXPECT_NEAR((last.moment[i] - first.moment[i]).norm(), 0, 1e-10);
    }
  }
}

// Forces and moments of one element are in balance, warped or not: no free momentum.
TEST(Shell, ForcesAreInBalance) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-0.3, 0.3);
  const auto jitter = [&] { return Vector(number(random), number(random), number(random)); };
  for (int trial = 0; trial < 50; ++trial)
    for (const ShellKernel kernel : {quad_forces, triangle_forces}) {
      std::array<Vector, 4> x{Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
      for (Vector& corner : x) corner += jitter();
      if (kernel == triangle_forces) x[3] = x[2];
      ShellCorners corners = at_rest(x);
      for (std::size_t i = 0; i < 4; ++i) {
        corners.v[i] = jitter();
        corners.w[i] = jitter();
      }
      OneShell shell(elastic_shell(), thickness, kernel);
      const ShellForces forces = shell.step(corners, 1e-3);
      Vector force = Vector::Zero(), moment = Vector::Zero();
      for (std::size_t i = 0; i < 4; ++i) {
        force += forces.force[i];
        moment += corners.x[i].cross(forces.force[i]) + forces.moment[i];
      }
      EXPECT_NEAR(force.norm(), 0, 1e-14);
      EXPECT_NEAR(moment.norm(), 0, 1e-14);
    }
}

/// Tip deflection under a unit force and first frequency (rad/s) of a strip clamped at x = 0, by the stiffness of the
/// kernels. Drilling and in-plane motion are held.
struct Strip {
  double deflection, frequency;
};

Strip solve_strip(int n, ShellKernel kernel, double length, double width, double nu) {
  const int nodes = 2 * (n + 1), free = 3 * (nodes - 2);
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(free, free);
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(free);
  const auto position = [&](int node) { return Vector(length * (node / 2) / n, node % 2 * width, 0); };
  const auto add = [&](std::array<int, 4> corners) {
    std::array<Vector, 4> x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = position(corners[i]);
    const int count = kernel == quad_forces ? 4 : 3;
    const OneShell shell(elastic_shell(nu), thickness, kernel);
    const Eigen::MatrixXd element = shell_stiffness(shell, x);
    const double area = shell_area(x), share = area * thickness / count;
    for (int i = 0; i < count; ++i)
      for (int a = 0; a < 3; ++a) {
        const int row = 3 * (corners[static_cast<std::size_t>(i)] - 2) + a;
        if (row < 0) continue;
        mass[row] += a == 0 ? share : share * rotational_inertia(area, thickness);
        for (int j = 0; j < count; ++j)
          for (int b = 0; b < 3; ++b) {
            const int column = 3 * (corners[static_cast<std::size_t>(j)] - 2) + b;
            if (column >= 0) stiffness(row, column) += element(6 * i + 2 + a, 6 * j + 2 + b);
          }
      }
  };
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i;
    if (kernel == quad_forces) {
      add({a, a + 2, a + 3, a + 1});
    } else {
      add({a, a + 2, a + 3, a + 3});
      add({a, a + 3, a + 1, a + 1});
    }
  }
  Eigen::VectorXd load = Eigen::VectorXd::Zero(free);
  load[free - 6] = load[free - 3] = 0.5;
  const Eigen::VectorXd deflection = stiffness.fullPivLu().solve(load);
  const Eigen::VectorXd root = mass.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = root.asDiagonal() * (stiffness + stiffness.transpose()) / 2 * root.asDiagonal();
  const double lowest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues()[0];
  return {(deflection[free - 6] + deflection[free - 3]) / 2, std::sqrt(lowest)};
}

// F L³ / 3 E I + F L / κ G A; the element with its curvature from the middle misses exactly 1 / (4 n²) of the bending.
TEST(ShellCantilever, DeflectionConvergesWithSecondOrder) {
  constexpr double length = 10, width = 1;
  const double bending = std::pow(length, 3) / (3 * young * width * std::pow(thickness, 3) / 12);
  const double shear = length / (5.0 / 6 * young / 2 * width * thickness);
  for (const int n : {4, 8, 16}) {
    const double deflection = solve_strip(n, quad_forces, length, width, 0).deflection;
    EXPECT_NEAR(deflection, bending * (1 - 0.25 / (n * n)) + shear, 1e-5 * bending) << n;
  }
}

TEST(ShellCantilever, TrianglesConverge) {
  constexpr double length = 10, width = 1;
  const double exact = std::pow(length, 3) / (3 * young * width * std::pow(thickness, 3) / 12) +
                       length / (5.0 / 6 * young / 2 * width * thickness);
  std::array<double, 3> error{};
  for (std::size_t i = 0; i < 3; ++i)
    error[i] = std::abs(solve_strip(8 << i, triangle_forces, length, width, 0).deflection / exact - 1);
  EXPECT_LT(error[2], 0.02);
  EXPECT_LT(error[1], 0.75 * error[0]);
  EXPECT_LT(error[2], 0.75 * error[1]);
}

// ω = 1.8751² √(E I / ρ A) / L². Square elements: the raised rotational inertia shrinks with their area.
TEST(ShellCantilever, FirstFrequency) {
  constexpr double length = 20;
  const double exact = 1.875104069 * 1.875104069 * std::sqrt(young * thickness * thickness / 12) / (length * length);
  std::array<double, 3> frequency{};
  for (std::size_t i = 0; i < 3; ++i)
    frequency[i] = solve_strip(8 << i, quad_forces, length, length / (8 << i), 0).frequency;
  EXPECT_NEAR(frequency[2] / exact, 1, 0.002);
  const double order = std::log2((frequency[1] - frequency[0]) / (frequency[2] - frequency[1]));
  EXPECT_NEAR(order, 2, 0.15);
}

// The bound of the time step holds for the free element whatever its shape, and is not far off.
TEST(Shell, StableStepIsABound) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-0.35, 0.35);
  for (int trial = 0; trial < 60; ++trial)
    for (const ShellKernel kernel : {quad_forces, triangle_forces}) {
      std::array<Vector, 4> x{Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
      for (Vector& corner : x) corner += Vector(number(random), number(random), 0);
      if (kernel == triangle_forces) x[3] = x[2];
      const double h = trial % 3 == 0 ? 1.5 : 0.05;
      OneShell shell(elastic_shell(trial % 2 == 0 ? 0.3 : 0, HourglassKind::none), h, kernel);
      const double corners = kernel == quad_forces ? 4 : 3;
      const double share = shell_area(x) * h / corners, inertia = share * rotational_inertia(shell_area(x), h);
      Eigen::VectorXd root(24);
      for (int i = 0; i < 24; ++i) root[i] = 1 / std::sqrt(i % 6 < 3 ? share : inertia);
      const Eigen::MatrixXd k = shell_stiffness(shell, x);
      EXPECT_LT((k - k.transpose()).norm(), 1e-5 * k.norm()) << "forces have an energy";
      const Eigen::MatrixXd scaled = root.asDiagonal() * (k + k.transpose()) / 2 * root.asDiagonal();
      const double highest = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues()[23]);
      const double step = shell.step(at_rest(x), 0).stable_step;
      EXPECT_LE(step, 2 / highest * (1 + 1e-5)) << trial;
      EXPECT_GE(step, 0.5 * 2 / highest) << trial;
    }
}

// The same with hourglass control, in skewed and warped quads: its modes share directions with the element's own.
TEST(Shell, StableStepCountsHourglassControl) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> number(-0.35, 0.35);
  int decided = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::array<Vector, 4> x{Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (Vector& corner : x) corner += Vector(number(random), number(random), trial % 2 == 0 ? 0 : number(random) / 4);
    constexpr double h = 0.05;
    ShellProperties properties = elastic_shell();
    properties.hourglass.set_all(trial % 3 == 0 ? 0.1 : 1);
    OneShell shell(properties, h);
    const double share = shell_area(x) * h / 4, inertia = share * rotational_inertia(shell_area(x), h);
    Eigen::VectorXd root(24);
    for (int i = 0; i < 24; ++i) root[i] = 1 / std::sqrt(i % 6 < 3 ? share : inertia);
    const Eigen::MatrixXd k = shell_stiffness(shell, x);
    const Eigen::MatrixXd scaled = root.asDiagonal() * (k + k.transpose()) / 2 * root.asDiagonal();
    const double highest = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues()[23]);
    EXPECT_LE(shell.step(at_rest(x), 0).stable_step, 2 / highest * (1 + 1e-5)) << trial;
    properties.hourglass.kind = HourglassKind::none;
    decided += OneShell(properties, h).step(at_rest(x), 0).stable_step > 2 / highest;
  }
  EXPECT_GT(decided, 20);
}

// A viscosity that lags half a step adds 2 c dt to ω² dt²; none of it in rectangles.
TEST(Shell, StableStepCountsHourglassViscosity) {
  const auto step = [](HourglassKind kind, const std::array<Vector, 4>& x) {
    return OneShell(elastic_shell(poisson, kind), thickness).step(at_rest(x), 0).stable_step;
  };
  const std::array<Vector, 4> rectangle{Vector(0, 0, 0), {2, 0, 0}, {2, 1, 0}, {0, 1, 0}},
      trapezoid{Vector(0, 0, 0), {2, 0, 0}, {1.2, 1, 0}, {0.8, 1, 0}};
  EXPECT_EQ(step(HourglassKind::viscous, rectangle), step(HourglassKind::none, rectangle));
  EXPECT_EQ(step(HourglassKind::stiffness, rectangle), step(HourglassKind::none, rectangle));
  // The largest eigenvalue of dt² K + 2 dt C at the step, over the masses.
  const auto largest = [](const std::array<Vector, 4>& x) {
    const OneShell plain(elastic_shell(poisson, HourglassKind::none), thickness);
    OneShell viscous(elastic_shell(poisson, HourglassKind::viscous), thickness);
    const Eigen::MatrixXd k = shell_stiffness(plain, x), c = (shell_stiffness(viscous, x) - k) * 1e-8;
    const double dt = viscous.step(at_rest(x), 0).stable_step;
    const double share = shell_area(x) * thickness / 4, inertia = share * rotational_inertia(shell_area(x), thickness);
    Eigen::VectorXd root(24);
    for (int i = 0; i < 24; ++i) root[i] = 1 / std::sqrt(i % 6 < 3 ? share : inertia);
    const Eigen::MatrixXd a = root.asDiagonal() * (dt * dt * k + 2 * dt * c) * root.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>((a + a.transpose()) / 2).eigenvalues()[23];
  };
  EXPECT_LT(step(HourglassKind::viscous, trapezoid), 0.99 * step(HourglassKind::none, trapezoid));
  EXPECT_LE(largest(trapezoid), 4 * (1 + 1e-5));
  EXPECT_GE(largest(trapezoid), 3);
  EXPECT_LE(largest(rectangle), 4 * (1 + 1e-5));
}

// L = A / longest side (triangles: twice that), c² = E / (ρ (1 − ν²)).
TEST(Shell, ManualTimeStep) {
  const double speed = std::sqrt(young / (1 - poisson * poisson));
  OneShell quad(elastic_shell(), thickness);
  EXPECT_NEAR(quad.step(at_rest({Vector(0, 0, 0), {3, 0, 0}, {3, 2, 0}, {0, 2, 0}}), 0).manual_step, 2 / speed, 1e-12);
  OneShell triangle(elastic_shell(), thickness, triangle_forces);
  EXPECT_NEAR(triangle.step(at_rest({Vector(0, 0, 0), {3, 0, 0}, {3, 4, 0}, {3, 4, 0}}), 0).manual_step, 2.4 / speed,
              1e-12);
}

// Unit square, mode (1, −1, 1, −1) in x: γ = (1, −1, 1, −1), q = 4; with Σ B² = 2: Q = r E t / 4 · q · dt.
TEST(Shell, HourglassStiffness) {
  OneShell shell(elastic_shell(), thickness);
  ShellCorners corners = at_rest({Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  constexpr double dt = 1e-8;
  for (std::size_t i = 0; i < 4; ++i) corners.v[i] = Vector(i % 2 == 0 ? 1 : -1, 0, 0);
  const ShellForces forces = shell.step(corners, dt);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(forces.force[i].x(), (i % 2 == 0 ? 1 : -1) * 0.1 * young * thickness * dt, 1e-13);
  EXPECT_NEAR(forces.hourglass_work, 0.5 * 0.1 * young * thickness * 4 * dt * dt, 1e-20);
  // Viscous forces do not last.
  OneShell viscous(elastic_shell(poisson, HourglassKind::viscous), thickness);
  EXPECT_GT(viscous.step(corners, dt).force[0].x(), 0);
  EXPECT_EQ(viscous.step(at_rest(corners.x), dt).force[0].norm(), 0);
}

// Equal stretch in x and y: ε = ln λ each, t = t₀ exp(−2 ν / (1 − ν) ln λ).
TEST(Shell, ThicknessFollowsTheStrain) {
  for (const bool thins : {true, false}) {
    ShellProperties properties = elastic_shell();
    properties.thins = thins;
    OneShell shell(properties, thickness);
    std::array<Vector, 4> x{Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    constexpr int steps = 1000;
    const double stretch = std::pow(1.2, 1.0 / steps);
    for (int i = 0; i < steps; ++i) {
      ShellCorners corners = at_rest(x);
      for (std::size_t c = 0; c < 4; ++c) {
        corners.x[c] = stretch * x[c];
        corners.v[c] = corners.x[c] - x[c];
      }
      (void)shell.step(corners, 1);
      x = corners.x;
    }
    const double expected = thins ? thickness * std::exp(-2 * poisson / (1 - poisson) * std::log(1.2)) : thickness;
    EXPECT_NEAR(shell.state.thickness, expected, 1e-7 * thickness);
    EXPECT_NEAR(shell.points[0].stress[xx], young / (1 - poisson) * std::log(1.2), 1e-4);
  }
}

// Bent far beyond yield with no strain across: 2 / √3 σ₀ t² / 4, which ten Gauss points meet to about 1 %.
TEST(Shell, PlasticMoment) {
  ShellProperties properties = elastic_shell(0);
  properties.layers = gauss_rule(10);
  properties.material = plastic_kinematic(1, young, 0, 1, 0, 1);
  OneShell shell(properties, thickness);
  ShellCorners corners = at_rest({Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  corners.w[1].y() = corners.w[2].y() = 1;     // a curvature about y ...
  corners.v[1].z() = corners.v[2].z() = -0.5;  // ... without transverse shear
  ShellForces forces;
  for (int i = 0; i < 100; ++i) forces = shell.step(corners, 0.01);
  const double full = 2 / std::numbers::sqrt3 * thickness * thickness / 4;
  EXPECT_NEAR((forces.moment[1].y() + forces.moment[2].y()) / full, 1, 0.015);
}

TEST(Shell, BadShapesAreTold) {
  OneShell shell(elastic_shell(), thickness);
  EXPECT_FALSE(shell.step(at_rest({Vector(0, 0, 0), {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}), 0).good);
  EXPECT_FALSE(shell.step(at_rest({Vector(0, 0, 0), {1, 0, 0}, {1, NAN, 0}, {0, 1, 0}}), 0).good);
}

}  // namespace
}  // namespace gapcheck::solver::shell_test
