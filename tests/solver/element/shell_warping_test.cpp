// Warping stiffness of one-point quads (Belytschko, Wong and Chiang 1992) with drill and full projection, and the
// transverse shear from the sides (ELFORM 10).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

#include "solver/element/shell_strip.hpp"

namespace gapcheck::solver::shell_warping_test {
namespace {

constexpr double young = 1000, poisson = 0.3, thickness = 0.1;

ShellProperties properties(ShellProjection projection, bool sides_shear = false) {
  ShellProperties all;
  all.material = elastic_material(young, poisson);
  all.hourglass = {HourglassKind::stiffness, 0.1};
  all.shear_factor = 5.0 / 6;
  all.projection = projection;
  all.sides_shear = sides_shear;
  return all;
}

using Quad = std::array<Vector, 4>;

/// A skewed quad whose corners are out of their plane by ± warp.
Quad quad(double warp) { return {Vector(0, 0, warp), {2, 0.1, -warp}, {2.3, 1.7, warp}, {-0.2, 1.5, -warp}}; }

// Nothing is projected out of a flat quad that strains it.
TEST(ShellWarping, FlatQuadsAreThoseOfBelytschkoAndTsay) {
  const Eigen::MatrixXd plain = shell_stiffness(OneShell(properties(ShellProjection::none), thickness), quad(0));
  for (const ShellProjection projection : {ShellProjection::drill, ShellProjection::full}) {
    const OneShell shell(properties(projection), thickness, warped_quad_forces);
    EXPECT_LT((shell_stiffness(shell, quad(0)) - plain).norm(), 1e-6 * plain.norm());
  }
}

// Rotations about the normals at the corners have no stiffness, in flat and in warped quads.
TEST(ShellWarping, DrillingIsFree) {
  const Quad x = quad(0.1);
  const Eigen::MatrixXd k =
      shell_stiffness(OneShell(properties(ShellProjection::drill), thickness, warped_quad_forces), x);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector normal = Vector(x[(i + 1) % 4] - x[i]).cross(x[(i + 3) % 4] - x[i]).normalized();
    Eigen::VectorXd drill = Eigen::VectorXd::Zero(24);
    drill.segment<3>(6 * static_cast<int>(i) + 3) = normal;
    EXPECT_LT((k * drill).norm(), 1e-6 * k.norm()) << i;
  }
}

/// The largest force by a turn about any axis, over the stiffness.
double forces_of_turns(ShellProjection projection, const Quad& x) {
  const Eigen::MatrixXd k = shell_stiffness(OneShell(properties(projection), thickness, warped_quad_forces), x);
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::VectorXd turn(24);
    for (std::size_t i = 0; i < 4; ++i) {
      turn.segment<3>(6 * static_cast<int>(i)) = Vector::Unit(axis).cross(x[i]);
      turn.segment<3>(6 * static_cast<int>(i) + 3) = Vector::Unit(axis);
    }
    largest = std::max(largest, (k * turn).norm() / k.norm());
  }
  return largest;
}

// The full projection frees rigid rotations; after the drill projection alone a force remains that falls with the
// square of the warp (Belytschko and Leviathan 1994).
TEST(ShellWarping, TurnsOfWarpedQuads) {
  EXPECT_LT(forces_of_turns(ShellProjection::full, quad(0.1)), 1e-7);
  const auto rectangle = [](double warp) {
    return Quad{Vector(0, 0, warp), {2, 0, -warp}, {2, 1.5, warp}, {0, 1.5, -warp}};
  };
  const double much = forces_of_turns(ShellProjection::drill, rectangle(0.1)),
               little = forces_of_turns(ShellProjection::drill, rectangle(0.05));
  EXPECT_GT(little, 1e-6);
  EXPECT_GT(much / little, 3.5);
  EXPECT_LT(forces_of_turns(ShellProjection::drill, quad(0.05)), 0.02);
}

TEST(ShellWarping, FullTurnKeepsStresses) {
  const Vector axis = Vector(1, -2, 0.5).normalized();
  OneShell shell(properties(ShellProjection::full, true), thickness, warped_quad_forces);
  ShellCorners corners = at_rest(quad(0.15));
  corners.v[2] = {0.01, 0.02, 0.003};
  corners.w[1] = {0.01, -0.01, 0};
  const ShellForces first = shell.step(corners, 1e-3);
  const std::vector<PointState> stressed = shell.points;
  const ShellForces last = turn_around(shell, corners, axis, [](const ShellForces&) {});
  double scale = 0;
  for (const PointState& point : stressed) scale = std::max(scale, std::abs(point.stress[xx]));
  for (std::size_t p = 0; p < stressed.size(); ++p)
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(shell.points[p].stress[c], stressed[p].stress[c], 1e-8 * scale) << p << c;
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR((last.force[i] - first.force[i]).norm(), 0, 1e-8 * scale) << i;
}

// Forces have an energy; they and their moments balance with the full projection.
TEST(ShellWarping, SymmetryAndBalance) {
  for (const bool sides : {false, true})
    for (const ShellProjection projection : {ShellProjection::drill, ShellProjection::full}) {
      const Quad x = quad(0.2);
      const Eigen::MatrixXd k =
          shell_stiffness(OneShell(properties(projection, sides), thickness, warped_quad_forces), x);
      EXPECT_LT((k - k.transpose()).norm(), 1e-5 * k.norm());
      for (int column = 0; column < 24; ++column) {
        Vector force = Vector::Zero(), moment = Vector::Zero();
        for (int i = 0; i < 4; ++i) {
          const Vector f = k.block<3, 1>(6 * i, column);
          force += f;
          moment += x[static_cast<std::size_t>(i)].cross(f) + Vector(k.block<3, 1>(6 * i + 3, column));
        }
        EXPECT_LT(force.norm(), 1e-6 * k.norm());
        if (projection == ShellProjection::full) {
          EXPECT_LT(moment.norm(), 1e-6 * k.norm());
        }
      }
    }
}

TEST(ShellWarping, StableStepIsBelowTheHighestFrequency) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-0.25, 0.25);
  for (int trial = 0; trial < 120; ++trial) {
    Quad x{Vector(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (Vector& corner : x) corner += Vector(number(random), number(random), number(random) / 2);
    const double h = trial % 2 == 0 ? 0.02 : 0.2;
    const OneShell shell(properties(trial % 3 == 0 ? ShellProjection::drill : ShellProjection::full, trial % 5 < 2), h,
                         warped_quad_forces);
    const double share = shell_area(x) * h / 4, inertia = share * rotational_inertia(shell_area(x), h);
    Eigen::VectorXd root(24);
    for (int i = 0; i < 24; ++i) root[i] = 1 / std::sqrt(i % 6 < 3 ? share : inertia);
    const Eigen::MatrixXd k = shell_stiffness(shell, x);
    const Eigen::MatrixXd scaled = root.asDiagonal() * (k + k.transpose()) / 2 * root.asDiagonal();
    const double highest = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues()[23]);
    OneShell copy = shell;
    const double step = copy.step(at_rest(x), 0).stable_step;
    EXPECT_LE(step, 2 / highest * (1 + 1e-5)) << trial;
    EXPECT_GE(step, 0.4 * 2 / highest) << trial;
  }
}

Strip twisted_by(ShellProjection projection, bool sides, int n = 12) {
  Strip strip = twisted(n, 0.32);
  strip.properties.projection = projection;
  strip.properties.sides_shear = sides;
  strip.properties.hourglass = {HourglassKind::stiffness, 0.05, 0.05, 0.05};
  strip.kernel = projection == ShellProjection::none ? quad_forces : warped_quad_forces;
  return strip;
}

// MacNeal and Harder (1985), 12 x 2 quads: the plain element fails, whose quads count as flat.
TEST(ShellWarping, TwistedBeam) {
  const auto ratio = [](const char* name, ShellProjection projection, bool sides) {
    const Strip strip = twisted_by(projection, sides);
    const double in_plane = strip.tip({0, 0, 1}) / 5.424e-3, across = strip.tip({0, 1, 0}) / 1.754e-3;
    testing::Test::RecordProperty(std::string(name) + "_in_plane", fmt::format("{:.4f}", in_plane));
    testing::Test::RecordProperty(std::string(name) + "_out_of_plane", fmt::format("{:.4f}", across));
    return std::array<double, 2>{in_plane, across};
  };
  const auto plain = ratio("plain", ShellProjection::none, false);
  EXPECT_GT(std::max(plain[0], plain[1]), 1.5);
  for (const bool sides : {false, true})
    for (const ShellProjection projection : {ShellProjection::drill, ShellProjection::full})
      for (const double value : ratio(projection == ShellProjection::full ? "full" : "drill", projection, sides))
        EXPECT_NEAR(value, 1, 0.05);
}

/// Five quads with four free corners inside.
struct Patch {
  std::vector<Vector> x{{0, 0, 0}, {10, 0, 0}, {10, 6, 0}, {0, 6, 0}, {2, 1.5, 0}, {7, 2, 0}, {6.5, 4, 0}, {3, 4.5, 0}};
  std::vector<std::array<std::size_t, 4>> elements{
      {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
};

// Constant curvatures and twist on any mesh: no transverse shear, where the shear of the centre (ELFORM 2) has some.
TEST(ShellWarping, SidesShearPassesTheBendingPatch) {
  constexpr double dt = 1e-12;
  const auto moment_and_shear = [&](bool sides) {
    const Patch patch;
    std::vector<Vector> moment(patch.x.size(), Vector::Zero());
    double shear = 0;
    ShellProperties all = properties(ShellProjection::drill, sides);
    all.hourglass.kind = HourglassKind::none;
    for (const auto& element : patch.elements) {
      ShellCorners corners;
      for (std::size_t i = 0; i < 4; ++i) {
        const Vector x = corners.x[i] = patch.x[element[i]];
        corners.v[i] = Vector(0, 0, x.x() * x.x() / 2 + 0.7 * x.x() * x.y() - 0.2 * x.y() * x.y());
        corners.w[i] = Vector(0.7 * x.x() - 0.4 * x.y(), -x.x() - 0.7 * x.y(), 0);
      }
      OneShell shell(all, thickness, warped_quad_forces);
      const ShellForces forces = shell.step(corners, dt);
      for (std::size_t i = 0; i < 4; ++i) {
        moment[element[i]] += forces.moment[i];
        shear = std::max(shear, std::abs(forces.force[i].z()));
      }
    }
    double inside = 0;
    for (std::size_t i = 4; i < 8; ++i) inside = std::max(inside, moment[i].norm());
    return std::array<double, 2>{inside / dt, shear / dt};
  };
  const auto own = moment_and_shear(true), centre = moment_and_shear(false);
  EXPECT_LT(own[0], 1e-6);
  EXPECT_LT(own[1], 1e-6);
  EXPECT_GT(centre[1], 1e-2);
}

}  // namespace
}  // namespace gapcheck::solver::shell_warping_test
