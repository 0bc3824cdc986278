#include "solver/interface/contact_link.hpp"

#include <algorithm>

#include "contact/definition/friction.hpp"

namespace gapcheck::solver {

void LinkForce::set_forces(const LinkSpring& spring, double depth, const Vector& velocity, const Vector& before,
                           double dt) {
  push = spring.stiffness * depth;
  damping = 0;
  friction.setZero();
  // Damping acts in both directions but never pulls.
  if (spring.damping > 0) damping = std::max(-push, -spring.damping * velocity.dot(normal));
  if (spring.rubs) {
    const Vector sliding = velocity - velocity.dot(normal) * normal;
    const double limit = contact::friction_limit(spring.friction, sliding.norm(), push + damping, spring.area);
    // Elastic sticking up to the limit, with the stiffness of the normal spring.
    friction = before - before.dot(normal) * normal - spring.stiffness * dt * sliding;
    const double size = friction.norm();
    if (size > limit) friction *= size > 0 ? limit / size : 0;
  }
  push = std::max(0.0, push);
}

void add_energies(const LinkWork& work, bool exchanged, ContactState& result) {
  result.friction += work.friction;
  result.damping += work.damping;
  const bool all_a = result.single_surface;
  (exchanged && !all_a ? result.energy_b : result.energy_a) += work.on_tracked;
  (exchanged || all_a ? result.energy_a : result.energy_b) += work.on_reference;
}

}  // namespace gapcheck::solver
