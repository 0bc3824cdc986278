#include "solver/rigid/rigid_bodies.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace gapcheck::solver {

std::size_t RigidBodies::add(std::vector<PointMass> points, std::span<const NodeIndex> nodes, const State& state) {
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
  for (const NodeIndex node : entry.nodes) entry.local.emplace_back(state.x[node.value] - entry.body.center());
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

Imposed RigidBodies::Body::imposed(double time, double dt) const {
  Imposed result;
  result.freedoms = held;
  for (const auto& [freedom, motion] : motions) {
    if (!motion.active(time, dt)) continue;
    result.freedoms |= 1u << freedom;
    (freedom < 3 ? result.velocity : result.spin)[static_cast<int>(freedom % 3)] = motion.velocity(time, dt);
  }
  return result;
}

void RigidBodies::move(std::size_t body, std::size_t freedom, Motion motion) {
  bodies_[body].motions.emplace_back(freedom, std::move(motion));
}

void RigidBodies::begin_phase(bool relaxing) {
  for (Body& body : bodies_)
    for (auto& [freedom, motion] : body.motions) motion.relaxing = relaxing;
}

void RigidBodies::set_mass(std::size_t body, double mass, const Vector& center, const Matrix& inertia,
                           const State& state) {
  Body& entry = bodies_[body];
  entry.body = RigidBody(mass, center, inertia);
  for (std::size_t i = 0; i < entry.nodes.size(); ++i) entry.local[i] = state.x[entry.nodes[i].value] - center;
}

void RigidBodies::start(State& state) {
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const RigidBody& body = bodies_[b].body;
    const Imposed imposed = bodies_[b].imposed(state.time, 0);
    if (imposed.freedoms == 0) continue;
    Vector velocity = body.velocity(), spin = body.angular_velocity();
    for (int axis = 0; axis < 3; ++axis) {
      if ((imposed.freedoms >> axis & 1u) != 0) velocity[axis] = imposed.velocity[axis];
      if ((imposed.freedoms >> (axis + 3) & 1u) != 0) spin[axis] = imposed.spin[axis];
    }
    set_motion(b, velocity, spin, state);
  }
  tell(state);
}

void RigidBodies::tell(State& state) const {
  if (state.body.size() != of_node_.size()) state.body = of_node_;
  state.bodies.resize(bodies_.size());
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const RigidBody& body = bodies_[b].body;
    const unsigned imposed = bodies_[b].imposed(state.time, 0).freedoms;
    state.bodies[b] = {body.mass(),
                       body.center(),
                       body.velocity(),
                       body.angular_velocity(),
                       body.angular_momentum(),
                       body.inertia(),
                       imposed,
                       body.push_response(imposed),
                       body.turn_response(imposed)};
  }
}

std::vector<const RigidBody*> RigidBodies::views() const {
  std::vector<const RigidBody*> views;
  views.reserve(bodies_.size());
  for (const Body& entry : bodies_) views.push_back(&entry.body);
  return views;
}

void RigidBodies::add_joint(RigidJoint joint) { joints_.add(std::move(joint), views()); }

BodyLoad RigidBodies::load_on(std::size_t body, const State& state, const Forces& net, double next) const {
  const Body& entry = bodies_[body];
  BodyLoad load{net.body_force[body], net.body_moment[body], entry.imposed(state.time, next)};
  for (const NodeIndex node : entry.nodes) {
    const Vector& push = net.force[node.value];
    load.force += push;
    load.torque += net.moment[node.value] + (state.x[node.value] - entry.body.center()).cross(push);
  }
  return load;
}

/// The torque that imposes a rotation also balances the gyroscopic one, which does no work.
RigidBodies::Response RigidBodies::response_of(const Body& entry, const RigidBody& before, const Push& push,
                                               double mean) {
  const RigidBody& body = entry.body;
  const Vector spin_before = before.angular_velocity(), spin_after = body.angular_velocity();
  Response response;
  response.acceleration = (body.velocity() - before.velocity()) / mean;
  response.spin_rate = (spin_after - spin_before) / mean;
  response.reaction = push.force;
  const Vector middle = (spin_before + spin_after) / 2;
  if (push.torque != Vector::Zero()) response.reaction_moment = push.torque + middle.cross(body.inertia() * middle);
  return response;
}

Vector RigidBodies::acceleration_at(std::size_t body, const Vector& x) const {
  const Body& entry = bodies_[body];
  const Vector arm = x - entry.body.center(), spin = entry.body.angular_velocity();
  return entry.response.acceleration + entry.response.spin_rate.cross(arm) + spin.cross(spin.cross(arm));
}

BodyEnergies RigidBodies::accelerate(const State& state, const Forces& net, double mean, double next, bool first) {
  std::vector<BodyEnergies> energy(bodies_.size());
  std::vector<BodyLoad> loads(bodies_.size());
  parallel_for(bodies_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) loads[b] = load_on(b, state, net, next);
  });
  std::vector<BodyLoad> jointed;
  if (!joints_.list().empty()) {
    jointed = loads;
    joints_.solve(views(), jointed, mean, next);
  }
  parallel_for(bodies_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      Body& entry = bodies_[b];
      RigidBody& body = entry.body;
      const BodyLoad& load = jointed.empty() ? loads[b] : jointed[b];
      const Vector velocity = body.velocity(), spin = body.angular_velocity();
      const RigidBody before = body;
      const Push push = body.accelerate(load.force, load.torque, mean, load.imposed, first);
      Vector extra_force = net.body_force[b] + push.force, extra_torque = net.body_moment[b] + push.torque;
      if (!jointed.empty()) {  // the work of joints, zero but for rounding, counts as external
        extra_force += load.force - loads[b].force;
        extra_torque += load.torque - loads[b].torque;
      }
      energy[b].kinetic = push.kinetic;
      energy[b].printed_kinetic = push.printed_kinetic;
      energy[b].work = state.dt / 2 * (entry.power + extra_force.dot(velocity) + extra_torque.dot(spin));
      entry.power = extra_force.dot(body.velocity()) + extra_torque.dot(body.angular_velocity());
      entry.response = response_of(entry, before, push, mean);
      if (entry.nodes.size() == 2) entry.response.link = link_force(entry, before, state, net, mean);
      if (entry.strength.limited()) entry.failing = link_fails(entry, state);
    }
  });
  BodyEnergies sum;
  for (const BodyEnergies& part : energy) {
    sum.kinetic += part.kinetic;
    sum.printed_kinetic += part.printed_kinetic;
    sum.work += part.work;
  }
  return sum;
}

void RigidBodies::move(State& state, double dt) {
  const bool released = std::any_of(bodies_.begin(), bodies_.end(), [](const Body& entry) { return entry.failing; });
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
  if (released) state.body.clear();
  tell(state);
}

}  // namespace gapcheck::solver
