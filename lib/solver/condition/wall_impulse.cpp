#include "solver/condition/wall_impulse.hpp"

#include <algorithm>
#include <cmath>

#include "contact/rigid_wall.hpp"

namespace gapcheck::solver {
namespace {

/// Whether FRIC welds nodes that come fast.
bool welds(const model::RigidWall& wall) { return !wall.orthotropic && (wall.friction == 2 || wall.friction == 3); }

/// The impulse along the normal, and how it grows with the wall's velocity.
void push_along_normal(const WallInStep& wall, const NodeAtWall& node, double next, WallMemory& memory,
                       WallImpulse& impulse) {
  const Vector relative = node.velocity - wall.velocity;
  const auto behind = contact::wall_penetration(wall.data, node.x + next * relative, 0);
  if (!behind && !memory.welded) {
    memory.left = 0;
    return;
  }
  impulse.along = memory.welded ? wall.data.normal : behind->normal;
  const double approach = -impulse.along.dot(relative);
  double wanted = approach;
  if (!memory.welded) {
    if (welds(wall.data) && approach > wall.data.weld_velocity) memory.welded = true;
    if (wall.data.soft > 1) {
      if (memory.left == 0) memory.left = wall.data.soft;
      wanted = approach / static_cast<double>(memory.left);
      memory.left = std::max<std::int64_t>(1, memory.left - 1);
    } else {
      wanted = std::min(behind->depth / next, approach);  // nodes already behind stay there
    }
    if (!(wanted > 0)) return;
  }
  const double compliance = node.free(impulse.along).dot(impulse.along);
  constexpr double least_compliance = 1e-6;  // below, constraints hold the node against the wall
  if (!(compliance > least_compliance)) return;
  impulse.normal = node.mass * wanted / compliance;
  const double share = approach != 0 && wall.data.soft > 1 && !memory.welded ? wanted / approach : 1;
  impulse.slope = node.mass * share / compliance;
}

}  // namespace

Vector FreeDirections::operator()(const Vector& v) const {
  if (held == 0) return v;
  Vector own = axes != nullptr ? Vector(axes->transpose() * v) : v;
  for (int axis = 0; axis < 3; ++axis)
    if ((held >> axis & 1u) != 0) own[axis] = 0;
  return axes != nullptr ? Vector(*axes * own) : own;
}

Vector coming_velocity(const Constraints& constraints, const State& state, std::uint32_t node, FreeDirections free,
                       const Vector& net, double mean, double next) {
  Vector velocity = state.v[node] + mean / state.mass[node] * net;
  if (free.held == 0) return velocity;
  if (free.axes != nullptr) velocity = free.axes->transpose() * velocity;
  for (int axis = 0; axis < 3; ++axis)
    if ((free.held >> axis & 1u) != 0)
      velocity[axis] = constraints.velocity(node, static_cast<std::size_t>(axis), state.time, next);
  return free.axes != nullptr ? Vector(*free.axes * velocity) : velocity;
}

// Any other value is a coefficient (Keyword User's Manual, Vol. I, *RIGIDWALL_PLANAR).
WallFriction::WallFriction(double fric) : coefficient_(fric == 2 ? 0 : fric), rough_(fric == 1 || fric == 3) {}

WallFriction::WallFriction(const model::OrthotropicFriction& ortho, const Vector& normal, const Vector& along)
    : ortho_(ortho) {
  const Vector across = normal.cross(along);
  b_ = across.norm() > 0 ? Vector(across.normalized()) : Vector(normal.unitOrthogonal());
  a_ = b_.cross(normal);
}

Vector WallFriction::impulse(const Vector& sliding, double speed, double normal, double sticking) const {
  const double length = sliding.norm();
  if (!(length > 0)) return Vector::Zero();
  const Vector along = sliding / length, stop = -sticking * along;
  if (rough_) return stop;
  if (!ortho_) return std::min(1.0, coefficient_ * normal / sticking) * stop;
  const auto coefficient = [&](double at_rest, double fast, double decay) {
    return fast + (at_rest - fast) * std::exp(-decay * speed);
  };
  const double of_a = coefficient(ortho_->static_a, ortho_->dynamic_a, ortho_->decay_a);
  const double of_b = coefficient(ortho_->static_b, ortho_->dynamic_b, ortho_->decay_b);
  const Vector full = -normal * (of_a * along.dot(a_) * a_ + of_b * along.dot(b_) * b_);
  return -full.dot(along) < sticking ? full : stop;
}

WallImpulse wall_impulse(const WallInStep& wall, const NodeAtWall& node, double next, WallMemory& memory) {
  WallImpulse impulse;
  push_along_normal(wall, node, next, memory, impulse);
  if (impulse.normal == 0) return impulse;
  impulse.sum = impulse.normal * impulse.along;
  if (wall.friction.smooth()) return impulse;
  const Vector relative = node.velocity - wall.velocity;
  const Vector free = node.free(relative + node.free(impulse.sum) / node.mass);
  const Vector sliding = free - free.dot(impulse.along) * impulse.along;
  impulse.sum += wall.friction.impulse(sliding, sliding.norm(), std::abs(impulse.normal), node.mass * sliding.norm());
  return impulse;
}

}  // namespace gapcheck::solver
