#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "contact/rigid_wall.hpp"
#include "solver/state/force.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// The action of one rigid wall at the time of the last force evaluation, and since the start.
struct WallState {
  std::uint32_t wall = 0;         ///< position in Model::rigid_walls
  Vector force = Vector::Zero();  ///< sum over its nodes, on them
  double normal_force = 0;        ///< sum of the forces along the wall's normals, not below zero
  double energy = 0;              ///< taken from the nodes
  std::uint64_t touching = 0;     ///< nodes with a force
};

/// Why a wall is left out of the calculation; empty: it is calculated.
[[nodiscard]] std::string_view wall_not_calculated(const model::RigidWall& wall);

/// Fixed rigid walls: perfectly plastic stops. A node that would be behind a wall at the end of the next step is put on
/// its surface instead, so it loses the velocity into the wall; one that is already behind goes no deeper and is not
/// moved out. Friction by Coulomb's law on the impulse along the wall (FRIC 1: no sliding). If several walls act on one
/// node, each sees the effect of those before it.
class RigidWalls : public Force {
 public:
  /// Walls that are not calculated, and nodes of rigid bodies that a wall ignores, are reported in `diagnostics`. Uses
  /// the constraints and rigid bodies that the structure has so far.
  RigidWalls(const model::Model& model, const Structure& structure, Diagnostics& diagnostics);

  void add(State&, Forces&) override {}
  [[nodiscard]] bool reacts() const override { return !walls_.empty(); }
  void react(const State& state, double mean, double next, Forces& net, Forces& external) override;
  void absorbed(Absorbed& work) const override;

  /// In the order of the deck, without those that are not calculated.
  [[nodiscard]] std::span<const WallState> states() const { return states_; }

 private:
  struct Wall {
    model::RigidWall data;
    std::vector<NodeIndex> nodes;
    std::vector<std::uint8_t> held;  ///< by node: constrained translations, one bit each
    std::vector<Vector> force;       ///< by node: on them, at the last evaluation
  };
  void react_one(const State& state, double mean, double next, Wall& wall, WallState& result, Forces& net,
                 Forces& external) const;

  std::vector<Wall> walls_;
  std::vector<WallState> states_;
};

}  // namespace gapcheck::solver
