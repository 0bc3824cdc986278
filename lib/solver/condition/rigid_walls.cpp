#include "solver/condition/rigid_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/rigid_wall.hpp"

namespace gapcheck::solver {

/// A node's contribution to a wall's sums.
struct RigidWalls::Sums {
  Vector force = Vector::Zero();
  double normal = 0, slope = 0, work = 0;  ///< normal: impulse
  std::uint64_t touching = 0;
  void add(const Sums& other) {
    force += other.force;
    normal += other.normal;
    slope += other.slope;
    work += other.work;
    touching += other.touching;
  }
};

RigidWalls::RigidWalls(const model::Model& model, const Structure& structure, Diagnostics& diagnostics)
    : constraints_(structure.constraints), bodies_(structure.rigid.size()) {
  constraints_.finish();
  contact::WallNodes wall_nodes(model);
  PenaltyNodes penalty(model, structure);
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
    std::vector<NodeIndex> nodes = wall_nodes.of(data);
    std::erase_if(nodes, [&](NodeIndex n) { return n.value >= structure.state.x.size(); });
    if (model.controls.rwpnal == 0) {
      const std::size_t rigid = std::erase_if(nodes, [&](NodeIndex n) { return structure.rigid.holds(n.value); });
      if (rigid > 0) warn(fmt::format("{} nodes of rigid bodies and welds pass through it", rigid));
    }
    add_wall(model, i, std::move(nodes), structure, penalty);
  }
}

void RigidWalls::add_wall(const model::Model& model, std::uint32_t position, std::vector<NodeIndex> nodes,
                          const Structure& structure, PenaltyNodes& penalty) {
  const model::RigidWall& data = model.rigid_walls[position];
  Wall wall{data, {}, {}, {}, {}, {}, data.tail, WallFriction(data.friction), nullptr, Vector::Zero()};
  if (const double rwpnal = model.controls.rwpnal; rwpnal != 0) {
    const auto soft = std::stable_partition(nodes.begin(), nodes.end(),
                                            [&](NodeIndex n) { return rwpnal > 0 && !structure.rigid.holds(n.value); });
    wall.penalty = penalty.of({soft, nodes.end()}, rwpnal * data.stiffness_scale);
    nodes.erase(soft, nodes.end());
  }
  if (data.orthotropic) {
    wall.friction = WallFriction(data.ortho, data.normal, data.ortho.direction);
    const auto& lookup = model.mesh.nodes.lookup;
    if (const auto first = lookup.find(data.ortho.node_1); first && data.ortho.node_1 != 0) wall.first = *first;
    if (const auto second = lookup.find(data.ortho.node_2); second && data.ortho.node_2 != 0) wall.second = *second;
  }
  if (data.motion_curve != 0) {
    const model::Curve& curve = model.curves.at(data.motion_curve);
    std::vector<TimeCurve::Point> points = curve.points;
    for (TimeCurve::Point& point : points) point[0] *= curve.abscissa_time;
    wall.curve = std::make_shared<const TimeCurve>(std::move(points));
    wall.direction = data.motion_direction.normalized();
  }
  wall.nodes = std::move(nodes);
  wall.memory.resize(wall.nodes.size());
  wall.force.assign(wall.nodes.size(), Vector::Zero());
  WallState& state = states_.emplace_back();
  state.wall = position;
  if (data.mass > 0 && data.birth <= 0) state.velocity = data.velocity * data.normal;
  if (data.birth <= 0 && wall.curve != nullptr) state.velocity = imposed(wall, 0, 0);
  walls_.push_back(std::move(wall));
}

Vector RigidWalls::imposed(const Wall& wall, double time, double next) {
  // The curve begins at the wall's birth (Keyword User's Manual, Vol. I, *RIGIDWALL_GEOMETRIC).
  Motion motion;
  motion.quantity = wall.data.motion_option == 1 ? Motion::Quantity::displacement : Motion::Quantity::velocity;
  motion.curve = wall.curve;
  const double from = time - wall.data.birth;
  if (from + next <= 0 && wall.data.birth > 0) return Vector::Zero();
  return motion.velocity(std::max(from, 0.0), std::min(next, from + next)) * wall.direction;
}

void RigidWalls::add(State& state, Forces& forces) {
  stable_step_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    Wall& wall = walls_[i];
    WallState& result = states_[i];
    result.shift += state.dt * result.velocity;
    wall.data.tail = wall.start + result.shift;
    if (wall.first != no_position && wall.second != no_position)
      wall.friction = WallFriction(wall.data.ortho, wall.data.normal, state.x[wall.second] - state.x[wall.first]);
    if (wall.penalty.empty()) continue;
    wall.pressed = push_by_penalty({wall.data, result.velocity, wall.friction}, result.shift, state,
                                   wall.active(state.time), wall.penalty, forces.force);
    const double give = wall.data.mass > 0 ? 1 / wall.data.mass : 0;
    stable_step_ = std::min(stable_step_, penalty_step(wall.penalty, bodies_, give));
  }
}

NodeAtWall RigidWalls::node_at(const State& state, double mean, double next, const Wall& wall, std::size_t i,
                               const Forces& net) const {
  const std::uint32_t n = wall.nodes[i].value;
  const FreeDirections free{constraints_.mask(n, state.time, next) & 7u, constraints_.axes(n)};
  const Vector velocity = coming_velocity(constraints_, state, n, free, net.force[n], mean, next);
  return {state.mass[n], state.x[n], velocity, free};
}

Vector RigidWalls::free_velocity(const State& state, double mean, double next, const Wall& wall,
                                 const WallState& result, const Forces& net) const {
  const Vector& normal = wall.data.normal;
  if (!wall.active(state.time))
    return wall.data.death > 0 && state.time >= wall.data.death ? result.velocity : Vector::Zero();
  const bool begins = wall.data.birth > 0 && state.time - state.dt < wall.data.birth;
  const double before = begins ? wall.data.velocity : result.velocity.dot(normal), mass = wall.data.mass;
  const double pressed = before - mean * wall.pressed.force.dot(normal) / mass;
  double velocity = pressed;
  // Convex and rising in the wall's velocity: from above Newton's steps meet the root from one side, and since all is
  // linear between the nodes' thresholds, in a finite number.
  constexpr int most_rounds = 50;
  for (int round = 0; round < most_rounds; ++round) {
    const WallInStep moving{wall.data, velocity * normal, wall.friction};
    const Sums sums = sum_over_blocks<Sums>(wall.nodes.size(), [&](std::size_t begin, std::size_t end) {
      Sums sum;
      for (std::size_t i = begin; i < end; ++i) {
        if (!(state.mass[wall.nodes[i].value] > 0)) continue;
        WallMemory memory = wall.memory[i];
        const WallImpulse impulse = wall_impulse(moving, node_at(state, mean, next, wall, i, net), next, memory);
        sum.normal += impulse.normal;
        sum.slope += impulse.slope;
      }
      return sum;
    });
    const double excess = mass * (velocity - pressed) + sums.normal;
    if (std::abs(excess) <= 1e-13 * (mass * (std::abs(velocity) + std::abs(before)) + std::abs(sums.normal))) break;
    velocity -= excess / (mass + sums.slope);
  }
  return velocity * normal;
}

void RigidWalls::react_one(const State& state, double mean, double next, Wall& wall, WallState& result, Forces& net,
                           Forces& external) const {
  const bool active = wall.active(state.time);
  const Vector last = result.velocity;
  if (wall.data.mass > 0 && wall.data.moving) result.velocity = free_velocity(state, mean, next, wall, result, net);
  if (wall.curve != nullptr) result.velocity = imposed(wall, state.time, next);
  const WallInStep moving{wall.data, result.velocity, wall.friction};
  const auto sums = sum_over_blocks<Sums>(wall.nodes.size(), [&](std::size_t begin, std::size_t end) {
    Sums sum;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t n = wall.nodes[i].value;
      WallImpulse impulse;
      if (active && state.mass[n] > 0)
        impulse = wall_impulse(moving, node_at(state, mean, next, wall, i, net), next, wall.memory[i]);
      const Vector force = impulse.sum / mean;
      net.force[n] += force;
      external.force[n] += force;
      sum.force += force;
      sum.normal += impulse.normal / mean;
      sum.work -= state.dt / 2 * (wall.force[i] + force).dot(state.v[n] - last);
      if (impulse.normal != 0) ++sum.touching;
      wall.force[i] = force;
    }
    return sum;
  });
  result.force = sums.force + wall.pressed.force;
  result.normal_force = sums.normal + wall.pressed.normal_force;
  result.energy += sums.work + wall.pressed.work;
  result.touching = sums.touching + wall.pressed.touching;
}

void RigidWalls::react(const State& state, double mean, double next, Forces& net, Forces& external) {
  for (std::size_t i = 0; i < walls_.size(); ++i) react_one(state, mean, next, walls_[i], states_[i], net, external);
}

void RigidWalls::absorbed(Absorbed& work) const {
  for (const WallState& state : states_) work.walls += state.energy;
}

}  // namespace gapcheck::solver
