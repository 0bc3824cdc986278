#include "solver/rigid/rigid_body.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace gapcheck::solver {

RigidBody::RigidBody(std::span<const PointMass> points, double spin) {
  for (const auto& [x, mass] : points) {
    mass_ += mass;
    center_ += mass * x;
  }
  if (mass_ > 0) center_ /= mass_;
  Matrix inertia = spin * Matrix::Identity();
  for (const auto& [x, mass] : points) {
    const Vector r = x - center_;
    inertia += mass * (r.squaredNorm() * Matrix::Identity() - r * r.transpose());
  }
  set_inertia(inertia);
}

RigidBody::RigidBody(double mass, Vector center, const Matrix& inertia) : mass_(mass), center_(std::move(center)) {
  set_inertia(inertia);
}

void RigidBody::set_inertia(const Matrix& inertia) {
  const Eigen::SelfAdjointEigenSolver<Matrix> axes(inertia);
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

Vector RigidBody::push_response(unsigned freedoms) const {
  Vector response = Vector::Constant(mass_ > 0 ? 1 / mass_ : 0);
  for (int axis = 0; axis < 3; ++axis)
    if ((freedoms >> axis & 1u) != 0) response[axis] = 0;
  return response;
}

Matrix RigidBody::turn_response(unsigned freedoms) const {
  if (freedoms >> 3 == 0) return rotation_ * inverse_ * rotation_.transpose();
  Matrix system = inertia(), given = Matrix::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    if ((freedoms >> (axis + 3) & 1u) == 0) continue;
    system.row(axis) = Vector::Unit(axis).transpose();
    given(axis, axis) = 0;
  }
  return system.inverse() * given;
}

Vector RigidBody::turn(const Vector& torque, double mean, const Imposed& imposed) {
  const Matrix inertia = this->inertia();
  const Vector old = angular_velocity();
  Matrix system = inertia;
  for (int axis = 0; axis < 3; ++axis)
    if ((imposed.freedoms >> (axis + 3) & 1u) != 0) system.row(axis) = Vector::Unit(axis).transpose();
  const Matrix inverse = system.inverse();
  Vector spin = old;
  // The gyroscopic torque changes little per iteration: by about the angle of the step.
  constexpr int most_rounds = 30;
  for (int round = 0; round < most_rounds; ++round) {
    const Vector middle = (old + spin) / 2;
    Vector change = mean * (torque - middle.cross(inertia * middle));
    for (int axis = 0; axis < 3; ++axis)
      if ((imposed.freedoms >> (axis + 3) & 1u) != 0) change[axis] = imposed.spin[axis] - old[axis];
    const Vector next = old + inverse * change;
    const bool settled = (next - spin).squaredNorm() <= 1e-32 * next.squaredNorm();
    spin = next;
    if (settled) break;
  }
  momentum_ = inertia * spin;
  return inertia * (spin - old) / mean - torque;
}

Push RigidBody::accelerate(const Vector& force, const Vector& torque, double mean, const Imposed& imposed, bool first) {
  Push push;
  Vector before = velocity_, spin_before = momentum_;
  const Vector turn_before = angular_velocity();
  if (mass_ > 0) velocity_ += force / mass_ * mean;
  for (int axis = 0; axis < 3; ++axis) {
    if ((imposed.freedoms >> axis & 1u) == 0) continue;
    velocity_[axis] = imposed.velocity[axis];
    push.force[axis] = mass_ * (velocity_[axis] - before[axis]) / mean - force[axis];
  }
  guided_ = imposed.freedoms >> 3 != 0;
  if (guided_)
    push.torque = turn(torque, mean, imposed);
  else
    momentum_ += torque * mean;
  const double moving = first ? before.squaredNorm() : before.dot(velocity_);
  const double turning = first ? spin_before.dot(turn_before) : spin_before.dot(angular_velocity());
  push.printed_kinetic = mass_ / 2 * moving + turning / 2;
  if (first) {
    before = 2 * before - velocity_;
    spin_before = 2 * spin_before - momentum_;
  }
  push.kinetic = mass_ / 2 * before.dot(velocity_) + spin_before.dot(angular_velocity()) / 2;
  return push;
}

Vector RigidBody::move(double dt) {
  center_ += dt * velocity_;
  if (guided_) {
    const Vector spin = angular_velocity();
    const double angle = spin.norm() * dt;
    if (!(angle > 0)) return Vector::Zero();
    rotation_ = Eigen::AngleAxisd(angle, spin.normalized()).toRotationMatrix() * rotation_;
    momentum_ = inertia() * spin;
    return 2 * std::tan(angle / 2) * spin.normalized();
  }
  const Vector start = rotation_.transpose() * momentum_;
  Vector end = start, turn = dt * (inverse_ * start);
  // Contracts by about the angle of the step; a few iterations for any reasonable step.
  constexpr int most_rounds = 60;
  for (int round = 0; round < most_rounds; ++round) {
    const Vector next = spin_rotation(-turn) * start;
    const bool settled = (next - end).squaredNorm() <= 1e-32 * start.squaredNorm();
    end = next;
    turn = dt / 2 * (inverse_ * (start + end));
    if (settled) break;
  }
  Vector global = rotation_ * turn;
  rotation_ = rotation_ * spin_rotation(turn);
  return global;
}

}  // namespace gapcheck::solver
