#include "solver/rigid_body.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

namespace gapcheck::solver {

RigidBody::RigidBody(std::span<const PointMass> points, double spin) {
  for (const auto& [x, mass] : points) {
    mass_ += mass;
    center_ += mass * x;
  }
  if (mass_ > 0) center_ /= mass_;
  inertia_ = spin * Matrix::Identity();
  for (const auto& [x, mass] : points) {
    const Vector r = x - center_;
    inertia_ += mass * (r.squaredNorm() * Matrix::Identity() - r * r.transpose());
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> axes(inertia_);
  const double greatest = axes.eigenvalues()[2];
  const Vector principal = axes.eigenvalues().cwiseMax(greatest > 0 ? 1e-6 * greatest : 1);
  inertia_ = axes.eigenvectors() * principal.asDiagonal() * axes.eigenvectors().transpose();
  inverse_ = axes.eigenvectors() * principal.cwiseInverse().asDiagonal() * axes.eigenvectors().transpose();
}

Vector RigidBody::angular_velocity() const { return rotation_ * (inverse_ * (rotation_.transpose() * momentum_)); }

void RigidBody::set_motion(const Vector& velocity, const Vector& angular_velocity) {
  velocity_ = velocity;
  momentum_ = inertia() * angular_velocity;
}

double RigidBody::accelerate(const Vector& force, const Vector& torque, double mean, unsigned held, bool first) {
  Vector before = velocity_, spin_before = momentum_;
  if (mass_ > 0) velocity_ += force / mass_ * mean;
  momentum_ += torque * mean;
  for (int axis = 0; axis < 3; ++axis) {
    if ((held >> axis & 1u) != 0) velocity_[axis] = 0;
    if ((held >> (axis + 3) & 1u) != 0) momentum_[axis] = 0;
  }
  if (first) {
    before = 2 * before - velocity_;
    spin_before = 2 * spin_before - momentum_;
  }
  return mass_ / 2 * before.dot(velocity_) + spin_before.dot(angular_velocity()) / 2;
}

Vector RigidBody::move(double dt) {
  center_ += dt * velocity_;
  const Vector start = rotation_.transpose() * momentum_;
  Vector end = start, turn = dt * (inverse_ * start);
  // Contracts by about the angle of the step; a handful of rounds for any step that makes sense.
  constexpr int most_rounds = 60;
  for (int round = 0; round < most_rounds; ++round) {
    const Vector next = spin_rotation(-turn) * start;
    const bool settled = (next - end).squaredNorm() <= 1e-32 * start.squaredNorm();
    end = next;
    turn = dt / 2 * (inverse_ * (start + end));
    if (settled) break;
  }
  const Vector global = rotation_ * turn;
  rotation_ = rotation_ * spin_rotation(turn);
  return global;
}

}  // namespace gapcheck::solver
