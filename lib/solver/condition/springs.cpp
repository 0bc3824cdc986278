#include "solver/condition/springs.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace gapcheck::solver {
namespace {

/// The velocity of node b relative to node a.
Vector relative(const std::vector<Vector>& velocity, const SpringInput& spring) {
  const Vector& a = velocity[spring.a.value];
  return spring.b == none<NodeIndex> ? Vector(-a) : Vector(velocity[spring.b.value] - a);
}

/// How much a node yields to a unit force (or moment): squared velocity over twice the kinetic energy, at most.
double mobility(const State& state, const RigidBodies& rigid, std::uint32_t node, bool torsional) {
  if (const RigidBody* body = rigid.of_node(node)) {
    const Eigen::SelfAdjointEigenSolver<Matrix> axes(body->inertia(), Eigen::EigenvaluesOnly);
    const double turning = 1 / axes.eigenvalues()[0];
    if (torsional) return turning;
    return 1 / body->mass() + (state.x[node] - body->center()).squaredNorm() * turning;
  }
  return 1 / (torsional ? state.inertia[node] : state.mass[node]);
}

/// Springs are not cut off in a dynamic relaxation, whose time is its own.
double now(const State& state) { return state.relaxing ? 0 : state.time; }

}  // namespace

Springs::Springs(std::vector<SpringLaw> laws, const std::vector<SpringInput>& springs, const State& state,
                 const RigidBodies& rigid)
    : laws_(std::move(laws)) {
  for (const SpringInput& input : springs) {
    Spring spring;
    spring.ground = state.x[input.a.value];
    if (input.b != none<NodeIndex>) spring.length = (state.x[input.b.value] - spring.ground).norm();
    if (spring.length > 0) spring.elongation = input.offset;
    spring.input = input;
    if (const SpringLaw& law = laws_[input.law]; law.has_history() && spring.length > 0)
      (void)law.update(input.offset * Vector::UnitX(), 0, 0, spring.history);
    springs_.push_back(std::move(spring));
  }
  find_rates(state, rigid);
  step_ = step_beside(state, rates_);
  initial_ = stored();
}

double Springs::stored() const {
  double sum = 0;
  for (const Spring& spring : springs_) {
    const SpringLaw& law = laws_[spring.input.law];
    sum += spring.input.scale * (law.has_history() ? law.held(spring.history) : law.energy(spring.elongation));
  }
  return sum;
}

void Springs::held(Absorbed& energy) const { energy.springs += stored() - initial_ + damped_; }

void Springs::find_rates(const State& state, const RigidBodies& rigid) {
  // Coupled units: bodies and single nodes, translations and rotations separately.
  std::map<std::pair<const void*, bool>, ForceRates> sums;
  for (const Spring& spring : springs_) {
    const SpringInput& input = spring.input;
    const SpringLaw& law = laws_[input.law];
    const bool grounded = input.b == none<NodeIndex>;
    for (const NodeIndex node : {input.a, input.b}) {
      if (node == none<NodeIndex>) continue;
      const double yields = mobility(state, rigid, node.value, input.torsional);
      if (!std::isfinite(yields)) continue;  // no mass: the run ends at the first force on it
      const RigidBody* body = rigid.of_node(node.value);
      const void* owner = body != nullptr ? static_cast<const void*>(body) : &state.mass[node.value];
      ForceRates& sum = sums[{owner, input.torsional && body == nullptr}];
      // k (u_b − u_a)² <= 2 k (u_a² + u_b²)
      const double share = (grounded ? 1 : 2) * std::abs(input.scale) * yields;
      sum.squared_frequency += share * law.largest_stiffness();
      sum.damping += share * law.largest_damping();
    }
  }
  for (const auto& [owner, sum] : sums) {
    rates_.squared_frequency = std::max(rates_.squared_frequency, sum.squared_frequency);
    rates_.damping = std::max(rates_.damping, sum.damping);
  }
}

Vector Springs::translation(const State& state, Spring& spring) const {
  const SpringInput& input = spring.input;
  const SpringLaw& law = laws_[input.law];
  const Vector& to = input.b == none<NodeIndex> ? spring.ground : state.x[input.b.value];
  const Vector way = to - state.x[input.a.value], rate = relative(state.v, input);
  const double length = way.norm();
  const Vector along = length > 0 ? Vector(way / length) : Vector(Vector::Zero());
  if (spring.length > 0) {
    spring.elongation = length - spring.length + input.offset;
    take_line(state, spring, rate.dot(along));
    spring.damping = spring.resistance * along;
    return spring.tension * along;
  }
  spring.elongation = length;
  spring.damping = input.scale * law.damping * rate;
  if (const double speed = rate.norm(); !law.rates.empty() && speed > 0)
    spring.damping += input.scale * law.rates.at(speed) / speed * rate;
  Vector pull = law.rates.empty() ? Vector(input.scale * (law.force(length) * along + law.damping * rate))
                                  : Vector(input.scale * law.force(length) * along + spring.damping);
  if (law.has_history()) pull = input.scale * law.update(way, state.dt, now(state), spring.history);
  spring.tension = pull.norm();
  return pull;
}

/// Sets the tension along a line, and the part of it by the damper.
void Springs::take_line(const State& state, Spring& spring, double rate) const {
  const SpringInput& input = spring.input;
  const SpringLaw& law = laws_[input.law];
  spring.resistance = input.scale * law.damping * rate;
  if (law.has_history()) {
    const Vector elongation = spring.elongation * Vector::UnitX();
    spring.tension = input.scale * law.update(elongation, state.dt, now(state), spring.history).x();
  } else {
    spring.tension = input.scale * (law.force(spring.elongation) + law.damping * rate);
    if (law.rates.empty()) return;
    spring.resistance += input.scale * law.rates.at(rate);
    spring.tension += input.scale * law.rates.at(rate);
  }
}

Vector Springs::torsion(const State& state, Spring& spring) const {
  const SpringInput& input = spring.input;
  const Vector way = state.x[input.b.value] - state.x[input.a.value];
  const double length = way.norm();
  if (!(length > 0)) return Vector::Zero();
  const double rate = relative(state.w, input).dot(way) / length;
  spring.elongation += rate * state.dt;
  take_line(state, spring, rate);
  spring.damping = spring.resistance / length * way;
  return spring.tension / length * way;
}

void Springs::add(State& state, Forces& forces) {
  step_ = step_beside(state, rates_);
  for (Spring& spring : springs_) {
    const SpringInput& input = spring.input;
    const Vector damping = spring.damping;
    const Vector pull = input.torsional ? torsion(state, spring) : translation(state, spring);
    std::vector<Vector>& target = input.torsional ? forces.moment : forces.force;
    target[input.a.value] += pull;
    if (input.b != none<NodeIndex>) target[input.b.value] -= pull;
    const Vector rate = relative(input.torsional ? state.w : state.v, input);
    energy_ += state.dt / 2 * (spring.pull + pull).dot(rate);
    damped_ += state.dt / 2 * (damping + spring.damping).dot(rate);
    spring.pull = pull;
  }
}

}  // namespace gapcheck::solver
