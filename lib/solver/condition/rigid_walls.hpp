#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/condition/wall_impulse.hpp"
#include "solver/condition/wall_penalty.hpp"
#include "solver/state/failure.hpp"
#include "solver/state/force.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// The action of one rigid wall at the time of the last force evaluation, and since the start.
struct WallState {
  std::uint32_t wall = 0;            ///< position in Model::rigid_walls
  Vector force = Vector::Zero();     ///< sum over its nodes, on them
  double normal_force = 0;           ///< sum of the forces along the wall's normals; below zero only by welded nodes
  double energy = 0;                 ///< taken from the nodes, in the frame of the wall
  std::uint64_t touching = 0;        ///< nodes with a force
  Vector velocity = Vector::Zero();  ///< over the next step
  Vector shift = Vector::Zero();     ///< since the start
};

/// Why a wall is left out of the calculation; empty: it is calculated.
[[nodiscard]] std::string_view wall_not_calculated(const model::RigidWall& wall);

/// A failure if a wall names something missing or contradicts itself.
[[nodiscard]] SolverStatus check_walls(const model::Model& model);

/// Rigid walls: perfectly plastic stops. A node that would be behind a wall at the end of the next step is put on
/// its surface instead, so it loses the velocity into the wall; one that is already behind goes no deeper and is not
/// moved out. Friction by Coulomb's law on the impulse along the wall (FRIC 1: no sliding). If several walls act on one
/// node, each sees the effect of those before it. A wall with a mass moves along its normal and takes up the momentum
/// that its nodes lose (LS-DYNA Theory Manual, rigid walls); others may follow a curve. RWPNAL lets springs stop nodes
/// of rigid bodies, or all.
class RigidWalls : public Force {
 public:
  /// Walls that are not calculated, and nodes of rigid bodies that a wall ignores, are reported in `diagnostics`. Uses
  /// the constraints and rigid bodies that the structure has so far. check_walls() has found no failure.
  RigidWalls(const model::Model& model, const Structure& structure, Diagnostics& diagnostics);

  void add(State& state, Forces& forces) override;
  [[nodiscard]] bool reacts() const override { return !walls_.empty(); }
  void react(const State& state, double mean, double next, Forces& net, Forces& external) override;
  void absorbed(Absorbed& work) const override;
  [[nodiscard]] double stable_step() const override { return stable_step_; }

  /// In the order of the deck, without those that are not calculated.
  [[nodiscard]] std::span<const WallState> states() const { return states_; }

 private:
  struct Wall {
    model::RigidWall data;
    std::vector<NodeIndex> nodes;
    std::vector<WallMemory> memory;  ///< by node
    std::vector<Vector> force;       ///< by node: on them, at the last evaluation
    std::vector<PenaltyNode> penalty;
    PenaltySums pressed;  ///< by the penalties, at the last evaluation
    Vector start = Vector::Zero();
    WallFriction friction;
    std::shared_ptr<const TimeCurve> curve;  ///< of its motion
    Vector direction = Vector::Zero();
    std::uint32_t first = no_position, second = no_position;  ///< nodes of the direction of orthotropic friction
    [[nodiscard]] bool active(double time) const {
      return time >= data.birth && (data.death <= 0 || time < data.death);
    }
  };
  struct Sums;
  void add_wall(const model::Model& model, std::uint32_t position, std::vector<NodeIndex> nodes,
                const Structure& structure, PenaltyNodes& penalty);
  void react_one(const State& state, double mean, double next, Wall& wall, WallState& result, Forces& net,
                 Forces& external) const;
  /// The velocity over the next step of a wall that follows a curve.
  [[nodiscard]] static Vector imposed(const Wall& wall, double time, double next);
  /// The same of a wall with a mass: its momentum and that of the nodes that it stops stay the same.
  [[nodiscard]] Vector free_velocity(const State& state, double mean, double next, const Wall& wall,
                                     const WallState& result, const Forces& net) const;
  [[nodiscard]] NodeAtWall node_at(const State& state, double mean, double next, const Wall& wall, std::size_t i,
                                   const Forces& net) const;

  Constraints constraints_;
  std::size_t bodies_ = 0;
  std::vector<Wall> walls_;
  std::vector<WallState> states_;
  double stable_step_ = std::numeric_limits<double>::infinity();
};

}  // namespace gapcheck::solver
