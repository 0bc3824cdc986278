#pragma once
#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "solver/element/shell.hpp"

namespace gapcheck::solver {

using ShellKernel = ShellForces (*)(const ShellProperties&, const ShellCorners&, double, ShellState&,
                                    std::span<PointState>);

inline Material elastic_material(double young, double poisson, double density = 1) {
  return {MaterialKind::elastic, density, young, poisson, {}, 0, 0, 0};
}

/// An element with what it remembers; undeformed where its first step finds it.
struct OneShell {
  ShellProperties properties;
  ShellKernel kernel = quad_forces;
  ShellState state;
  std::vector<PointState> points;
  bool started = false;

  OneShell(ShellProperties all, double thickness, ShellKernel function = quad_forces)
      : properties(std::move(all)),
        kernel(function),
        points((function == full_forces ? 4 : 1) * properties.layers.size()) {
    state.thickness = thickness;
  }
  ShellForces step(const ShellCorners& corners, double dt) {
    if (!started && (kernel == quad_forces || kernel == warped_quad_forces))
      state.stiffness = hourglass_stiffness(properties, corners.x, state.thickness);
    started = true;
    return kernel(properties, corners, dt, state, points);
  }
};

inline ShellCorners at_rest(const std::array<Vector, 4>& x) {
  ShellCorners corners;
  corners.x = x;
  for (std::size_t i = 0; i < 4; ++i) corners.v[i] = corners.w[i] = Vector::Zero();
  return corners;
}

/// Turns a shell through a whole circle about `axis` in 200 rigid steps; `corners` follow. `check(forces)` sees each.
template <class Check>
ShellForces turn_around(OneShell& shell, ShellCorners& corners, const Vector& axis, const Check& check) {
  constexpr int steps = 200;
  const double angle = 2 * std::numbers::pi / steps, dt = 0.01;
  const Matrix turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  ShellForces last;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector next = turn * corners.x[i];
      corners.v[i] = (next - corners.x[i]) / dt;
      corners.x[i] = next;
      corners.w[i] = 2 * std::tan(angle / 2) / dt * axis;
    }
    last = shell.step(corners, dt);
    check(last);
  }
  return last;
}

/// Stiffness by a unit rate of each degree of freedom over a short step: 6 per corner, displacements first.
inline Eigen::MatrixXd shell_stiffness(const OneShell& shell, const std::array<Vector, 4>& x, double dt = 1e-8) {
  Eigen::MatrixXd stiffness(24, 24);
  for (int column = 0; column < 24; ++column) {
    OneShell copy = shell;
    ShellCorners corners = at_rest(x);
    const auto corner = static_cast<std::size_t>(column / 6);
    (column % 6 < 3 ? corners.v : corners.w)[corner][column % 3] = 1;
    const ShellForces forces = copy.step(corners, dt);
    for (int i = 0; i < 4; ++i) {
      stiffness.block<3, 1>(6 * i, column) = forces.force[static_cast<std::size_t>(i)] / dt;
      stiffness.block<3, 1>(6 * i + 3, column) = forces.moment[static_cast<std::size_t>(i)] / dt;
    }
  }
  return stiffness;
}

/// Area of a triangle (corners 3 and 4 equal) or flat quad.
inline double shell_area(const std::array<Vector, 4>& x) { return (x[2] - x[0]).cross(x[3] - x[1]).norm() / 2; }

}  // namespace gapcheck::solver
