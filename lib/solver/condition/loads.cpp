#include "solver/condition/loads.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/quad.hpp"
#include "solver/state/summary.hpp"

namespace gapcheck::solver {
namespace {

/// The list of values keeps repeated ones only once.
std::uint32_t position_in(std::vector<TimedValue>& values, const TimedValue& value) {
  const bool same = !values.empty() && values.back().curve == value.curve && values.back().scale == value.scale &&
                    values.back().arrival == value.arrival && values.back().phases.run == value.phases.run &&
                    values.back().phases.relaxation == value.phases.relaxation;
  if (!same) values.push_back(value);
  return static_cast<std::uint32_t>(values.size() - 1);
}

std::vector<double> all_at(const std::vector<TimedValue>& values, const State& state) {
  std::vector<double> now;
  now.reserve(values.size());
  for (const TimedValue& value : values) now.push_back(value.at(state));
  return now;
}

std::vector<std::uint32_t> each_once(std::vector<std::uint32_t> list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

/// The sum of one number per node over fixed blocks.
struct Sum {
  double value = 0;
  void add(const Sum& other) { value += other.value; }
};

}  // namespace

void ConcentratedLoads::add_node(NodeIndex node, std::size_t freedom, const TimedValue& value) {
  entries_.push_back({node.value, static_cast<std::uint8_t>(freedom), false, position_in(values_, value)});
}

void ConcentratedLoads::add_body(std::size_t body, std::size_t freedom, const TimedValue& value) {
  entries_.push_back(
      {static_cast<std::uint32_t>(body), static_cast<std::uint8_t>(freedom), true, position_in(values_, value)});
}

void ConcentratedLoads::follow_normal(std::size_t target, bool body, bool moment, const std::array<NodeIndex, 3>& nodes,
                                      const TimedValue& value) {
  followers_.push_back({static_cast<std::uint32_t>(target), body, moment, nodes, position_in(values_, value)});
}

void ConcentratedLoads::add_at(const State& state, Forces& forces) const {
  const std::vector<double> now = all_at(values_, state);
  for (const Entry& entry : entries_) {
    auto& pushes = entry.body ? forces.body_force : forces.force;
    auto& turns = entry.body ? forces.body_moment : forces.moment;
    (entry.freedom < 3 ? pushes : turns)[entry.target][entry.freedom % 3] += now[entry.value];
  }
  for (const Follower& follower : followers_) {
    const auto& [first, second, third] = follower.nodes;
    const Vector& origin = state.x[first.value];
    const Vector normal = (state.x[second.value] - origin).cross(state.x[third.value] - origin);
    const double length = normal.norm();
    if (!(length > 0)) continue;  // nodes that have come into one line give no direction
    auto& pushes = follower.body ? forces.body_force : forces.force;
    auto& turns = follower.body ? forces.body_moment : forces.moment;
    (follower.moment ? turns : pushes)[follower.target] += now[follower.value] / length * normal;
  }
}

void Pressures::add_segment(const model::SegmentNodes& nodes, const TimedValue& value) {
  segments_.push_back(nodes);
  value_of_.push_back(position_in(values_, value));
}

std::vector<std::uint32_t> ConcentratedLoads::targets(bool bodies) const {
  std::vector<std::uint32_t> list;
  for (const Entry& entry : entries_)
    if (entry.body == bodies) list.push_back(entry.target);
  for (const Follower& follower : followers_)
    if (follower.body == bodies) list.push_back(follower.target);
  return each_once(std::move(list));
}

std::vector<std::uint32_t> Pressures::nodes() const {
  std::vector<std::uint32_t> list;
  for (const model::SegmentNodes& segment : segments_)
    for (const NodeIndex node : segment) list.push_back(node.value);
  return each_once(std::move(list));
}

void Pressures::add_at(const State& state, Forces& forces) const {
  const std::vector<double> now = all_at(values_, state);
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const model::SegmentNodes& nodes = segments_[i];
    const std::size_t corners = nodes[2] == nodes[3] ? 3 : 4;
    const Vector push = -now[value_of_[i]] / (2 * static_cast<double>(corners)) * quad_normal(nodes, state.x);
    for (std::size_t k = 0; k < corners; ++k) forces.force[nodes[k].value] += push;
  }
}

void Gravity::add(State& state, Forces& forces) {
  Vector acceleration = Vector::Zero();
  for (const auto& [axis, value] : axes_) acceleration[axis] -= value.at(state);
  for (const auto& [along, value] : directions_) acceleration -= value.at(state) * along;
  parallel_for(state.x.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (!masses_.empty())
        forces.force[i] += masses_[i] * acceleration;
      else if (!state.in_body(i))
        forces.force[i] += state.mass[i] * acceleration;
  });
  for (const Rotation& rotation : rotations_) add_one(rotation, state, forces);
  if (!masses_.empty()) return;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) forces.body_force[b] += state.bodies[b].mass * acceleration;
}

void Gravity::add_one(const Rotation& rotation, const State& state, Forces& forces) const {
  const double rate = rotation.rate.at(state), square = rate * rate;
  const auto away = [&](const Vector& x) {
    Vector arm = x - rotation.center;
    arm[rotation.axis] = 0;
    return Vector(square * arm);
  };
  parallel_for(state.x.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (!masses_.empty())
        forces.force[i] += masses_[i] * away(state.x[i]);
      else if (!state.in_body(i))
        forces.force[i] += state.mass[i] * away(state.x[i]);
  });
  if (!masses_.empty()) return;
  const Vector axis = Vector::Unit(rotation.axis);
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    forces.body_force[b] += state.bodies[b].mass * away(state.bodies[b].center);
    forces.body_moment[b] += square * Vector(state.bodies[b].inertia * axis).cross(axis);  // the sum over its masses
  }
}

void GlobalDamping::add(State& state, Forces& forces) {
  const double constant = constant_.at(state);
  const double strongest = std::max(move_.cwiseAbs().maxCoeff(), turn_.cwiseAbs().maxCoeff()) * std::abs(constant);
  stable_step_ = strongest > 0 ? 1 / strongest : std::numeric_limits<double>::infinity();
  const Vector move = -constant * move_, turn = -constant * turn_;
  if (last_.force.empty()) last_.resize(state.x.size(), state.bodies.size());
  const double half = state.dt / 2;
  work_ -= sum_over_blocks<Sum>(state.x.size(), [&](std::size_t begin, std::size_t end) {
             Sum sum;
             for (std::size_t i = begin; i < end; ++i) {
               if (state.in_body(i)) continue;
               const Vector force = state.mass[i] * move.cwiseProduct(state.v[i]);
               const Vector moment = state.inertia[i] * turn.cwiseProduct(state.w[i]);
               sum.value +=
                   half * ((last_.force[i] + force).dot(state.v[i]) + (last_.moment[i] + moment).dot(state.w[i]));
               forces.force[i] += last_.force[i] = force;
               forces.moment[i] += last_.moment[i] = moment;
             }
             return sum;
           }).value;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const BodyState& body = state.bodies[b];
    const Vector force = body.mass * move.cwiseProduct(body.velocity);
    const Vector moment = turn.cwiseProduct(body.angular_momentum);
    work_ -= half * ((last_.body_force[b] + force).dot(body.velocity) + (last_.body_moment[b] + moment).dot(body.spin));
    forces.body_force[b] += last_.body_force[b] = force;
    forces.body_moment[b] += last_.body_moment[b] = moment;
  }
}

void PartDampings::add_part(const TimedValue& constant, const std::array<double, 6>& factors,
                            const std::vector<double>& masses, std::vector<std::size_t> bodies,
                            std::optional<std::size_t> frame) {
  Entry entry{constant, {factors[0], factors[1], factors[2]}, {factors[3], factors[4], factors[5]}, {}, {}, frame};
  for (std::uint32_t i = 0; i < masses.size(); ++i)
    if (masses[i] > 0) entry.nodes.push_back({i, masses[i]});
  for (const std::size_t body : bodies) entry.bodies.push_back({body});
  entries_.push_back(std::move(entry));
}

void PartDampings::add(State& state, Forces& forces) {
  const double half = state.dt / 2;
  double strongest = 0;
  for (Entry& entry : entries_) {
    const double constant = entry.constant.at(state);
    strongest += std::abs(constant) * std::max(entry.move.cwiseAbs().maxCoeff(), entry.turn.cwiseAbs().maxCoeff());
    const Vector move = -constant * entry.move, turn = -constant * entry.turn;
    const BodyState* const frame = entry.frame ? &state.bodies[*entry.frame] : nullptr;
    const auto relative = [&](const Vector& v, const Vector& x) {
      return frame == nullptr ? v : Vector(v - frame->velocity - frame->spin.cross(x - frame->center));
    };
    const auto relative_spin = [&](const Vector& w) { return frame == nullptr ? w : Vector(w - frame->spin); };
    for (Node& one : entry.nodes) {
      const std::uint32_t n = one.node;
      const double share = state.mass[n] > 0 ? std::min(one.mass / state.mass[n], 1.0) : 0;
      const Vector v = relative(state.v[n], state.x[n]), w = relative_spin(state.w[n]);
      const Vector force = share * state.mass[n] * move.cwiseProduct(v);
      const Vector moment = share * state.inertia[n] * turn.cwiseProduct(w);
      work_ -= half * ((one.force + force).dot(v) + (one.moment + moment).dot(w));
      forces.force[n] += one.force = force;
      forces.moment[n] += one.moment = moment;
    }
    for (Body& one : entry.bodies) {
      const BodyState& body = state.bodies[one.body];
      const Vector v = relative(body.velocity, body.center), w = relative_spin(body.spin);
      const Vector momentum =
          frame == nullptr ? body.angular_momentum : Vector(body.angular_momentum - body.inertia * frame->spin);
      const Vector force = body.mass * move.cwiseProduct(v);
      const Vector moment = turn.cwiseProduct(momentum);
      work_ -= half * ((one.force + force).dot(v) + (one.moment + moment).dot(w));
      forces.body_force[one.body] += one.force = force;
      forces.body_moment[one.body] += one.moment = moment;
    }
  }
  stable_step_ = strongest > 0 ? 1 / strongest : std::numeric_limits<double>::infinity();
}

}  // namespace gapcheck::solver
