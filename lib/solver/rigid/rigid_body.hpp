#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// A point mass; bodies are sums of these.
struct PointMass {
  Vector x;
  double mass;
};

/// The motion in a step of a body's degrees of freedom that do not follow from forces.
struct Imposed {
  unsigned freedoms = 0;  ///< bits 0 … 2: x y z, bits 3 … 5: rotations about them
  Vector velocity = Vector::Zero(), spin = Vector::Zero();
};

/// Result of accelerating a body.
struct Push {
  double kinetic = 0, printed_kinetic = 0;                 ///< energies: see Energies
  Vector force = Vector::Zero(), torque = Vector::Zero();  ///< beyond the given ones: needed to impose motions
};

/// A body that only translates and rotates. Velocities belong to the middle of steps, positions to their ends.
class RigidBody {
 public:
  RigidBody() = default;
  /// Mass, centre and inertia of point masses. A body whose points lie on a line has no inertia about it and gets a
  /// small one (1e-6 of the greatest). `spin`: inertia that adds the same about all axes.
  RigidBody(std::span<const PointMass> points, double spin);

  /// A body of given mass and inertia about its centre. Principal inertias below 1e-6 of the greatest are raised to it.
  RigidBody(double mass, Vector center, const Matrix& inertia);

  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] const Vector& center() const { return center_; }
  [[nodiscard]] const Matrix& rotation() const { return rotation_; }  ///< from the start's axes to the present ones
  [[nodiscard]] Matrix inertia() const { return rotation_ * inertia_ * rotation_.transpose(); }
  [[nodiscard]] const Vector& velocity() const { return velocity_; }
  [[nodiscard]] const Vector& angular_momentum() const { return momentum_; }
  [[nodiscard]] Vector angular_velocity() const;
  void set_motion(const Vector& velocity, const Vector& angular_velocity);

  /// What a unit impulse changes: the velocity by axis; the spin as a matrix on the impulse's torque. `freedoms`:
  /// imposed ones.
  [[nodiscard]] Vector push_response(unsigned freedoms) const;
  [[nodiscard]] Matrix turn_response(unsigned freedoms) const;

  /// Velocity and angular momentum over `mean`, the mean of the steps before and after; the kinetic energy is the one
  /// in between, ½ m V⁻·V⁺ + ½ L⁻·ω⁺. If rotations are imposed, the others follow from I (ω⁺ − ω⁻) / mean = T − ω̄ × I
  /// ω̄, ω̄ = (ω⁻ + ω⁺) / 2, whose gyroscopic torque does no work; the body then turns about ω⁺ over the step, which
  /// keeps ω·Iω: energies balance to rounding while the step is constant. `first`: the present velocity belongs to this
  /// very time, ⁻ is its mirror.
  Push accelerate(const Vector& force, const Vector& torque, double mean, const Imposed& imposed, bool first = false);

  /// Moves and turns over dt. The rotation of a free body is the implicit midpoint rule of Euler's equations with the
  /// Cayley map (Austin, Krishnaprasad and Wang, J. Comput. Phys. 107, 1993): it conserves the angular momentum and the
  /// kinetic energy to rounding; if rotations are imposed, it is the rotation about ω by |ω| dt. Returns the rotation
  /// of the step as the vector w of spin_rotation(w).
  Vector move(double dt);

  /// The present position of a point with these initial coordinates, relative to the centre.
  [[nodiscard]] Vector place(const Vector& local) const { return center_ + rotation_ * local; }

 private:
  void set_inertia(const Matrix& inertia);
  /// Sets the angular momentum if rotations are imposed; returns the required addition to the torque.
  Vector turn(const Vector& torque, double mean, const Imposed& imposed);
  double mass_ = 0;
  bool guided_ = false;  ///< rotations are imposed in the present step
  Vector center_ = Vector::Zero(), velocity_ = Vector::Zero(), momentum_ = Vector::Zero();
  Matrix rotation_ = Matrix::Identity(), inertia_ = Matrix::Identity(), inverse_ = Matrix::Identity();
};

}  // namespace gapcheck::solver
