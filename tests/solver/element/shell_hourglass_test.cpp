// Hourglass control of quads in closed form: stiffness after Belytschko, Lin and Tsay (1984), eq. 24, and viscosity.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/element/shell_stiffness.hpp"

namespace gapcheck::solver::shell_hourglass_test {
namespace {

constexpr double young = 1000, poisson = 0.3, density = 2, thickness = 0.2, share = 0.1, shear_factor = 5.0 / 6;
constexpr double length = 2, width = 1, area = length * width;
/// Σ B² of a rectangle: its derivatives are ±1/2L and ±1/2W at all four corners.
constexpr double sum_b = 1 / (length * length) + 1 / (width * width);
constexpr double dt = 1e-8;
/// All modes move the corners by this; the rate of a mode is Σ of its squares.
constexpr std::array<double, 4> mode{1, -1, 1, -1};
constexpr double rate = 4;

ShellProperties properties(HourglassKind kind) {
  ShellProperties p;
  p.material = elastic_material(young, poisson);
  p.material.density = density;
  p.hourglass = {kind, share};
  p.shear_factor = shear_factor;
  return p;
}

struct Mode {
  const char* name;
  bool turns;  ///< corners turn instead of moving
  int axis;
  double stiffness, viscosity;
};

double membrane_viscosity() {
  return share / 4 * density * std::sqrt(young / (1 - poisson * poisson) / density) * thickness * std::sqrt(area);
}

std::array<Mode, 5> modes() {
  const double shear = young / 2 / (1 + poisson), cube = thickness * thickness * thickness, c = membrane_viscosity();
  const double membrane = share * young * thickness * area * sum_b / 8,
               turn = share * young * cube * area * sum_b / 192;
  const double deflection = share * shear_factor * shear * cube * sum_b / 12;
  const double thin = thickness * thickness;
  return {Mode{"membrane x", false, 0, membrane, c}, Mode{"membrane y", false, 1, membrane, c},
          Mode{"deflection", false, 2, deflection, c * thin / area}, Mode{"rotation x", true, 0, turn, c * thin / 12},
          Mode{"rotation y", true, 1, turn, c * thin / 12}};
}

ShellCorners moved(const Mode& m) {
  ShellCorners corners;
  corners.x = {Vector(0, 0, 0), {length, 0, 0}, {length, width, 0}, {0, width, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    corners.v[i] = corners.w[i] = Vector::Zero();
    (m.turns ? corners.w : corners.v)[i][m.axis] = mode[i];
  }
  return corners;
}

/// Every corner gets `size` times its share of the mode, along its axis, and nothing else.
void expect_forces(const ShellForces& forces, const Mode& m, double size) {
  for (std::size_t i = 0; i < 4; ++i) {
    Vector expected = Vector::Zero();
    expected[m.axis] = mode[i] * size;
    EXPECT_NEAR(((m.turns ? forces.moment : forces.force)[i] - expected).norm(), 0, 1e-6 * size) << m.name << i;
    EXPECT_NEAR((m.turns ? forces.force : forces.moment)[i].norm(), 0, 1e-6 * size) << m.name << i;
  }
}

TEST(ShellHourglass, StiffnessOfEachMode) {
  for (const Mode& m : modes()) {
    OneShell shell(properties(HourglassKind::stiffness), thickness);
    const ShellForces forces = shell.step(moved(m), dt);
    const double stress = m.stiffness * rate * dt;
    expect_forces(forces, m, stress);
    EXPECT_NEAR(forces.hourglass_work, dt * rate * stress / 2, 1e-6 * dt * rate * stress) << m.name;
    EXPECT_EQ(forces.dissipated, 0) << m.name;
  }
}

TEST(ShellHourglass, ViscosityOfEachMode) {
  for (const Mode& m : modes()) {
    OneShell shell(properties(HourglassKind::viscous), thickness);
    const double stress = m.viscosity * rate;
    expect_forces(shell.step(moved(m), dt), m, stress);
    const ShellForces again = shell.step(moved(m), dt);
    expect_forces(again, m, stress);
    EXPECT_NEAR(again.hourglass_work, dt * rate * stress, 1e-6 * dt * rate * stress) << m.name;
    EXPECT_NEAR(again.dissipated, again.hourglass_work, 1e-9 * again.hourglass_work) << m.name;
  }
}

// Thick shells: the deflection mode is as viscous as the membrane, no more.
TEST(ShellHourglass, ViscosityOfDeflectionIsBounded) {
  OneShell shell(properties(HourglassKind::viscous), 3);
  const Mode deflection = modes()[2];
  const double stress = membrane_viscosity() / thickness * 3 * rate;
  EXPECT_NEAR(shell.step(moved(deflection), dt).force[0].z(), stress, 1e-6 * stress);
}

// QM, QB and QW: of membrane, rotation and deflection.
TEST(ShellHourglass, CoefficientOfEachKind) {
  for (const HourglassKind kind : {HourglassKind::stiffness, HourglassKind::viscous}) {
    ShellProperties all = properties(kind);
    all.hourglass.coefficient = 2 * share;
    all.hourglass.bending = 3 * share;
    all.hourglass.warping = 5 * share;
    for (const Mode& m : modes()) {
      OneShell shell(all, thickness);
      const double factor = m.turns ? 3 : m.axis == 2 ? 5 : 2;
      const double stress = kind == HourglassKind::viscous ? m.viscosity * rate : m.stiffness * rate * dt;
      expect_forces(shell.step(moved(m), dt), m, factor * stress);
    }
  }
}

// In metres instead of millimetres the same shell has the same forces.
TEST(ShellHourglass, DoesNotDependOnTheUnitOfLength) {
  const Mode deflection = modes()[2];
  const auto force = [&](double unit) {
    ShellProperties all = properties(HourglassKind::stiffness);
    all.material = elastic_material(young / (unit * unit), poisson, density / (unit * unit * unit));
    OneShell shell(all, unit * thickness);
    ShellCorners corners = moved(deflection);
    for (std::size_t i = 0; i < 4; ++i) {
      corners.x[i] *= unit;
      corners.v[i] *= unit;
    }
    return shell.step(corners, dt).force[0].z();
  };
  EXPECT_NEAR(force(1e-3) / force(1), 1, 1e-6);
}

TEST(ShellHourglass, NoControlGivesNoForce) {
  for (const Mode& m : modes()) {
    OneShell shell(properties(HourglassKind::none), thickness);
    const ShellForces forces = shell.step(moved(m), dt);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(forces.force[i].norm(), 0, 1e-15) << m.name;
      EXPECT_NEAR(forces.moment[i].norm(), 0, 1e-15) << m.name;
    }
  }
}

}  // namespace
}  // namespace gapcheck::solver::shell_hourglass_test
