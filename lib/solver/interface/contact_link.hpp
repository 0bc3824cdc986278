#pragma once
#include "base/vector.hpp"
#include "model/contact/contact.hpp"
#include "solver/interface/contact_state.hpp"

namespace gapcheck::solver {

/// The parameters of a spring between two points of a contact.
struct LinkSpring {
  double stiffness = 0;
  double damping = 0;  ///< damping constant
  bool rubs = false;   ///< there is friction, by `friction` and `area`
  model::FrictionLaw friction;
  double area = 0;  ///< used by VC
};

/// The force of such a spring on the tracked point; the opposite acts on the other one.
struct LinkForce {
  Vector normal = Vector::Zero();  ///< unit vector towards the tracked point's free side
  Vector friction = Vector::Zero();
  double push = 0, damping = 0;  ///< along the normal
  [[nodiscard]] Vector force() const { return (push + damping) * normal + friction; }
  /// The energy of its spring at the depth that set the push.
  [[nodiscard]] double stored(double depth) const { return push * depth / 2; }
  /// Sets push, damping and friction along `normal`. `depth`: penetration that gives force; `velocity`: of the tracked
  /// point relative to the other one; `before`: friction of the last step; `dt`: that step.
  void set_forces(const LinkSpring& spring, double depth, const Vector& velocity, const Vector& before, double dt);
};

/// Work of springs in one step, by the trapezoidal rule: of friction and damping, and all of it by side.
struct LinkWork {
  double friction = 0, damping = 0, on_tracked = 0, on_reference = 0;
  /// Half of a step with the force at one of its ends; velocities of the two points.
  void add(const LinkForce& link, const Vector& tracked, const Vector& reference, double dt) {
    const double half = dt / 2;
    const Vector velocity = tracked - reference, force = link.force();
    damping -= half * link.damping * link.normal.dot(velocity);
    friction -= half * link.friction.dot(velocity);
    on_tracked -= half * force.dot(tracked);
    on_reference += half * force.dot(reference);
  }
};

/// Adds work to the energies of a contact. `exchanged`: the tracked points are on side B.
void add_energies(const LinkWork& work, bool exchanged, ContactState& result);

}  // namespace gapcheck::solver
