#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/ids.hpp"
#include "solver/rigid_body.hpp"
#include "solver/state.hpp"

namespace gapcheck::solver {

/// When a rigid link of two nodes fails: at (fn / normal)^p + (|fs| / shear)^q >= 1, with the tension fn along the link
/// and the force fs across it (all of it where the nodes lie on one another), or at a time. Zero: never by that.
struct LinkStrength {
  double normal = 0, shear = 0, normal_power = 1, shear_power = 1;
  double time = 0;
  [[nodiscard]] bool limited() const { return normal > 0 || shear > 0 || time > 0; }
};

/// The rigid bodies of a structure and the nodes that go with them.
class RigidBodies {
 public:
  void resize(std::size_t nodes) { of_node_.assign(nodes, nobody); }
  /// Adds a body of the points' mass; the masses that `state` has at its nodes count too. Nodes that already belong to
  /// a body stay there. Returns its position. Directions with a bit in `held` stay at rest.
  std::size_t add(std::vector<PointMass> points, std::span<const NodeIndex> nodes, unsigned held, const State& state);
  /// Sets a body and its nodes in motion.
  void set_motion(std::size_t body, const Vector& velocity, const Vector& angular_velocity, State& state);

  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  [[nodiscard]] const RigidBody& operator[](std::size_t body) const { return bodies_[body].body; }
  [[nodiscard]] bool holds(std::size_t node) const { return of_node_[node] != nobody; }
  /// The body that holds a node, nullptr where none does.
  [[nodiscard]] const RigidBody* of_node(std::size_t node) const {
    return holds(node) ? &bodies_[of_node_[node]].body : nullptr;
  }

  /// Lets a body of two nodes fail: its nodes then go on by themselves.
  void set_strength(std::size_t body, const LinkStrength& strength) { bodies_[body].strength = strength; }
  [[nodiscard]] bool failed(std::size_t body) const { return bodies_[body].nodes.empty(); }

  /// Velocities from the forces on the nodes over `mean`; returns the kinetic energy. `first`: the first cycle.
  double accelerate(const State& state, const Forces& net, double mean, bool first);
  /// Moves the bodies over dt and puts positions and velocities of their nodes into the state. A node's velocity is its
  /// way over dt, its angular velocity the one that spin_rotation() turns into the body's rotation.
  void move(State& state, double dt);

 private:
  static constexpr std::uint32_t nobody = 0xffffffffu;
  struct Body {
    RigidBody body;
    std::vector<NodeIndex> nodes;
    std::vector<Vector> local;  ///< of the nodes, from the centre, at the start
    unsigned held = 0;
    LinkStrength strength;
    bool failing = false;
  };
  /// Whether the link's force reaches its strength; `before`: the body before it was accelerated.
  static bool link_fails(const Body& entry, const RigidBody& before, const State& state, const Forces& net,
                         double mean);
  void release(Body& entry);
  std::vector<Body> bodies_;
  std::vector<std::uint32_t> of_node_;
};

}  // namespace gapcheck::solver
