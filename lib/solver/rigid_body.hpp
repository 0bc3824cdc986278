#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "solver/tensor.hpp"

namespace gapcheck::solver {

/// A mass at a point; what bodies are summed up from.
struct PointMass {
  Vector x;
  double mass;
};

/// A body that only moves and turns. Velocities belong to the middle of steps, positions to their ends.
class RigidBody {
 public:
  RigidBody() = default;
  /// Mass, centre and inertia of point masses. A body whose points lie on a line has no inertia about it, and is given
  /// a small one (1e-6 of the greatest). `spin`: inertia that adds the same about all axes.
  RigidBody(std::span<const PointMass> points, double spin);

  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] const Vector& center() const { return center_; }
  [[nodiscard]] const Matrix& rotation() const { return rotation_; }  ///< from the start's axes to the present ones
  [[nodiscard]] Matrix inertia() const { return rotation_ * inertia_ * rotation_.transpose(); }
  [[nodiscard]] const Vector& velocity() const { return velocity_; }
  [[nodiscard]] const Vector& angular_momentum() const { return momentum_; }
  [[nodiscard]] Vector angular_velocity() const;
  void set_motion(const Vector& velocity, const Vector& angular_velocity);

  /// Velocity and angular momentum over `mean`, the mean of the steps before and after; returns the kinetic energy in
  /// between, ½ m V⁻·V⁺ + ½ L⁻·I⁻¹ L⁺. Directions with a bit in `held` (x y z, rotations about them) stay at rest.
  /// `first`: the velocity so far is that of this very time, ⁻ is its mirror.
  double accelerate(const Vector& force, const Vector& torque, double mean, unsigned held, bool first = false);

  /// Moves and turns freely over dt. The rotation is the implicit midpoint rule of Euler's equations with the Cayley
  /// map (Austin, Krishnaprasad and Wang, J. Comput. Phys. 107, 1993): it keeps the angular momentum and the kinetic
  /// energy to rounding. Returns the turn of the step as the vector w of spin_rotation(w).
  Vector move(double dt);

  /// Where a point with these coordinates at the start, relative to the centre, is now.
  [[nodiscard]] Vector place(const Vector& local) const { return center_ + rotation_ * local; }

 private:
  double mass_ = 0;
  Vector center_ = Vector::Zero(), velocity_ = Vector::Zero(), momentum_ = Vector::Zero();
  Matrix rotation_ = Matrix::Identity(), inertia_ = Matrix::Identity(), inverse_ = Matrix::Identity();
};

}  // namespace gapcheck::solver
