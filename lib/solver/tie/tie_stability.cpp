#include "solver/tie/tie_stability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

double least_inertia(const RigidBody& body) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(body.inertia(), Eigen::EigenvaluesOnly).eigenvalues()[0];
}

}  // namespace

// Positions of rows: translations of nodes, their rotations, bodies. Anything without mass is held, or does not move.

void TieStability::move(NodeIndex node, double share) {
  const auto body = structure_.rigid.body_of(node.value);
  const std::size_t nodes = structure_.state.x.size();
  if (!body) {
    const double mass = structure_.state.mass[node.value];
    if (mass > 0) parts_.push_back({node.value, share / std::sqrt(mass)});
    return;
  }
  const RigidBody& rigid = structure_.rigid[*body];
  const double radius = (structure_.state.x[node.value] - rigid.center()).norm(), inertia = least_inertia(rigid);
  double per_force = rigid.mass() > 0 ? 1 / rigid.mass() : 0;
  if (inertia > 0) per_force += radius * radius / inertia;
  parts_.push_back({2 * nodes + *body, share * std::sqrt(per_force)});
}

void TieStability::turn(NodeIndex node, double share) {
  const auto body = structure_.rigid.body_of(node.value);
  const std::size_t nodes = structure_.state.x.size();
  const double inertia = body ? least_inertia(structure_.rigid[*body]) : structure_.state.inertia[node.value];
  if (inertia > 0) parts_.push_back({body ? 2 * nodes + *body : nodes + node.value, share / std::sqrt(inertia)});
}

void TieStability::begin(double stiffness) { springs_.push_back({parts_.size(), 0, stiffness, 0}); }

void TieStability::finish() {
  Spring& spring = springs_.back();
  spring.last = parts_.size();
  for (std::size_t i = spring.first; i < spring.last; ++i) spring.sum += parts_[i].size;
}

void TieStability::add(const Tie& tie, const SegmentAxes& axes, const Vector& arm, double stiffness,
                       double rotational) {
  const double length = arm.norm();
  begin(stiffness);
  move(tie.node, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight = tie.point.weights[i];
    double share = weight;
    if (tie.offset == Turning::axes) share += length * axes.turn[i].norm();
    if (share != 0) move(tie.point.nodes[i], share);
    if (tie.offset == Turning::nodes && weight * length != 0) turn(tie.point.nodes[i], weight * length);
  }
  finish();
  begin(rotational);
  if (tie.rotations) {
    turn(tie.node, 1);
    for (std::size_t i = 0; i < 4; ++i) {
      const bool by_nodes = tie.rotation == Turning::nodes || tie.rotation == Turning::drill;
      if (tie.rotation == Turning::axes) move(tie.point.nodes[i], axes.turn[i].norm());
      if (tie.rotation == Turning::drill) move(tie.point.nodes[i], (axes.drill() * axes.turn[i]).norm());
      if (by_nodes && tie.point.weights[i] != 0) turn(tie.point.nodes[i], tie.point.weights[i]);
    }
  }
  finish();
}

std::vector<double> TieStability::rows(const std::vector<double>& shares) const {
  std::vector<double> rows(2 * structure_.state.x.size() + structure_.rigid.size(), 0);
  for (std::size_t s = 0; s < springs_.size(); ++s)
    for (std::size_t i = springs_[s].first; i < springs_[s].last; ++i)
      rows[parts_[i].mass] += shares[s] * springs_[s].stiffness * parts_[i].size * springs_[s].sum;
  return rows;
}

std::vector<double> TieStability::shares(double greatest) const {
  std::vector<double> shares(springs_.size(), 1);
  const std::vector<double> all = rows(shares);
  for (std::size_t s = 0; s < springs_.size(); ++s)
    for (std::size_t i = springs_[s].first; i < springs_[s].last; ++i)
      if (const double row = all[parts_[i].mass]; !(row <= greatest)) shares[s] = std::min(shares[s], greatest / row);
  return shares;
}

double TieStability::squared_frequency(const std::vector<double>& shares) const {
  double largest = 0;
  for (const double row : rows(shares)) largest = std::max(largest, row);
  return largest;
}

}  // namespace gapcheck::solver
