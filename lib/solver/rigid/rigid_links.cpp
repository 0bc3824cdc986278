#include <cmath>

#include "solver/rigid/rigid_bodies.hpp"

namespace gapcheck::solver {

Vector RigidBodies::link_force(const Body& entry, const RigidBody& before, const State& state, const Forces& net,
                               double mean) {
  const std::uint32_t node = entry.nodes[0].value;
  const Vector arm = state.x[node] - entry.body.center();
  const Vector spin_before = before.angular_velocity(), spin_after = entry.body.angular_velocity();
  const Vector spin = (spin_before + spin_after) / 2;
  const Vector acceleration = (entry.body.velocity() - before.velocity()) / mean +
                              ((spin_after - spin_before) / mean).cross(arm) + spin.cross(spin.cross(arm));
  return state.mass[node] * acceleration - net.force[node];
}

bool RigidBodies::link_fails(const Body& entry, const State& state) {
  const LinkStrength& strength = entry.strength;
  if (strength.time > 0 && state.time >= strength.time) return true;
  if (entry.nodes.size() != 2) return false;
  const std::uint32_t node = entry.nodes[0].value;
  const Vector& pull = entry.response.link;
  const Vector link = state.x[entry.nodes[1].value] - state.x[node];
  const double length = link.norm();
  const double normal = length > 0 ? pull.dot(link) / length : 0;
  const double shear = length > 0 ? (pull - normal / length * link).norm() : pull.norm();
  double sum = 0;
  if (strength.normal > 0 && normal > 0) sum += std::pow(normal / strength.normal, strength.normal_power);
  if (strength.shear > 0) sum += std::pow(shear / strength.shear, strength.shear_power);
  return sum >= 1;
}

void RigidBodies::release(Body& entry) {
  for (const NodeIndex node : entry.nodes) of_node_[node.value] = no_position;
  entry = Body{};
}

}  // namespace gapcheck::solver
