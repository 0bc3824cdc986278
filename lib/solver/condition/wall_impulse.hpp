#pragma once
#include <cstdint>
#include <optional>

#include "model/entity/rigid_wall.hpp"
#include "solver/state/constraints.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// The directions in which a node follows from forces during a step.
struct FreeDirections {
  unsigned held = 0;             ///< one bit for each translation that does not
  const Matrix* axes = nullptr;  ///< of these translations; nullptr: the global ones
  /// `v` without its constrained components.
  [[nodiscard]] Vector operator()(const Vector& v) const;
};

/// The velocity of a node over the next step without walls: `net` is the sum of all forces on it.
[[nodiscard]] Vector coming_velocity(const Constraints& constraints, const State& state, std::uint32_t node,
                                     FreeDirections free, const Vector& net, double mean, double next);

/// Friction of a wall with its directions at present.
class WallFriction {
 public:
  WallFriction() = default;
  /// Smooth (FRIC 0 and 2), Coulomb, or rough (1 and 3).
  explicit WallFriction(double fric);
  /// Friction by direction: `along` is d (see model::OrthotropicFriction), which must not be parallel to the normal.
  WallFriction(const model::OrthotropicFriction& ortho, const Vector& normal, const Vector& along);
  /// The impulse on what slides in this direction along the wall with this speed: against the sliding, at most μ times
  /// the normal impulse, and at most `sticking`, which would stop it. By direction it is −N (μa ca a + μb cb b) for the
  /// direction c of the sliding: an ellipse, our own choice; each coefficient falls from static to dynamic with
  /// exp(−decay |v|).
  [[nodiscard]] Vector impulse(const Vector& sliding, double speed, double normal, double sticking) const;
  [[nodiscard]] bool smooth() const { return !ortho_ && !rough_ && !(coefficient_ > 0); }

 private:
  double coefficient_ = 0;
  bool rough_ = false;
  std::optional<model::OrthotropicFriction> ortho_;
  Vector a_ = Vector::Zero(), b_ = Vector::Zero();
};

/// A wall during a step.
struct WallInStep {
  const model::RigidWall& data;  ///< where it is at the start of the step
  Vector velocity;               ///< over the step
  const WallFriction& friction;
};

/// A node before the wall reacts.
struct NodeAtWall {
  double mass;
  Vector x, velocity;  ///< velocity: over the next step, without walls
  FreeDirections free;
};

/// What a wall remembers of a node.
struct WallMemory {
  std::int64_t left = 0;  ///< SOFT: cycles until it has the wall's velocity; 0: it does not touch
  bool welded = false;    ///< FRIC 2 and 3
};

/// The reaction of a wall on a node in one step.
struct WallImpulse {
  Vector sum = Vector::Zero();
  double normal = 0;
  Vector along = Vector::Zero();  ///< the wall's normal there
  double slope = 0;               ///< of the normal impulse over the wall's velocity along its normal
};

/// A node that would be behind the wall at the end of the step gets the impulse that puts it on the surface; one that
/// is already behind goes no deeper. With SOFT only a part of its velocity is taken. Changes the memory.
[[nodiscard]] WallImpulse wall_impulse(const WallInStep& wall, const NodeAtWall& node, double next, WallMemory& memory);

}  // namespace gapcheck::solver
