#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solver/rigid/rigid_body.hpp"

namespace gapcheck::solver {

/// What acts on a body in a step.
struct BodyLoad {
  Vector force = Vector::Zero(), torque = Vector::Zero();
  Imposed imposed;
};

/// A joint between two bodies: each row keeps one quantity as it is at the start. `along`: the distance of a point of B
/// from one of A in a direction that turns with A. `angle`: the product of a direction that turns with A and one that
/// turns with B; both have length 1.
struct RigidJoint {
  struct Row {
    bool angle = false;
    Vector of_a, of_b;  ///< directions in the axes of the bodies; of_b: of angles
    double start = 0;
  };
  std::size_t a = 0, b = 0;  ///< bodies
  Vector point_a, point_b;   ///< from the centres, in the axes of the bodies
  std::vector<Row> rows;
  std::vector<double> impulse;                             ///< by row, in the last step; torque of angles
  Vector force = Vector::Zero(), moment = Vector::Zero();  ///< on B at its point, in the last step
};

/// The joints of rigid bodies as constraints (Lagrange multipliers; LS-DYNA Theory Manual, joints, has them and
/// penalties): forces and torques that are the same on both bodies, at one point, so that the rows have their values at
/// the end of the step. The end is that of RigidBody::accelerate() and move(); Newton's steps with the matrix of the
/// step's start. This is SHAKE (Ryckaert, Ciccotti and Berendsen, J. Comput. Phys. 23, 1977) for rigid bodies. Rows
/// that repeat others share their force.
class RigidJoints {
 public:
  /// Call it when the bodies are as they start; the rows' `start` is set here.
  void add(RigidJoint joint, std::span<const RigidBody* const> bodies);
  [[nodiscard]] const std::vector<RigidJoint>& list() const { return joints_; }
  /// Adds the joints' forces of the step to the loads; by body.
  void solve(std::span<const RigidBody* const> bodies, std::span<BodyLoad> loads, double mean, double next);
  /// How far the rows are from their values, at most.
  [[nodiscard]] double error(std::span<const RigidBody* const> bodies) const;

 private:
  std::vector<RigidJoint> joints_;
  std::vector<std::vector<std::size_t>> groups_;  ///< joints that bodies connect
};

}  // namespace gapcheck::solver
