#include "solver/tie/tie_spring.hpp"

#include <utility>

namespace gapcheck::solver {
namespace {

/// The node's rotation relative to the segment grows, and turns with the segment.
void turn_node(TieSpring& spring, const State& state) {
  const Tie& tie = spring.tie;
  const SegmentAxes middle(tie.point.nodes, state.x, state.v, -state.dt / 2);
  const Vector turn = motion(tie, middle, state.v, state.w).turn;
  const Vector of_segment = state.w[tie.node.value] - turn;
  spring.turned = spin_rotation(state.dt * of_segment) * spring.turned + state.dt * turn;
}

void slide(TieSpring& spring, const State& state) {
  const double half = state.dt / 2;
  const TieSlide::Load load =
      spring.slide.advance(spring.tie, spring.strength.side, spring.stiffness, spring.damping, state);
  spring.rubbed = -half * spring.friction.dot(load.velocity);
  spring.damage.broken = load.off || spring.strength.criterion(load.push, load.normal) >= 1;
  spring.active = !spring.damage.broken;
  spring.loads = {};
  spring.friction = spring.active ? load.friction : Vector(Vector::Zero());
  spring.stored = spring.active ? load.stored : 0;
  if (!spring.active) return;
  spring.loads.set(spring.tie, SegmentAxes(), Vector::Zero(), load.push + load.damping + load.friction, Vector::Zero());
  spring.damped = -state.dt * load.damping.dot(load.velocity);
  spring.rubbed -= half * load.friction.dot(load.velocity);
  spring.on_node -= half * spring.loads.on_node(spring.tie, state);
  spring.on_segment -= half * spring.loads.on_segment(spring.tie, state);
}

}  // namespace

void advance(TieSpring& spring, const State& state, bool active) {
  const Tie& tie = spring.tie;
  const double half = state.dt / 2;
  spring.on_node = -half * spring.loads.on_node(tie, state);
  spring.on_segment = -half * spring.loads.on_segment(tie, state);
  spring.damped = 0;
  spring.rubbed = 0;
  spring.lost = 0;
  if (!active || (spring.damage.broken && !spring.damage.bridges(spring.strength))) {
    spring.loads = {};
    spring.active = false;
    spring.slide.stop();
    spring.lost = std::exchange(spring.stored, 0);
    return;
  }
  if (spring.slide.slides()) return slide(spring, state);
  const SegmentAxes axes(tie.point.nodes, state.x);
  const TieMotion moving = motion(tie, axes, state.v, state.w);
  if (!spring.active) {
    spring.active = true;
    spring.offset.start(tie, axes, state.x);
    spring.turned = Vector::Zero();
  } else {
    spring.offset.move(tie, axes, moving.spin, state.dt);
    if (tie.rotations) turn_node(spring, state);
  }
  const Vector arm = state.x[tie.node.value] - tie.point.of(state.x);
  const Vector velocity = moving.velocity - moving.spin.cross(spring.offset.value());
  const Vector stretch = arm - spring.offset.value();
  Vector force = -spring.stiffness * stretch, damping = -spring.damping * velocity;
  if (spring.strength.limited()) {
    const Vector normal = axes.sound ? Vector(axes.axes.col(2)) : Vector(Vector::Zero());
    const TieResponse response = spring.damage.respond(spring.strength, spring.stiffness, stretch, normal);
    force = response.force;
    damping *= response.share;
    if (!response.flow.isZero(0)) spring.offset.shift(axes, response.flow);
  }
  spring.stored = (spring.stiffness * stretch.squaredNorm() + spring.rotational * spring.turned.squaredNorm()) / 2;
  spring.loads.set(tie, axes, arm, force + damping, -spring.rotational * spring.turned);
  if (spring.damage.broken && !spring.damage.bridges(spring.strength)) spring.active = false;
  spring.damped = -state.dt * damping.dot(velocity);
  spring.on_node -= half * spring.loads.on_node(tie, state);
  spring.on_segment -= half * spring.loads.on_segment(tie, state);
}

}  // namespace gapcheck::solver
