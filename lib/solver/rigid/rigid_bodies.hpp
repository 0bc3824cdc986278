#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/ids.hpp"
#include "solver/rigid/rigid_body.hpp"
#include "solver/rigid/rigid_joints.hpp"
#include "solver/state/motion.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// Result of accelerating all bodies: their kinetic energy, and the work of forces at their centres and of imposed
/// motions in the last step.
struct BodyEnergies {
  double kinetic = 0, printed_kinetic = 0, work = 0;
};

/// When a rigid link of two nodes fails: at (fn / normal)^p + (|fs| / shear)^q >= 1, with the tension fn along the link
/// and the force fs across it (the whole force if the nodes coincide), or at a time. Zero: no such limit.
struct LinkStrength {
  double normal = 0, shear = 0, normal_power = 1, shear_power = 1;
  double time = 0;
  [[nodiscard]] bool limited() const { return normal > 0 || shear > 0 || time > 0; }
};

/// The rigid bodies of a structure and the nodes that move with them.
class RigidBodies {
 public:
  void resize(std::size_t nodes) { of_node_.assign(nodes, no_position); }
  /// Adds a body of the points' mass; the masses that `state` has at its nodes count too. Nodes that already belong to
  /// a body stay there. Returns its position.
  std::size_t add(std::vector<PointMass> points, std::span<const NodeIndex> nodes, const State& state);
  /// Gives a body another mass, centre and inertia (about the centre, at the start).
  void set_mass(std::size_t body, double mass, const Vector& center, const Matrix& inertia, const State& state);
  /// Holds the degrees of freedom in `mask` (bit 0: x … bit 5: rotation about z).
  void hold(std::size_t body, unsigned mask) { bodies_[body].held |= mask; }
  /// Moves a degree of freedom of the centre or of the rotation; of several active motions of the same one the last
  /// counts.
  void move(std::size_t body, std::size_t freedom, Motion motion);
  /// Sets a body and its nodes in motion.
  void set_motion(std::size_t body, const Vector& velocity, const Vector& angular_velocity, State& state);
  /// Lets those motions act that do in a dynamic relaxation, or in the run.
  void begin_phase(bool relaxing);
  /// Gives held and moved degrees of freedom their velocity at state.time and writes the bodies to the state; before
  /// the first step.
  void start(State& state);

  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  [[nodiscard]] const RigidBody& operator[](std::size_t body) const { return bodies_[body].body; }
  [[nodiscard]] bool holds(std::size_t node) const { return of_node_[node] != no_position; }
  /// The body that a node belongs to.
  [[nodiscard]] std::optional<std::size_t> body_of(std::size_t node) const {
    return holds(node) ? std::optional<std::size_t>(of_node_[node]) : std::nullopt;
  }
  [[nodiscard]] const std::vector<NodeIndex>& nodes(std::size_t body) const { return bodies_[body].nodes; }
  [[nodiscard]] unsigned held(std::size_t body) const { return bodies_[body].held; }
  /// The motions of a body with their freedoms.
  [[nodiscard]] const std::vector<std::pair<std::size_t, Motion>>& motions(std::size_t body) const {
    return bodies_[body].motions;
  }
  /// The body that holds a node, nullptr if none does.
  [[nodiscard]] const RigidBody* of_node(std::size_t node) const {
    return holds(node) ? &bodies_[of_node_[node]].body : nullptr;
  }

  /// Lets a body of two nodes fail: its nodes then move independently.
  void set_strength(std::size_t body, const LinkStrength& strength) { bodies_[body].strength = strength; }
  [[nodiscard]] bool failed(std::size_t body) const { return bodies_[body].nodes.empty(); }

  /// Adds a joint between two bodies; when these have their masses and are as they start.
  void add_joint(RigidJoint joint);
  [[nodiscard]] const std::vector<RigidJoint>& joints() const { return joints_.list(); }
  [[nodiscard]] double joint_error() const { return joints_.error(views()); }

  /// What a body did in the last accelerate().
  struct Response {
    Vector acceleration = Vector::Zero(), spin_rate = Vector::Zero();    ///< of the centre, over the mean of the steps
    Vector reaction = Vector::Zero(), reaction_moment = Vector::Zero();  ///< on it, of what imposes its motion
    Vector link = Vector::Zero();  ///< force by which a link of two nodes pulls the first one to the second
  };
  [[nodiscard]] const Response& response(std::size_t body) const { return bodies_[body].response; }
  /// The acceleration of a place that moves with a body, over the mean of the steps.
  [[nodiscard]] Vector acceleration_at(std::size_t body, const Vector& x) const;

  /// The forces on a body at its centre, and what is imposed on it in the step `next`.
  [[nodiscard]] BodyLoad load_on(std::size_t body, const State& state, const Forces& net, double next) const;
  /// Velocities for the step `next` from the forces over `mean`. `first`: the first cycle.
  BodyEnergies accelerate(const State& state, const Forces& net, double mean, double next, bool first);
  /// Moves the bodies over dt and puts positions and velocities of their nodes into the state. A node's velocity is its
  /// displacement over dt, its angular velocity the one that spin_rotation() turns into the body's rotation.
  void move(State& state, double dt);

 private:
  struct Body {
    RigidBody body;
    std::vector<NodeIndex> nodes;
    std::vector<Vector> local;  ///< of the nodes, from the centre, at the start
    unsigned held = 0;
    std::vector<std::pair<std::size_t, Motion>> motions;
    LinkStrength strength;
    bool failing = false;
    Response response;
    double power = 0;  ///< of forces at the centre and imposed motions at the start of the present step
    /// The imposed motions in the step from `time` over dt.
    [[nodiscard]] Imposed imposed(double time, double dt) const;
  };
  void tell(State& state) const;
  [[nodiscard]] std::vector<const RigidBody*> views() const;
  /// Whether the link's force reaches its strength.
  static bool link_fails(const Body& entry, const State& state);
  /// The force on the first of two nodes besides those that act on it: m a − f.
  static Vector link_force(const Body& entry, const RigidBody& before, const State& state, const Forces& net,
                           double mean);
  static Response response_of(const Body& entry, const RigidBody& before, const Push& push, double mean);
  void release(Body& entry);
  std::vector<Body> bodies_;
  RigidJoints joints_;
  std::vector<std::uint32_t> of_node_;
};

}  // namespace gapcheck::solver
