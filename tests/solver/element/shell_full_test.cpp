// The fully integrated shell (ELFORM 16), one element or a patch.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/element/shell_full_twin.hpp"

namespace gapcheck::solver::shell_full_test {
namespace {

constexpr double young = 1000, poisson = 0.3, thickness = 0.2;

ShellProperties full_shell_of(Material material, int layers = 2) {
  ShellProperties properties;
  properties.material = std::move(material);
  properties.layers = gauss_rule(layers);
  properties.hourglass.kind = HourglassKind::none;
  properties.shear_factor = 5.0 / 6;
  properties.form = ShellForm::full;
  return properties;
}

OneShell full_shell(double nu = poisson, double h = thickness) {
  return {full_shell_of(elastic_material(young, nu)), h, full_forces};
}

/// A square whose corners are moved at random, up to `flat` in its plane and `warp` out of it.
class Shapes {
 public:
  std::array<Vector, 4> next(double flat, double warp) {
    std::array<Vector, 4> x{Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (Vector& corner : x)
      corner += Vector(flat * number_(random_), flat * number_(random_), warp * number_(random_));
    return x;
  }
  Vector vector() { return {number_(random_), number_(random_), number_(random_)}; }

 private:
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> number_{-1, 1};
};

Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& a) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>((a + a.transpose()) / 2).eigenvalues();
}

// Every entry of the stiffness against the slow twin: strains, assumed fields and their transposes; collapsed too.
TEST(FullShell, StiffnessOfItsTwin) {
  Shapes shapes;
  for (int trial = 0; trial < 60; ++trial) {
    std::array<Vector, 4> x = shapes.next(0.25, trial % 3 == 0 ? 0 : 0.2);
    if (trial % 5 == 0) x[3] = x[2];
    for (const double nu : {0.0, 0.3}) {
      const Eigen::MatrixXd twin = FullShellTwin(x, young, nu).stiffness(thickness, 5.0 / 6);
      const Eigen::MatrixXd k = shell_stiffness(full_shell(nu), x);
      EXPECT_LT((k - twin).norm(), 1e-7 * twin.norm()) << trial;
    }
  }
}

// Stresses of every layer of every point.
TEST(FullShell, StressesOfItsTwin) {
  Shapes shapes;
  for (int trial = 0; trial < 20; ++trial) {
    const std::array<Vector, 4> x = shapes.next(0.25, 0.2);
    const FullShellTwin twin(x, young, poisson);
    OneShell shell = full_shell();
    ShellCorners corners = at_rest(x);
    Eigen::Matrix<double, 24, 1> u;
    constexpr double dt = 1e-9;
    for (std::size_t i = 0; i < 4; ++i) {
      corners.v[i] = shapes.vector();
      corners.w[i] = shapes.vector();
      u.segment<3>(6 * static_cast<int>(i)) = dt * corners.v[i];
      u.segment<3>(6 * static_cast<int>(i) + 3) = dt * corners.w[i];
    }
    (void)shell.step(corners, dt);
    for (std::size_t g = 0; g < 4; ++g)
      for (std::size_t layer = 0; layer < 2; ++layer) {
        const Eigen::Matrix<double, 8, 1> e = twin.strains(g) * u;
        const double z = thickness / 2 * shell.properties.layers[layer].place;
        const double exx = e[0] + z * e[3], eyy = e[1] + z * e[4], plate = young / (1 - poisson * poisson);
        const Symmetric& s = shell.points[2 * g + layer].stress;
        EXPECT_NEAR(s[xx], plate * (exx + poisson * eyy), 1e-13);
        EXPECT_NEAR(s[yy], plate * (eyy + poisson * exx), 1e-13);
        EXPECT_NEAR(s[xy], young / 2.6 * (e[2] + z * e[5]), 1e-13);
        EXPECT_NEAR(s[zx], young / 2.6 * e[6], 1e-13);
        EXPECT_NEAR(s[yz], young / 2.6 * e[7], 1e-13);
      }
  }
}

// Six rigid motions and the rotation of each corner about its own normal: no other motion is free.
TEST(FullShell, NoHourglassModes) {
  Shapes shapes;
  for (int trial = 0; trial < 40; ++trial) {
    const std::array<Vector, 4> x = shapes.next(0.25, trial % 2 == 0 ? 0 : 0.2);
    const Eigen::VectorXd values = eigenvalues(FullShellTwin(x, young, poisson).stiffness(thickness, 5.0 / 6));
    EXPECT_LT(std::abs(values[9]), 1e-10);
    EXPECT_GT(values[10], 1e-2) << trial;
  }
}

// The order of the corners does not matter for small strains: only the axes turn with it.
TEST(FullShell, SmallStrainsDoNotDependOnTheFirstCorner) {
  Shapes shapes;
  const std::array<Vector, 4> x = shapes.next(0.25, 0.2), turned{x[1], x[2], x[3], x[0]}, back{x[0], x[3], x[2], x[1]};
  const Eigen::MatrixXd k = shell_stiffness(full_shell(), x);
  const auto reorder = [](const Eigen::MatrixXd& a, std::array<int, 4> place) {
    Eigen::MatrixXd result(24, 24);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        result.block<6, 6>(6 * place[i], 6 * place[j]) =
            a.block<6, 6>(6 * static_cast<int>(i), 6 * static_cast<int>(j));
    return result;
  };
  EXPECT_LT((reorder(shell_stiffness(full_shell(), turned), {1, 2, 3, 0}) - k).norm(), 1e-7 * k.norm());
  EXPECT_LT((reorder(shell_stiffness(full_shell(), back), {0, 3, 2, 1}) - k).norm(), 1e-7 * k.norm());
}

/// Net forces and moments on the nodes of an irregular patch of five quads after a small step of v and w.
struct Patch {
  std::vector<Vector> x{{0, 0, 0}, {10, 0, 0}, {10, 6, 0}, {0, 6, 0}, {2, 1.5, 0}, {7, 2, 0}, {6.5, 4, 0}, {3, 4.5, 0}};
  std::vector<Vector> force = std::vector<Vector>(8, Vector::Zero()), moment = force;

  template <class V, class W>
  Patch(const V& v, const W& w) {
    constexpr std::array<std::array<std::size_t, 4>, 5> elements{
        {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}};
    constexpr double dt = 1e-12;
    for (const auto& element : elements) {
      ShellCorners corners;
      for (std::size_t i = 0; i < 4; ++i) {
        corners.x[i] = x[element[i]];
        corners.v[i] = v(x[element[i]]);
        corners.w[i] = w(x[element[i]]);
      }
      OneShell shell = full_shell();
      const ShellForces forces = shell.step(corners, dt);
      for (std::size_t i = 0; i < 4; ++i) {
        force[element[i]] += forces.force[i] / dt;
        moment[element[i]] += forces.moment[i] / dt;
      }
    }
  }
};

TEST(FullShellPatch, Membrane) {
  const Patch patch([](const Vector& x) { return Vector(x.x() + 0.5 * x.y(), -0.4 * x.y(), 0); },
                    [](const Vector&) { return Vector(0, 0, 0); });
  for (std::size_t i = 4; i < 8; ++i) EXPECT_NEAR(patch.force[i].norm(), 0, 1e-6) << i;
  const double stress = young / (1 - poisson * poisson) * (1 - poisson * 0.4), shear = young / 2.6 * 0.5;
  EXPECT_NEAR((patch.force[1] + patch.force[2]).x(), stress * thickness * 6, 1e-5);
  EXPECT_NEAR((patch.force[1] + patch.force[2]).y(), shear * thickness * 6, 1e-5);
}

// Constant curvature and twist (w = x²/2 + 0.7 x y): no force anywhere, no moment inside, the plate's on the sides.
TEST(FullShellPatch, Bending) {
  constexpr double twist = 0.7;
  const Patch patch([](const Vector& x) { return Vector(0, 0, x.x() * x.x() / 2 + twist * x.x() * x.y()); },
                    [](const Vector& x) { return Vector(twist * x.x(), -x.x() - twist * x.y(), 0); });
  for (std::size_t i = 4; i < 8; ++i) EXPECT_NEAR(patch.moment[i].norm(), 0, 1e-6) << i;
  for (const Vector& f : patch.force) EXPECT_NEAR(f.norm(), 0, 1e-6);
  const double plate = young * std::pow(thickness, 3) / 12 / (1 - poisson * poisson);
  EXPECT_NEAR((patch.moment[1] + patch.moment[2]).y(), -plate * 6, 1e-6);
  EXPECT_NEAR((patch.moment[1] + patch.moment[2]).x(), plate * (1 - poisson) * twist * 6, 1e-6);
}

// w = x without rotation: a constant transverse shear.
TEST(FullShellPatch, TransverseShear) {
  const Patch patch([](const Vector& x) { return Vector(0, 0, x.x()); }, [](const Vector&) { return Vector(0, 0, 0); });
  for (std::size_t i = 4; i < 8; ++i) EXPECT_NEAR(patch.force[i].norm(), 0, 1e-6) << i;
  EXPECT_NEAR((patch.force[1] + patch.force[2]).z(), 5.0 / 6 * young / 2.6 * thickness * 6, 1e-6);
}

// Turned through a whole circle about any axis, a warped and stressed quad keeps its stresses: forces turn with it.
TEST(FullShell, RigidRotationIsFree) {
  const Vector axis = Vector(1, -2, 0.5).normalized();
  for (const bool triangle : {false, true}) {
    std::array<Vector, 4> x{Vector(0, 0, 0.1), {2, 0.1, -0.1}, {2.3, 1.7, 0.3}, {-0.2, 1.5, -0.2}};
    if (triangle) x[3] = x[2];
    OneShell shell = full_shell();
    ShellCorners corners = at_rest(x);
    corners.v[2] = {0.01, 0.02, 0.003};
    corners.v[3] = triangle ? corners.v[2] : Vector(0, 0.01, 0);
    corners.w[1] = {0.01, -0.01, 0.02};
    const ShellForces first = shell.step(corners, 1e-3);
    const std::vector<PointState> stressed = shell.points;
    const ShellForces last = turn_around(shell, corners, axis, [](const ShellForces&) {});
    for (std::size_t p = 0; p < stressed.size(); ++p)
      for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(shell.points[p].stress[c], stressed[p].stress[c], 1e-10);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR((last.force[i] - first.force[i]).norm(), 0, 1e-10);
      EXPECT_NEAR((last.moment[i] - first.moment[i]).norm(), 0, 1e-10);
    }
  }
}

TEST(FullShell, ForcesAreInBalance) {
  Shapes shapes;
  for (int trial = 0; trial < 50; ++trial) {
    ShellCorners corners = at_rest(shapes.next(0.25, 0.3));
    for (std::size_t i = 0; i < 4; ++i) {
      corners.v[i] = shapes.vector();
      corners.w[i] = shapes.vector();
    }
    OneShell shell = full_shell();
    const ShellForces forces = shell.step(corners, 1e-3);
    Vector force = Vector::Zero(), moment = Vector::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      force += forces.force[i];
      moment += corners.x[i].cross(forces.force[i]) + forces.moment[i];
    }
    EXPECT_NEAR(force.norm(), 0, 1e-13);
    EXPECT_NEAR(moment.norm(), 0, 1e-13);
  }
}

// Couples in the plane of one rectangle: M = E t b³/12 κ, whatever its sides. Bilinear strains alone would give
// (1 + (1 − ν)/2 (a/b)²)/(1 − ν²) times as much, one point nothing but hourglass resistance.
TEST(FullShell, BendsInItsPlane) {
  for (const double a : {1.0, 10.0, 0.1})
    for (const double b : {1.0, 2.0}) {
      const std::array<Vector, 4> x{Vector(0, 0, 0), {a, 0, 0}, {a, b, 0}, {0, b, 0}};
      const Eigen::MatrixXd k = FullShellTwin(x, young, poisson).stiffness(thickness, 1),
                            own = shell_stiffness(full_shell(), x);
      Eigen::VectorXd u = Eigen::VectorXd::Zero(24);  // κ = 1: the ends turn by ± a/2
      for (int i = 0; i < 4; ++i) u[6 * i] = (i % 2 == 0 ? 1 : -1) * a * b / 4;
      const double exact = young * thickness * b * b * b / 12 * a;
      EXPECT_NEAR(u.dot(k * u) / exact, 1, 1e-12) << a << " " << b;
      EXPECT_NEAR(u.dot(own * u) / exact, 1, 1e-6) << a << " " << b;
    }
}

// Bent in its plane until all four points yield: they lie at ± b/√12, and their strain across is −ν of that along.
TEST(FullShell, PlasticMomentInItsPlane) {
  constexpr double yield = 1, a = 2, b = 1;
  OneShell shell(full_shell_of(plastic_kinematic(1, young, poisson, yield, 0, 1)), thickness, full_forces);
  const std::array<Vector, 4> x{Vector(0, 0, 0), {a, 0, 0}, {a, b, 0}, {0, b, 0}};
  ShellCorners corners = at_rest(x);
  ShellForces forces;
  constexpr double dt = 1e-3;
  for (int i = 0; i < 100; ++i) {
    for (std::size_t c = 0; c < 4; ++c) {
      corners.v[c].x() = c % 2 == 0 ? 1e-1 : -1e-1;
      corners.x[c] += dt * corners.v[c];
    }
    forces = shell.step(corners, dt);
  }
  const double along = 2 - poisson, across = 1 - 2 * poisson;
  const double share = (along - poisson * across) / std::sqrt(along * along + across * across - along * across);
  const double exact = share * yield * thickness * b * b / std::sqrt(12.0);
  const double moment = (forces.force[2].x() - forces.force[1].x()) / 2 * b;
  EXPECT_NEAR(std::abs(moment) / exact, 1, 0.03);
}

// Bent out of its plane far beyond yield with no strain across: 2/√3 σ₀ t²/4.
TEST(FullShell, PlasticMoment) {
  OneShell shell(full_shell_of(plastic_kinematic(1, young, 0, 1, 0, 1), 10), thickness, full_forces);
  ShellCorners corners = at_rest({Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  corners.w[1].y() = corners.w[2].y() = 1;
  corners.v[1].z() = corners.v[2].z() = -0.5;
  ShellForces forces;
  for (int i = 0; i < 100; ++i) forces = shell.step(corners, 0.01);
  const double full = 2 / std::numbers::sqrt3 * thickness * thickness / 4;
  EXPECT_NEAR((forces.moment[1].y() + forces.moment[2].y()) / full, 1, 0.015);
}

TEST(FullShell, ThicknessFollowsTheStrain) {
  for (const bool thins : {true, false}) {
    OneShell shell = full_shell();
    shell.properties.thins = thins;
    std::array<Vector, 4> x{Vector(0, 0, 0), {1.3, 0, 0}, {1, 1.2, 0}, {0, 1, 0}};
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
    for (const PointState& point : shell.points)
      EXPECT_NEAR(point.stress[xx], young / (1 - poisson) * std::log(1.2), 1e-4);
  }
}

// The bound holds for the free element whatever its shape, warp and thickness, and is not far off.
TEST(FullShell, StableStepIsABound) {
  Shapes shapes;
  double worst = 1;
  for (int trial = 0; trial < 600; ++trial) {
    std::array<Vector, 4> x = shapes.next(trial % 7 == 0 ? 0.05 : 0.3, trial % 2 == 0   ? 0
                                                                       : trial % 4 == 1 ? 0.05
                                                                                        : 0.3);
    if (trial % 5 == 0) x[3] = x[2];
    if (trial % 3 == 0)
      for (Vector& corner : x) corner.x() *= 6;
    const double h = trial % 11 == 0 ? 1.5 : 0.05;
    OneShell shell = full_shell(trial % 2 == 0 ? 0.3 : 0, h);
    const ShellForces forces = shell.step(at_rest(x), 0);
    if (!forces.good) continue;  // not convex
    const bool triangle = x[3] == x[2];
    const double share = shell_area(x) * h / (triangle ? 3 : 4), inertia = rotational_inertia(shell_area(x), h);
    Eigen::MatrixXd k = FullShellTwin(x, young, shell.properties.material.poisson).stiffness(h, 5.0 / 6);
    if (triangle) {  // corners 3 and 4 move together
      Eigen::MatrixXd join = Eigen::MatrixXd::Identity(24, 18);
      join.block<6, 6>(18, 12).setIdentity();
      k = join.transpose() * k * join;
    }
    Eigen::VectorXd root(k.rows());
    for (int i = 0; i < k.rows(); ++i) root[i] = 1 / std::sqrt(share * (i % 6 < 3 ? 1 : inertia));
    const double highest = std::sqrt(eigenvalues(root.asDiagonal() * k * root.asDiagonal())[k.rows() - 1]);
    EXPECT_LE(forces.stable_step, 2 / highest * (1 + 1e-9)) << trial;
    worst = std::min(worst, forces.stable_step * highest / 2);
    if (trial % 4 != 3) {
      EXPECT_GE(forces.stable_step, 0.5 * 2 / highest) << trial;
    }
  }
  RecordProperty("least_share_of_the_exact_step", fmt::format("{:.3f}", worst));
}

// L = A / longest side, of triangles twice that, c² = E / (ρ (1 − ν²)).
TEST(FullShell, ManualTimeStep) {
  const double speed = std::sqrt(young / (1 - poisson * poisson));
  OneShell shell = full_shell();
  EXPECT_NEAR(shell.step(at_rest({Vector(0, 0, 0), {3, 0, 0}, {3, 2, 0}, {0, 2, 0}}), 0).manual_step, 2 / speed, 1e-12);
  EXPECT_NEAR(shell.step(at_rest({Vector(0, 0, 0), {3, 0, 0}, {3, 4, 0}, {3, 4, 0}}), 0).manual_step, 2.4 / speed,
              1e-12);
}

// The energy that the stresses hold is the work that made them.
TEST(FullShell, StoresTheWorkDone) {
  Shapes shapes;
  const std::array<Vector, 4> x = shapes.next(0.2, 0.2);
  OneShell shell = full_shell();
  ShellCorners corners = at_rest(x);
  constexpr double dt = 1e-6;
  for (std::size_t i = 0; i < 4; ++i) {
    corners.v[i] = shapes.vector();
    corners.w[i] = shapes.vector();
  }
  const ShellForces forces = shell.step(corners, dt);
  double work = 0;
  for (std::size_t i = 0; i < 4; ++i)
    work += dt / 2 * (forces.force[i].dot(corners.v[i]) + forces.moment[i].dot(corners.w[i]));
  EXPECT_NEAR(full_stored_energy(shell.properties, shell.state, x, shell.points) / work, 1, 1e-5);
}

TEST(FullShell, BadShapesAreTold) {
  const auto good = [](const std::array<Vector, 4>& x) { return full_shell().step(at_rest(x), 0).good; };
  EXPECT_TRUE(good({Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_TRUE(good({Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {1, 1, 0}}));
  EXPECT_FALSE(good({Vector(0, 0, 0), {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
  EXPECT_FALSE(good({Vector(0, 0, 0), {1, 0, 0}, {1, NAN, 0}, {0, 1, 0}}));
  EXPECT_FALSE(good({Vector(0, 0, 0), {1, 0, 0}, {0.05, 0.05, 0}, {0, 1, 0}})) << "a point where it is folded over";
}

}  // namespace
}  // namespace gapcheck::solver::shell_full_test
