#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <vector>

#include "model/model.hpp"
#include "solver/interpolation/follower_groups.hpp"
#include "solver/interpolation/motion_fit.hpp"
#include "solver/state/force.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Nodes that follow others (*CONSTRAINED_INTERPOLATION), with or without mass of their own. When all other forces are
/// known, the forces that let them follow are solved for; by virtual work the followed nodes get their opposite, with
/// the same resultant force and moment. Followers that share nodes are solved together. The velocity of a step is that
/// of the fit halfway through it, so a body that turns takes its followers along without drift. See
/// docs/theory/solver-interpolation.md.
class FollowerForces : public Force {
 public:
  /// `structure`: the one that is stepped, of this model; it must outlive the forces.
  FollowerForces(std::vector<Follower> followers, const model::Model& model, const Structure& structure);

  /// Sets the followers' initial velocities, and notices deleted nodes.
  void add(State& state, Forces& forces) override;
  [[nodiscard]] bool reacts() const override { return !followers_.empty(); }
  void react(const State& state, double mean, double next, Forces& net, Forces& external) override;
  void follow(State& state) override;
  [[nodiscard]] SolverStatus status() const override { return status_; }

  /// What a follower gets, force and then moment, at the last evaluation.
  [[nodiscard]] Twist load(std::size_t follower) const { return followers_[follower].axes * loads_[follower]; }
  /// Work that the forces have taken from followers and followed nodes together, by the trapezoidal rule: what a finite
  /// step leaves of zero.
  [[nodiscard]] double residue() const { return residue_; }

 private:
  using Column = Eigen::VectorXd;
  using Rows = Eigen::MatrixXd;
  struct Group : FollowerGroup {
    Column at_nodes;  ///< the last forces on its nodes, one after the other
  };
  /// A group before its loads are known: by column of the coefficients, then by row, then by follower.
  struct Present {
    Column places, before, free, mobility;  ///< of the nodes: velocities of the last step, and without loads
    Column mass, own, force;                ///< along the followers' axes: velocities of the last step, forces
    std::vector<Vector> points, drifting;   ///< places of the followers, and velocities without loads
  };
  struct Solution {
    Column load, velocity;  ///< along the followers' axes; velocity: in the next step
  };
  /// The elements whose failure deletes a node.
  struct Watched {
    std::uint32_t node = 0;
    std::size_t follower = 0;
    std::vector<std::uint32_t> shells, solids, beams;  ///< positions in the model
  };
  void watch_nodes(const model::Model& model);
  void find_deleted(const State& state);
  [[nodiscard]] Rows coefficients(const Group& group, const Column& places, const std::vector<Vector>& points) const;
  /// The inverse mass of a node's translations, 0 in held directions, and its velocity in the next step without loads.
  [[nodiscard]] Vector mobility_of(std::uint32_t node, const State& state, double next) const;
  [[nodiscard]] Vector free_velocity(std::uint32_t node, const State& state, double mean, double next,
                                     const Forces& net) const;
  [[nodiscard]] Present present(const Group& group, const State& state, double mean, double next,
                                const Forces& net) const;
  [[nodiscard]] std::vector<Vector> halfway(const Group& group, const Present& now, const Column& wanted,
                                            double next) const;
  [[nodiscard]] Solution solve(const Group& group, const Present& now, const Rows& c, double mean, double next) const;
  void push(const Group& group, const Solution& solution, Forces& forces) const;

  std::vector<Follower> followers_;
  const Structure& structure_;
  std::vector<Group> groups_;
  std::vector<Column> loads_;    ///< by follower: along its axes
  std::vector<Column> targets_;  ///< by follower: velocities along its axes in the next step
  std::vector<Watched> watched_;
  std::uint64_t failures_ = 0;  ///< elements that had failed when deleted nodes were last looked for
  double residue_ = 0;
  SolverStatus status_;
};

}  // namespace gapcheck::solver
