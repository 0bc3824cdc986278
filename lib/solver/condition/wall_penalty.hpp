#pragma once
#include <limits>
#include <vector>

#include "model/model.hpp"
#include "solver/condition/wall_impulse.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// A node that a wall stops by a spring, as RWPNAL of *CONTROL_CONTACT has it.
struct PenaltyNode {
  std::uint32_t node = 0, body = no_position;  ///< body: that it belongs to
  double stiffness = 0;
  double compliance = 0;  ///< most that a unit impulse changes its velocity
  bool touches = false;
  Vector anchor = Vector::Zero();  ///< sticks there, in the wall's frame
  Vector force = Vector::Zero();   ///< on it, at the last evaluation
};

/// Springs of nodes for walls: 0.1 |RWPNAL| RWKSF times the mean over the node's elements of K A²/V of a cube with a
/// solid's volume, K A / longest side diagonal of a shell, weighted with areas: the spring that a contact would have
/// (contact rules, section 6.1). The manual gives no formula. Nodes without such elements get the mean of the others.
class PenaltyNodes {
 public:
  PenaltyNodes(const model::Model& model, const Structure& structure) : model_(model), structure_(structure) {}
  [[nodiscard]] std::vector<PenaltyNode> of(const std::vector<NodeIndex>& nodes, double scale);

 private:
  void sum_stiffness();
  const model::Model& model_;
  const Structure& structure_;
  std::vector<double> stiffness_;  ///< by node; empty: not asked for yet
};

/// The forces of one wall on its penalty nodes.
struct PenaltySums {
  Vector force = Vector::Zero();
  double normal_force = 0, work = 0;  ///< work: taken from the nodes in the last step, in the frame of the wall
  std::uint64_t touching = 0;
};

/// Adds a spring's force to nodes behind the wall, with friction by a second one along the surface that slips at μ
/// times the first one's. `shift`: of the wall since the start; `active`: between its birth and death.
[[nodiscard]] PenaltySums push_by_penalty(const WallInStep& wall, const Vector& shift, const State& state, bool active,
                                          std::vector<PenaltyNode>& nodes, std::vector<Vector>& force);

/// The longest stable step of all touching springs: 1.8 / ω of bodies, and for other nodes what leaves room for their
/// elements. `wall`: 1 / mass of the wall, 0 if it does not give way.
[[nodiscard]] double penalty_step(const std::vector<PenaltyNode>& nodes, std::size_t bodies, double wall);

}  // namespace gapcheck::solver
