#pragma once
#include <limits>
#include <span>
#include <vector>

#include "solver/interface/contact_source.hpp"

namespace gapcheck::solver {

/// A node that must not be behind a point of a segment at the end of the next step. Displacements are those that the
/// reactions add over that step.
struct SurfaceConstraint {
  NodeIndex node;
  ContactPoint segment;             ///< each node once
  Vector normal = Vector::UnitZ();  ///< from the segment to the node's side
  double depth = 0;                 ///< the required displacement of the node relative to the segment along `normal`
  Vector slip = Vector::Zero();     ///< relative displacement of node and segment over the step without reactions
  double friction = 0;              ///< coefficient
  double greatest_shear = std::numeric_limits<double>::infinity();
  double push = 0;                ///< result: reaction along `normal`, never below zero
  Vector shear = Vector::Zero();  ///< result: reaction across it, at most friction * push and greatest_shear
  /// On the node; the opposite acts on the segment.
  [[nodiscard]] Vector force() const { return push * normal + shear; }
};

/// The response of the nodes to forces over one step.
struct NodeResponse {
  std::vector<Vector> give;   ///< by node: displacement per force along each axis; zero if held
  std::vector<Vector> moved;  ///< by node: displacement due to the reactions
};

struct ConstraintSolution {
  std::size_t sweeps = 0;
  double open = 0;  ///< largest correction of a displacement in the last sweep
};

/// Finds reactions so that each constraint is either just met and pushes, or more than met without a reaction
/// (Signorini's conditions); Coulomb friction. Projected Gauss-Seidel sweeps in the order of the constraints, starting
/// from their present reactions, until no displacement changes by more than 1e-12 of the greatest depth and slip, at
/// most `most_sweeps` times. Adds the displacements to `response.moved`, which must already contain those of the
/// present reactions. The motion is unique even if the reactions are not (Cottle, Pang and Stone: The Linear
/// Complementarity Problem, 5.1).
ConstraintSolution solve_constraints(std::span<SurfaceConstraint> constraints, NodeResponse& response,
                                     std::size_t most_sweeps = 2000);

}  // namespace gapcheck::solver
