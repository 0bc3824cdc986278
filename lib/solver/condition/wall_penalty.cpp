#include "solver/condition/wall_penalty.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/quad.hpp"
#include "contact/rigid_wall.hpp"
#include "contact/stiffness/element_sizes.hpp"
#include "contact/stiffness/stiffness.hpp"

namespace gapcheck::solver {
namespace {

/// Most that an impulse at a point of a body changes the point's velocity.
double compliance_at(const RigidBody& body, const Vector& x) {
  if (!(body.mass() > 0)) return 0;
  const double least = Eigen::SelfAdjointEigenSolver<Matrix>(body.inertia(), Eigen::EigenvaluesOnly).eigenvalues()[0];
  return 1 / body.mass() + (least > 0 ? (x - body.center()).squaredNorm() / least : 0);
}

}  // namespace

void PenaltyNodes::sum_stiffness() {
  const model::Mesh& mesh = model_.mesh;
  const contact::ElementSizes sizes = contact::element_sizes(model_);
  std::vector<contact::NodeStiffness> sums(mesh.nodes.size());
  const auto give = [&](const auto& nodes, double weight, double stiffness) {
    if (!(weight > 0) || !(stiffness > 0)) return;
    for (const NodeIndex node : nodes)
      if (node.value < sums.size()) sums[node.value] += {weight, weight * stiffness};
  };
  const auto modulus = [&](PartIndex part) {
    return part.value < model_.parts.size() ? contact::contact_modulus(model_, part) : 0;
  };
  for (std::size_t i = 0; i < mesh.solids.size(); ++i) {
    const double area = std::pow(sizes.solid_volume[i], 2.0 / 3);
    give(mesh.solids.nodes[i], area,
         contact::solid_segment_stiffness(1, modulus(mesh.solids.part[i]), area, sizes.solid_volume[i]));
  }
  for (std::size_t i = 0; i < mesh.shells.size(); ++i)
    give(mesh.shells.nodes[i], sizes.shell_area[i],
         contact::shell_segment_stiffness(1, modulus(mesh.shells.part[i]), sizes.shell_area[i],
                                          longest_diagonal(mesh.shells.nodes[i], mesh.nodes.x)));
  stiffness_.assign(sums.size(), 0);
  double total = 0;
  std::size_t known = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    stiffness_[i] = sums[i].value();
    if (!(stiffness_[i] > 0)) continue;
    total += stiffness_[i];
    ++known;
  }
  for (double& stiffness : stiffness_)
    if (!(stiffness > 0) && known > 0) stiffness = total / static_cast<double>(known);
}

std::vector<PenaltyNode> PenaltyNodes::of(const std::vector<NodeIndex>& nodes, double scale) {
  if (stiffness_.empty()) sum_stiffness();
  std::vector<PenaltyNode> result;
  const State& state = structure_.state;
  for (const NodeIndex node : nodes) {
    PenaltyNode entry;
    entry.node = node.value;
    entry.stiffness = 0.1 * std::abs(scale) * stiffness_[node.value];
    const auto body = structure_.rigid.body_of(node.value);
    if (body) {
      entry.body = static_cast<std::uint32_t>(*body);
      entry.compliance = compliance_at(structure_.rigid[*body], state.x[node.value]);
    } else if (state.mass[node.value] > 0) {
      entry.compliance = 1 / state.mass[node.value];
    }
    if (entry.compliance > 0 && entry.stiffness > 0) result.push_back(entry);
  }
  return result;
}

PenaltySums push_by_penalty(const WallInStep& wall, const Vector& shift, const State& state, bool active,
                            std::vector<PenaltyNode>& nodes, std::vector<Vector>& force) {
  PenaltySums sums;
  for (PenaltyNode& entry : nodes) {
    const Vector& x = state.x[entry.node];
    Vector push = Vector::Zero();
    const auto behind = active ? contact::wall_penetration(wall.data, x, 0) : std::nullopt;
    if (behind) {
      const double normal = entry.stiffness * behind->depth;
      push = normal * behind->normal;
      const Vector here = x - shift;
      if (!entry.touches) entry.anchor = here;
      Vector slip = here - entry.anchor;
      slip -= slip.dot(behind->normal) * behind->normal;
      const double speed = (state.v[entry.node] - wall.velocity).norm();
      const Vector friction = wall.friction.impulse(slip, speed, normal, entry.stiffness * slip.norm());
      entry.anchor = here + friction / entry.stiffness;
      push += friction;
      sums.normal_force += normal;
      ++sums.touching;
    }
    entry.touches = behind.has_value();
    sums.work -= state.dt / 2 * (entry.force + push).dot(state.v[entry.node] - wall.velocity);
    entry.force = push;
    force[entry.node] += push;
    sums.force += push;
  }
  return sums;
}

double penalty_step(const std::vector<PenaltyNode>& nodes, std::size_t bodies, double wall) {
  constexpr double room = 0.76, alone = 1.8 * 1.8;  // of ω² dt²
  std::vector<double> squares(bodies, 0);
  double step = std::numeric_limits<double>::infinity(), at_wall = 0;
  for (const PenaltyNode& entry : nodes) {
    if (!entry.touches) continue;
    at_wall += 2 * wall * entry.stiffness;  // the spring along the surface counts as well
    if (entry.body < bodies)
      squares[entry.body] += 2 * entry.stiffness * entry.compliance;
    else
      step = std::min(step, std::sqrt(room / (entry.stiffness * entry.compliance)));
  }
  for (const double square : squares)
    if (square > 0) step = std::min(step, std::sqrt(alone / (square + at_wall)));
  return step;
}

}  // namespace gapcheck::solver
