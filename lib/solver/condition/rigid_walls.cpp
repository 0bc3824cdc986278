#include "solver/condition/rigid_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {
namespace {

/// A node's contribution to a wall's sums.
struct WallSums {
  Vector force = Vector::Zero();
  double normal_force = 0, work = 0;
  std::uint64_t touching = 0;
  void add(const WallSums& other) {
    force += other.force;
    normal_force += other.normal_force;
    work += other.work;
    touching += other.touching;
  }
};

/// A node before the wall reacts.
struct Moving {
  double mass;
  Vector x, velocity;  ///< velocity: over the next step, without walls
  std::uint8_t held;
};

/// `v` without its constrained components.
Vector freed(Vector v, std::uint8_t held) {
  for (int axis = 0; axis < 3; ++axis)
    if ((held >> axis & 1u) != 0) v[axis] = 0;
  return v;
}

struct Impulse {
  Vector sum = Vector::Zero();
  double normal = 0;
};

/// The wall's reaction on a node in one step.
Impulse wall_impulse(const model::RigidWall& wall, const Moving& node, double next) {
  const auto behind = contact::wall_penetration(wall, node.x + next * node.velocity, 0);
  if (!behind) return {};
  const Vector& normal = behind->normal;
  const double approach = -next * normal.dot(node.velocity);
  const double push = std::min(behind->depth, approach);  // nodes already behind stay there
  const double compliance = freed(normal, node.held).dot(normal);
  constexpr double least_compliance = 1e-6;  // below, constraints hold the node against the wall
  if (!(push > 0) || !(compliance > least_compliance)) return {};
  Impulse impulse;
  impulse.normal = node.mass * push / next / compliance;
  impulse.sum = impulse.normal * normal;
  if (wall.friction <= 0) return impulse;
  const Vector free = freed(node.velocity + freed(impulse.sum, node.held) / node.mass, node.held);
  const Vector sliding = free - free.dot(normal) * normal;
  const double speed = sliding.norm(), sticking = node.mass * speed;
  const double friction = wall.friction >= 1 ? sticking : std::min(sticking, wall.friction * impulse.normal);
  if (speed > 0) impulse.sum -= friction / speed * sliding;
  return impulse;
}

}  // namespace

std::string_view wall_not_calculated(const model::RigidWall& wall) {
  if (wall.moving) return "moving walls are not calculated";
  if (wall.orthotropic) return "friction that differs by direction is not calculated";
  if (wall.soft > 1) return "stopping over several cycles (SOFT) is not calculated";
  if (!(wall.friction >= 0 && wall.friction <= 1)) return "FRIC outside of 0 to 1 is not calculated";
  return {};
}

RigidWalls::RigidWalls(const model::Model& model, const Structure& structure, Diagnostics& diagnostics) {
  contact::WallNodes wall_nodes(model);
  for (std::uint32_t i = 0; i < model.rigid_walls.size(); ++i) {
    const model::RigidWall& data = model.rigid_walls[i];
    const auto warn = [&](const std::string& message) {
      diagnostics.warning(model.file(data.place), data.place.line,
                          fmt::format("*{}, wall {}: {}", data.keyword, data.id, message));
    };
    if (const std::string_view why = wall_not_calculated(data); !why.empty()) {
      warn(fmt::format("{}; the wall takes no part in the calculation", why));
      continue;
    }
    Wall wall{data, wall_nodes.of(data), {}, {}};
    const std::size_t rigid = std::erase_if(
        wall.nodes, [&](NodeIndex n) { return n.value >= structure.state.x.size() || structure.rigid.holds(n.value); });
    if (rigid > 0) warn(fmt::format("{} nodes of rigid bodies and welds pass through it", rigid));
    for (const NodeIndex node : wall.nodes) wall.held.push_back(structure.constraints.mask(node.value) & 7u);
    wall.force.assign(wall.nodes.size(), Vector::Zero());
    walls_.push_back(std::move(wall));
    states_.emplace_back().wall = i;
  }
}

void RigidWalls::react_one(const State& state, double mean, double next, Wall& wall, WallState& result, Forces& net,
                           Forces& external) const {
  const model::RigidWall& data = wall.data;
  const bool active = state.time >= data.birth && (data.death <= 0 || state.time < data.death);
  const auto sums = sum_over_blocks<WallSums>(wall.nodes.size(), [&](std::size_t begin, std::size_t end) {
    WallSums sum;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t n = wall.nodes[i].value;
      const double mass = state.mass[n];
      Impulse impulse;
      if (active && mass > 0) {
        const Vector velocity = state.v[n] + freed(net.force[n], wall.held[i]) / mass * mean;
        impulse = wall_impulse(data, {mass, state.x[n], velocity, wall.held[i]}, next);
      }
      const Vector force = impulse.sum / mean;
      net.force[n] += force;
      external.force[n] += force;
      sum.force += force;
      sum.normal_force += impulse.normal / mean;
      sum.work -= state.dt / 2 * (wall.force[i] + force).dot(state.v[n]);
      if (impulse.normal > 0) ++sum.touching;
      wall.force[i] = force;
    }
    return sum;
  });
  result.force = sums.force;
  result.normal_force = sums.normal_force;
  result.energy += sums.work;
  result.touching = sums.touching;
}

void RigidWalls::react(const State& state, double mean, double next, Forces& net, Forces& external) {
  for (std::size_t i = 0; i < walls_.size(); ++i) react_one(state, mean, next, walls_[i], states_[i], net, external);
}

void RigidWalls::absorbed(Absorbed& work) const {
  for (const WallState& state : states_) work.walls += state.energy;
}

}  // namespace gapcheck::solver
