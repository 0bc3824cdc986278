#pragma once
#include <cstdint>
#include <vector>

#include "base/ids.hpp"
#include "solver/condition/spring_law.hpp"
#include "solver/rigid/rigid_bodies.hpp"
#include "solver/state/force.hpp"
#include "solver/state/step_beside.hpp"

namespace gapcheck::solver {

/// Two nodes, or one and the ground: the node's initial position.
struct SpringInput {
  NodeIndex a, b = none<NodeIndex>;
  std::uint32_t law = 0;
  double scale = 1;   ///< on the force
  double offset = 0;  ///< elongation at the start; without effect if there is no length
  bool torsional = false;
  std::uint32_t element = 0;  ///< position in Mesh::discrete
};

/// Discrete springs and dampers. A force along the line between the nodes, positive in tension; if the nodes coincide
/// at the start, or there is only one, it follows the distance vector in all directions. Torsion turns about the line
/// between the nodes. Serial, in the order of the elements.
class Springs : public Force {
 public:
  /// Masses, inertias and rigid bodies give the stable step. Nodes must exist.
  Springs(std::vector<SpringLaw> laws, const std::vector<SpringInput>& springs, const State& state,
          const RigidBodies& rigid);

  void add(State& state, Forces& forces) override;
  void absorbed(Absorbed& work) const override { work.springs += energy_; }
  void held(Absorbed& energy) const override;
  /// An upper bound from the masses at the nodes, which leaves room for elements at the same nodes.
  [[nodiscard]] double stable_step() const override { return step_; }

  [[nodiscard]] std::size_t size() const { return springs_.size(); }
  [[nodiscard]] const SpringInput& input(std::size_t spring) const { return springs_[spring].input; }
  /// The force (or moment) on node a at the last evaluation.
  [[nodiscard]] const Vector& pull(std::size_t spring) const { return springs_[spring].pull; }
  /// Tension (or moment) and elongation (or angle) at the last evaluation.
  [[nodiscard]] double tension(std::size_t spring) const { return springs_[spring].tension; }
  [[nodiscard]] double elongation(std::size_t spring) const { return springs_[spring].elongation; }

 private:
  struct Spring {
    SpringInput input;
    Vector ground = Vector::Zero();  ///< position of node b if there is none
    double length = 0;               ///< at the start
    double tension = 0, elongation = 0;
    double resistance = 0;  ///< the part of the tension by dampers
    SpringHistory history;
    Vector pull = Vector::Zero();     ///< force or moment on a; b has the opposite
    Vector damping = Vector::Zero();  ///< the part of it by dampers
  };
  void find_rates(const State& state, const RigidBodies& rigid);
  [[nodiscard]] double stored() const;
  // They return the pull, and set its part by the damper.
  [[nodiscard]] Vector translation(const State& state, Spring& spring) const;
  [[nodiscard]] Vector torsion(const State& state, Spring& spring) const;
  void take_line(const State& state, Spring& spring, double rate) const;

  std::vector<SpringLaw> laws_;
  std::vector<Spring> springs_;
  double energy_ = 0, damped_ = 0;  ///< work since the start; what dampers took of it
  double initial_ = 0;              ///< stored at the start
  ForceRates rates_;                ///< upper bounds
  double step_ = 0;
};

}  // namespace gapcheck::solver
