#include "solver/interpolation/follower_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "solver/tie/tie_nodes.hpp"

namespace gapcheck::solver {
namespace {

/// The velocities halfway converge by the angle per step; this many rounds are more than enough.
constexpr int most_halfway_rounds = 16;
constexpr double same_velocity = 1e-14;

/// A force and a moment, or a velocity and an angular velocity.
Twist twist_of(const Vector& first, const Vector& second) {
  Twist twist;
  twist << first, second;
  return twist;
}

bool all_failed(const std::vector<std::uint32_t>& elements, const std::vector<bool>& failed) {
  return std::all_of(elements.begin(), elements.end(), [&](std::uint32_t i) { return i < failed.size() && failed[i]; });
}

}  // namespace

FollowerForces::FollowerForces(std::vector<Follower> followers, const model::Model& model, const Structure& structure)
    : followers_(std::move(followers)), structure_(structure) {
  for (FollowerGroup& group : group_followers(followers_)) groups_.push_back({std::move(group), Column::Zero(0)});
  for (Group& group : groups_) group.at_nodes = Column::Zero(3 * static_cast<Eigen::Index>(group.nodes.size()));
  watch_nodes(model);
  for (const Follower& follower : followers_)
    for (std::vector<Column>* columns : {&loads_, &targets_}) columns->push_back(Column::Zero(follower.axes.cols()));
}

/// Nodes of elements that cannot fail are never deleted, nor are nodes without elements.
void FollowerForces::watch_nodes(const model::Model& model) {
  std::map<std::uint32_t, std::vector<std::size_t>> watched_of;
  for (std::size_t f = 0; f < followers_.size(); ++f) {
    if (!followers_[f].ends_run) continue;
    std::vector<std::uint32_t> nodes = followers_[f].nodes;
    nodes.push_back(followers_[f].node);
    for (const std::uint32_t node : nodes) {
      watched_of[node].push_back(watched_.size());
      watched_.push_back({node, f, {}, {}, {}});
    }
  }
  if (watched_.empty()) return;
  const auto note = [&](const auto& elements, std::vector<std::uint32_t> Watched::*list) {
    for (std::uint32_t e = 0; e < elements.size(); ++e)
      for (const NodeIndex node : elements.nodes[e])
        if (const auto found = watched_of.find(node.value); found != watched_of.end())
          for (const std::size_t w : found->second) (watched_[w].*list).push_back(e);
  };
  note(model.mesh.shells, &Watched::shells);
  note(model.mesh.solids, &Watched::solids);
  note(model.mesh.beams, &Watched::beams);
  std::vector<bool> stays(watched_.size());
  const auto note_lasting = [&](const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e)
      for (const NodeIndex node : elements.nodes[e])
        if (const auto found = watched_of.find(node.value); found != watched_of.end())
          for (const std::size_t w : found->second) stays[w] = true;
  };
  note_lasting(model.mesh.thick_shells);
  note_lasting(model.mesh.discrete);
  std::size_t position = 0;
  std::erase_if(watched_, [&](const Watched& one) {
    return stays[position++] || one.shells.size() + one.solids.size() + one.beams.size() == 0;
  });
}

void FollowerForces::find_deleted(const State& state) {
  const FailedElements& failed = state.failed;
  if (failed.count == failures_) return;
  failures_ = failed.count;
  for (const Watched& one : watched_) {
    if (!all_failed(one.shells, failed.shells) || !all_failed(one.solids, failed.solids) ||
        !all_failed(one.beams, failed.beams))
      continue;
    const Follower& follower = followers_[one.follower];
    status_ = Failure{Failure::Kind::bad_element,
                      fmt::format("*CONSTRAINED_INTERPOLATION {}: the last element of node {} has failed at time {:g}, "
                                  "which ends the run; set IDNSW to 2 to go on",
                                  follower.id, structure_.node_id[one.node], state.time),
                      follower.place};
    return;
  }
}

/// By row the velocity of a follower along one of its axes, by column the velocities of the group's nodes. `places`: of
/// these nodes, one after the other; `points`: of the followers.
FollowerForces::Rows FollowerForces::coefficients(const Group& group, const Column& places,
                                                  const std::vector<Vector>& points) const {
  Rows result = Rows::Zero(group.rows, places.size());
  std::vector<Vector> of_one;
  for (std::size_t k = 0; k < group.followers.size(); ++k) {
    const Follower& follower = followers_[group.followers[k]];
    of_one.clear();
    for (const std::size_t position : group.positions[k])
      of_one.emplace_back(places.segment<3>(3 * static_cast<Eigen::Index>(position)));
    const MotionFit fit(follower.weights, of_one);
    for (std::size_t i = 0; i < of_one.size(); ++i)
      result.block(group.first[k], 3 * static_cast<Eigen::Index>(group.positions[k][i]), follower.axes.cols(), 3) =
          follower.axes.transpose() * fit.share(i, points[k]);
  }
  return result;
}

void FollowerForces::add(State& state, Forces& /*forces*/) {
  find_deleted(state);
  if (state.cycle > 0) return;
  for (const Group& group : groups_) {
    Column places(group.at_nodes.size()), velocities(group.at_nodes.size());
    for (std::size_t i = 0; i < group.nodes.size(); ++i) {
      places.segment<3>(3 * static_cast<Eigen::Index>(i)) = state.x[group.nodes[i]];
      velocities.segment<3>(3 * static_cast<Eigen::Index>(i)) = state.v[group.nodes[i]];
    }
    std::vector<Vector> points;
    for (const std::size_t f : group.followers) points.push_back(state.x[followers_[f].node]);
    const Column all = coefficients(group, places, points) * velocities;
    for (std::size_t k = 0; k < group.followers.size(); ++k)
      targets_[group.followers[k]] = all.segment(group.first[k], followers_[group.followers[k]].axes.cols());
  }
  follow(state);
}

Vector FollowerForces::mobility_of(std::uint32_t node, const State& state, double next) const {
  Vector mobility = Vector::Zero();
  const unsigned mask = structure_.constraints.mask(node, state.time, next);
  for (int axis = 0; axis < 3; ++axis)
    if ((mask >> axis & 1u) == 0 && has_mass(state.mass[node])) mobility[axis] = 1 / state.mass[node];
  return mobility;
}

Vector FollowerForces::free_velocity(std::uint32_t node, const State& state, double mean, double next,
                                     const Forces& net) const {
  Vector velocity = state.v[node] + mean * mobility_of(node, state, next).cwiseProduct(net.force[node]);
  const unsigned mask = structure_.constraints.mask(node, state.time, next);
  for (int axis = 0; axis < 3; ++axis)
    if ((mask >> axis & 1u) != 0)
      velocity[axis] = structure_.constraints.velocity(node, static_cast<std::size_t>(axis), state.time, next);
  return velocity;
}

FollowerForces::Present FollowerForces::present(const Group& group, const State& state, double mean, double next,
                                                const Forces& net) const {
  const Eigen::Index columns = group.at_nodes.size();
  Present now;
  for (Column* column : {&now.places, &now.before, &now.free, &now.mobility}) column->resize(columns);
  for (Column* column : {&now.mass, &now.own, &now.force}) column->resize(group.rows);
  for (std::size_t i = 0; i < group.nodes.size(); ++i) {
    const std::uint32_t n = group.nodes[i];
    const auto at = 3 * static_cast<Eigen::Index>(i);
    now.places.segment<3>(at) = state.x[n];
    now.before.segment<3>(at) = state.v[n];
    now.free.segment<3>(at) = free_velocity(n, state, mean, next, net);
    now.mobility.segment<3>(at) = mobility_of(n, state, next);
  }
  for (std::size_t k = 0; k < group.followers.size(); ++k) {
    const Follower& follower = followers_[group.followers[k]];
    const std::uint32_t n = follower.node;
    const Eigen::Index first = group.first[k], count = follower.axes.cols();
    now.points.push_back(state.x[n]);
    now.drifting.push_back(free_velocity(n, state, mean, next, net));
    now.own.segment(first, count) = follower.axes.transpose() * twist_of(state.v[n], state.w[n]);
    now.force.segment(first, count) = follower.axes.transpose() * twist_of(net.force[n], net.moment[n]);
    for (Eigen::Index row = 0; row < count; ++row)
      now.mass[first + row] = follower.axes.col(row).head<3>().isZero(0) ? state.inertia[n] : state.mass[n];
  }
  return now;
}

/// Places of the followers halfway through the step, with these velocities along their axes.
std::vector<Vector> FollowerForces::halfway(const Group& group, const Present& now, const Column& wanted,
                                            double next) const {
  std::vector<Vector> middle = now.points;
  for (std::size_t k = 0; k < middle.size(); ++k) {
    const Follower& follower = followers_[group.followers[k]];
    Vector velocity = now.drifting[k];
    for (Eigen::Index row = 0; row < follower.axes.cols(); ++row)
      if (const Vector axis = follower.axes.col(row).head<3>(); !axis.isZero(0))
        velocity += (wanted[group.first[k] + row] - axis.dot(velocity)) * axis;
    middle[k] += next / 2 * velocity;
  }
  return middle;
}

/// With the velocities vᵢ and v of followed nodes and followers in the next step, v = C vᵢ + b; the loads λ along the
/// followers' axes act at the positions before the step, −Cᵀ λ on the followed nodes:
///     m (C vᵢ⁰ + b − v₀) − Δt f = Δt (1 + m C M⁻¹ Cᵀ) λ
/// for the masses m of the followers, which may be zero, and the velocities vᵢ⁰ without λ. b = (C halfway − C) vᵢ.
FollowerForces::Solution FollowerForces::solve(const Group& group, const Present& now, const Rows& c, double mean,
                                               double next) const {
  const Eigen::PartialPivLU<Rows> system(Rows::Identity(group.rows, group.rows) +
                                         now.mass.asDiagonal() * (c * now.mobility.asDiagonal() * c.transpose()));
  Column moved = now.free, turned = Column::Zero(group.rows);
  Solution solution;
  for (int round = 0; round < most_halfway_rounds; ++round) {
    solution.load = system.solve(Column(now.mass.cwiseProduct(c * now.free + turned - now.own) / mean - now.force));
    moved = now.free - mean * now.mobility.cwiseProduct(c.transpose() * solution.load);
    const std::vector<Vector> middle = halfway(group, now, c * moved + turned, next);
    const Column better = coefficients(group, now.places + next / 2 * moved, middle) * moved;
    const bool settled = round > 0 && !((better - solution.velocity).lpNorm<Eigen::Infinity>() >
                                        same_velocity * better.lpNorm<Eigen::Infinity>());
    solution.velocity = better;
    turned = better - c * moved;
    if (settled) break;
  }
  return solution;
}

void FollowerForces::push(const Group& group, const Solution& solution, Forces& forces) const {
  for (std::size_t i = 0; i < group.nodes.size(); ++i)
    forces.force[group.nodes[i]] += group.at_nodes.segment<3>(3 * static_cast<Eigen::Index>(i));
  for (std::size_t k = 0; k < group.followers.size(); ++k) {
    const Follower& follower = followers_[group.followers[k]];
    const Twist total = follower.axes * solution.load.segment(group.first[k], follower.axes.cols());
    forces.force[follower.node] += total.head<3>();
    forces.moment[follower.node] += total.tail<3>();
  }
}

void FollowerForces::react(const State& state, double mean, double next, Forces& net, Forces& external) {
  for (Group& group : groups_) {
    const Present now = present(group, state, mean, next, net);
    // The work of the last step: half by the loads before it, half by the loads after it.
    const auto work = [&] {
      double sum = group.at_nodes.dot(now.before);
      for (std::size_t k = 0; k < group.followers.size(); ++k) {
        const Column& load = loads_[group.followers[k]];
        sum += load.dot(now.own.segment(group.first[k], load.size()));
      }
      return state.dt / 2 * sum;
    };
    residue_ -= work();
    const Rows c = coefficients(group, now.places, now.points);
    const Solution solution = solve(group, now, c, mean, next);
    group.at_nodes = -c.transpose() * solution.load;
    for (std::size_t k = 0; k < group.followers.size(); ++k) {
      const std::size_t f = group.followers[k];
      loads_[f] = solution.load.segment(group.first[k], loads_[f].size());
      targets_[f] = solution.velocity.segment(group.first[k], loads_[f].size());
    }
    residue_ -= work();
    push(group, solution, net);
    push(group, solution, external);
  }
}

/// Followers with mass have this velocity already, but for rounding.
void FollowerForces::follow(State& state) {
  for (std::size_t f = 0; f < followers_.size(); ++f) {
    const Follower& follower = followers_[f];
    const Twist motion = twist_of(state.v[follower.node], state.w[follower.node]);
    const Twist change = follower.axes * (targets_[f] - follower.axes.transpose() * motion);
    state.v[follower.node] += change.head<3>();
    state.w[follower.node] += change.tail<3>();
  }
}

}  // namespace gapcheck::solver
