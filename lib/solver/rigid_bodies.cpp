#include "solver/rigid_bodies.hpp"

#include "base/parallel.hpp"

namespace gapcheck::solver {

std::size_t RigidBodies::add(std::vector<PointMass> points, std::span<const NodeIndex> nodes, unsigned held,
                             const State& state) {
  Body entry;
  double spin = 0;
  const auto position = static_cast<std::uint32_t>(bodies_.size());
  for (const NodeIndex node : nodes) {
    if (holds(node.value)) continue;
    of_node_[node.value] = position;
    entry.nodes.push_back(node);
    if (state.mass[node.value] > 0) points.push_back({state.x[node.value], state.mass[node.value]});
    spin += state.inertia[node.value];
  }
  entry.body = RigidBody(points, spin);
  entry.held = held;
  for (const NodeIndex node : entry.nodes) entry.local.push_back(state.x[node.value] - entry.body.center());
  bodies_.push_back(std::move(entry));
  return position;
}

void RigidBodies::set_motion(std::size_t body, const Vector& velocity, const Vector& angular_velocity, State& state) {
  Body& entry = bodies_[body];
  entry.body.set_motion(velocity, angular_velocity);
  for (const NodeIndex node : entry.nodes) {
    state.v[node.value] = velocity + angular_velocity.cross(state.x[node.value] - entry.body.center());
    state.w[node.value] = angular_velocity;
  }
}

double RigidBodies::accelerate(const State& state, const Forces& net, double mean, bool first) {
  std::vector<double> energy(bodies_.size());
  parallel_for(bodies_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      Vector force = Vector::Zero(), torque = Vector::Zero();
      for (const NodeIndex node : bodies_[b].nodes) {
        const Vector& push = net.force[node.value];
        force += push;
        torque += net.moment[node.value] + (state.x[node.value] - bodies_[b].body.center()).cross(push);
      }
      Body& entry = bodies_[b];
      const RigidBody before = entry.body;
      energy[b] = entry.body.accelerate(force, torque, mean, entry.held, first);
      if (entry.strength.limited()) entry.failing = link_fails(entry, before, state, net, mean);
    }
  });
  double sum = 0;
  for (const double part : energy) sum += part;
  return sum;
}

void RigidBodies::move(State& state, double dt) {
  parallel_for(bodies_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      Body& entry = bodies_[b];
      const RigidBody before = entry.body;
      const Vector spin = entry.body.move(dt) / dt;
      for (std::size_t i = 0; i < entry.nodes.size(); ++i) {
        const std::uint32_t node = entry.nodes[i].value;
        state.x[node] = entry.body.place(entry.local[i]);
        state.v[node] = (state.x[node] - before.place(entry.local[i])) / dt;
        state.w[node] = spin;
      }
      if (entry.failing) release(entry);
    }
  });
}

}  // namespace gapcheck::solver
