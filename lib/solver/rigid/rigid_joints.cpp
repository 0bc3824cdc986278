#include "solver/rigid/rigid_joints.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/union_find.hpp"

namespace gapcheck::solver {
namespace {

double value_of(const RigidJoint& joint, const RigidJoint::Row& row, const RigidBody& a, const RigidBody& b) {
  const Vector along = a.rotation() * row.of_a;
  if (row.angle) return along.dot(b.rotation() * row.of_b);
  return along.dot(b.place(joint.point_b) - a.place(joint.point_a));
}

/// How a row's force and torque act on one of its bodies.
struct Arm {
  Eigen::Index row = 0;
  Vector force = Vector::Zero(), torque = Vector::Zero();   ///< of a unit of the row's force
  Vector velocity = Vector::Zero(), spin = Vector::Zero();  ///< what a unit impulse changes
};

/// The rows of joints that bodies connect, during a step.
class JointStep {
 public:
  JointStep(std::vector<RigidJoint>& joints, const std::vector<std::size_t>& members,
            std::span<const RigidBody* const> bodies, std::span<BodyLoad> loads, double mean, double next)
      : joints_(joints), bodies_(bodies), loads_(loads), mean_(mean), next_(next) {
    for (const std::size_t j : members)
      for (std::size_t r = 0; r < joints_[j].rows.size(); ++r) add_row(j, r);
    factorise();
  }
  void solve() {
    begin();
    constexpr int most_rounds = 8;
    for (int round = 0; round < most_rounds && improve(); ++round) {
    }
    for (const auto& [body, arms] : arms_) loads_[body] = load_on(body, arms);
    store();
  }

 private:
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(rows_.size()); }
  [[nodiscard]] const std::pair<std::size_t, std::size_t>& row_at(Eigen::Index i) const {
    return rows_[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] RigidJoint& joint_of(Eigen::Index i) const { return joints_[row_at(i).first]; }

  void add_row(std::size_t j, std::size_t r) {
    const RigidJoint& joint = joints_[j];
    const RigidBody &a = *bodies_[joint.a], &b = *bodies_[joint.b];
    const Vector at = b.place(joint.point_b), along = a.rotation() * joint.rows[r].of_a;
    for (const bool second : {false, true}) {
      const std::size_t position = second ? joint.b : joint.a;
      const RigidBody& body = *bodies_[position];
      const double sign = second ? 1 : -1;
      Arm arm;
      arm.row = size();
      if (joint.rows[r].angle) {
        arm.torque = sign * (b.rotation() * joint.rows[r].of_b).cross(along);
      } else {
        arm.force = sign * along;
        arm.torque = (at - body.center()).cross(arm.force);
      }
      const unsigned imposed = loads_[position].imposed.freedoms;
      arm.velocity = body.push_response(imposed).cwiseProduct(arm.force);
      arm.spin = body.turn_response(imposed) * arm.torque;
      arms_[position].push_back(arm);
    }
    rows_.emplace_back(j, r);
  }

  void factorise() {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size(), size());
    for (const auto& [body, arms] : arms_)
      for (const Arm& one : arms)
        for (const Arm& other : arms)
          matrix(one.row, other.row) += one.force.dot(other.velocity) + one.torque.dot(other.spin);
    scale_ = matrix.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 0.0; });
    matrix = (scale_.asDiagonal() * matrix * scale_.asDiagonal()).eval();
    matrix.diagonal().setOnes();
    inverse_.compute(matrix);
    // Rows that repeat others leave the matrix singular: what they share is left out, as a pseudo-inverse does.
    constexpr double least = 1e-8;
    if (inverse_.vectorD().minCoeff() > least) return;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(matrix);
    Eigen::Index first = 0;
    while (first < size() && !(modes.eigenvalues()[first] > least)) ++first;
    modes_ = modes.eigenvectors().rightCols(size() - first);
    values_ = modes.eigenvalues().tail(size() - first);
  }

  [[nodiscard]] bool singular() const { return modes_.rows() > 0; }
  [[nodiscard]] Eigen::VectorXd solution(const Eigen::VectorXd& right) const {
    if (!singular()) return inverse_.solve(right);
    return modes_ * (modes_.transpose() * right).cwiseQuotient(values_);
  }

  /// Begins with the impulses of the last step.
  void begin() {
    impulse_.resize(size());
    for (Eigen::Index i = 0; i < size(); ++i)
      impulse_[i] = scale_[i] > 0 ? joint_of(i).impulse[row_at(i).second] / scale_[i] : 0;
    if (singular()) impulse_ = (modes_ * (modes_.transpose() * impulse_)).eval();
    impulse_ = impulse_.cwiseProduct(scale_).eval();
  }

  [[nodiscard]] BodyLoad load_on(std::size_t body, const std::vector<Arm>& arms) const {
    BodyLoad load = loads_[body];
    for (const Arm& arm : arms) {
      load.force += impulse_[arm.row] / mean_ * arm.force;
      load.torque += impulse_[arm.row] / mean_ * arm.torque;
    }
    return load;
  }

  /// One of Newton's steps; false if there is nothing to improve.
  bool improve() {
    std::map<std::size_t, RigidBody> ends;
    for (const auto& [body, arms] : arms_) {
      const BodyLoad load = load_on(body, arms);
      RigidBody end = *bodies_[body];
      end.accelerate(load.force, load.torque, mean_, load.imposed);
      end.move(next_);
      ends.emplace(body, std::move(end));
    }
    Eigen::VectorXd excess(size());
    double most = 0;
    for (Eigen::Index i = 0; i < size(); ++i) {
      const RigidJoint& joint = joint_of(i);
      const RigidJoint::Row& row = joint.rows[row_at(i).second];
      const RigidBody& a = ends.at(joint.a);
      excess[i] = value_of(joint, row, a, ends.at(joint.b)) - row.start;
      const double rounding = row.angle ? 1 : a.center().norm() + joint.point_a.norm() + joint.point_b.norm() + 1e-300;
      if (scale_[i] > 0) most = std::max(most, std::abs(excess[i]) / rounding);
    }
    if (!(most > 1e-15)) return false;
    const Eigen::VectorXd scaled = scale_.cwiseProduct(excess);
    impulse_ -= scale_.cwiseProduct(solution(scaled)) / next_;
    return true;
  }

  void store() {
    for (const auto& [j, r] : rows_) joints_[j].force = joints_[j].moment = Vector::Zero();
    for (Eigen::Index i = 0; i < size(); ++i) {
      RigidJoint& joint = joint_of(i);
      const RigidJoint::Row& row = joint.rows[row_at(i).second];
      joint.impulse[row_at(i).second] = impulse_[i];
      const Vector along = bodies_[joint.a]->rotation() * row.of_a;
      if (row.angle)
        joint.moment += impulse_[i] / mean_ * (bodies_[joint.b]->rotation() * row.of_b).cross(along);
      else
        joint.force += impulse_[i] / mean_ * along;
    }
  }

  std::vector<RigidJoint>& joints_;
  std::span<const RigidBody* const> bodies_;
  std::span<BodyLoad> loads_;
  double mean_, next_;
  std::vector<std::pair<std::size_t, std::size_t>> rows_;  ///< joint, row
  std::map<std::size_t, std::vector<Arm>> arms_;           ///< by body
  Eigen::LDLT<Eigen::MatrixXd> inverse_;
  Eigen::MatrixXd modes_;  ///< of a singular matrix, without those that it lacks; empty: it is regular
  Eigen::VectorXd values_;
  Eigen::VectorXd scale_;  ///< of the rows; 0: nothing moves
  Eigen::VectorXd impulse_;
};

}  // namespace

void RigidJoints::add(RigidJoint joint, std::span<const RigidBody* const> bodies) {
  joint.impulse.assign(joint.rows.size(), 0);
  for (RigidJoint::Row& row : joint.rows) row.start = value_of(joint, row, *bodies[joint.a], *bodies[joint.b]);
  joints_.push_back(std::move(joint));
  UnionFind sets(bodies.size());
  for (const RigidJoint& one : joints_)
    sets.unite(static_cast<std::uint32_t>(one.a), static_cast<std::uint32_t>(one.b));
  std::map<std::size_t, std::vector<std::size_t>> by_root;
  for (std::size_t i = 0; i < joints_.size(); ++i)
    by_root[sets.root(static_cast<std::uint32_t>(joints_[i].a))].push_back(i);
  groups_.clear();
  for (auto& [root, members] : by_root) groups_.push_back(std::move(members));
}

double RigidJoints::error(std::span<const RigidBody* const> bodies) const {
  double most = 0;
  for (const RigidJoint& joint : joints_)
    for (const RigidJoint::Row& row : joint.rows)
      most = std::max(most, std::abs(value_of(joint, row, *bodies[joint.a], *bodies[joint.b]) - row.start));
  return most;
}

void RigidJoints::solve(std::span<const RigidBody* const> bodies, std::span<BodyLoad> loads, double mean, double next) {
  for (const auto& group : groups_) JointStep(joints_, group, bodies, loads, mean, next).solve();
}

}  // namespace gapcheck::solver
