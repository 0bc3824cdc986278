#pragma once
#include <cstdint>
#include <vector>

#include "base/ids.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// A rigid body as forces see it.
struct BodyState {
  double mass = 0;
  Vector center = Vector::Zero(), velocity = Vector::Zero();
  Vector spin = Vector::Zero(), angular_momentum = Vector::Zero();
  Matrix inertia = Matrix::Zero();  ///< about the centre
  unsigned imposed = 0;  ///< freedoms that follow no force: bits 0 … 2: x y z, bits 3 … 5: rotations about them
  Vector push_response = Vector::Zero();  ///< velocity by axis of a unit impulse at the centre
  Matrix turn_response = Matrix::Zero();  ///< spin of an impulse's torque
};

/// Elements that have failed; by position in the model, if the structure has the element.
struct FailedElements {
  std::vector<bool> shells, solids, beams;
  std::uint64_t count = 0;
};

/// ω² dt² of elements at 0.9 of their critical step.
constexpr double usual_share = 4 * 0.9 * 0.9;

/// Everything that moves; arrays by node. Velocities belong to the middle of the step that led to `time`
/// (central difference), positions to `time` itself.
struct State {
  std::vector<Vector> x, v, w;        ///< w: angular velocity
  std::vector<double> mass, inertia;  ///< lumped; inertia is the same about all axes
  std::vector<std::uint32_t> body;  ///< by node: position in `bodies` of the one that it moves with; no_position: none
  std::vector<BodyState> bodies;    ///< rigid bodies; forces act on their nodes or their centres
  double time = 0, dt = 0;          ///< dt: of the last step, 0 before the first
  double coming = 0;                ///< the step that the elements allow next; known when other forces are called
  /// What the manual's step lengths alone allow, which is never less than `coming`: contact springs that follow the
  /// step (SOFT = 1 and 2) take it, so that they are as stiff as LS-DYNA's.
  double manual_step = 0;
  double elements_share = usual_share;  ///< ω² dt² of the elements at that step, at most; 4 is the bound of stability
  std::uint64_t cycle = 0;
  bool relaxing = false;  ///< in a dynamic relaxation, whose time and cycles are its own and end before the run's begin
  bool relaxed = false;   ///< the run began with one
  FailedElements failed;  ///< these no longer take part; their mass stays at their nodes
  [[nodiscard]] bool in_body(std::size_t node) const { return node < body.size() && body[node] != no_position; }
};

/// Force and moment by node, and by rigid body at its centre.
struct Forces {
  std::vector<Vector> force, moment;
  std::vector<Vector> body_force, body_moment;
  void resize(std::size_t nodes, std::size_t bodies = 0) {
    force.assign(nodes, Vector::Zero());
    moment.assign(nodes, Vector::Zero());
    body_force.assign(bodies, Vector::Zero());
    body_moment.assign(bodies, Vector::Zero());
  }
};

/// Work that forces other than the elements' took from the structure since the start; negative: work that they put in.
struct Absorbed {
  double contact_normal = 0, contact_friction = 0, contact_damping = 0;
  double walls = 0;    ///< rigid walls
  double springs = 0;  ///< discrete springs and dampers
  double damping = 0;  ///< of the system: *DAMPING_GLOBAL
  [[nodiscard]] double sliding() const { return contact_normal + contact_friction + contact_damping; }
  [[nodiscard]] double sum() const { return sliding() + walls + springs + damping; }
};

/// Energies at the time of the last force evaluation, with two kinetic energies. That of the balance is ½ m v⁻·v⁺ with
/// the velocities before and after the evaluation: with works by the trapezoidal rule the sum is then constant to
/// rounding while the step is (Belytschko, Liu, Moran: Nonlinear Finite Elements, 6.2), but it may be negative. What is
/// printed is ½ m v₀² of the initial velocity at the start, and later the same, but never below zero. The printed
/// internal energy is without the work of the bulk viscosity, as in LS-DYNA (read off a run), and so is the printed
/// total.
struct Energies {
  double kinetic = 0, internal = 0, hourglass = 0;
  double printed_kinetic = 0;
  double bulk_viscosity = 0;  ///< its work; part of internal
  Absorbed absorbed;
  double external = 0;  ///< work of loads and prescribed motion since the start
  double initial = 0;   ///< kinetic energy at the start
  double printed_initial = 0;
  [[nodiscard]] double total() const { return kinetic + internal + hourglass + absorbed.sum(); }
  /// Total energy over initial energy plus external work; 1 when in balance or without energy.
  [[nodiscard]] double ratio() const {
    const double supplied = initial + external;
    return supplied == 0 ? 1 : total() / supplied;
  }
  [[nodiscard]] double printed_internal() const { return internal - bulk_viscosity; }
  [[nodiscard]] double printed_total() const { return total() + (printed_kinetic - kinetic) - bulk_viscosity; }
  [[nodiscard]] double printed_ratio() const {
    const double supplied = printed_initial + external;
    return supplied == 0 ? 1 : printed_total() / supplied;
  }
};

}  // namespace gapcheck::solver
