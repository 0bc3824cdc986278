#pragma once
#include <cstdint>
#include <vector>

#include "solver/tensor.hpp"

namespace gapcheck::solver {

/// Everything that moves; arrays by node. Velocities belong to the middle of the step that led to `time`
/// (central difference), positions to `time` itself.
struct State {
  std::vector<Vector> x, v, w;        ///< w: angular velocity
  std::vector<double> mass, inertia;  ///< lumped; inertia is the same about all axes
  double time = 0, dt = 0;            ///< dt: of the last step, 0 before the first
  std::uint64_t cycle = 0;
};

/// Force and moment by node.
struct Forces {
  std::vector<Vector> force, moment;
  void resize(std::size_t nodes) {
    force.assign(nodes, Vector::Zero());
    moment.assign(nodes, Vector::Zero());
  }
};

/// Energies at the time of the last force evaluation. Kinetic energy is ½ m v⁻·v⁺ with the velocities before and after
/// it; with works by the trapezoidal rule the sum is then constant to rounding while the step is
/// (Belytschko, Liu, Moran: Nonlinear Finite Elements, 6.2).
struct Energies {
  double kinetic = 0, internal = 0, hourglass = 0;
  double external = 0;  ///< work of loads, contacts and prescribed motion since the start
  double initial = 0;   ///< kinetic energy at the start; less by ½ m (a dt/2)² than that of the initial velocity
  [[nodiscard]] double total() const { return kinetic + internal + hourglass; }
  /// Total energy over what was there or was put in; 1 when in balance or when there is none.
  [[nodiscard]] double ratio() const {
    const double supplied = initial + external;
    return supplied == 0 ? 1 : total() / supplied;
  }
};

}  // namespace gapcheck::solver
