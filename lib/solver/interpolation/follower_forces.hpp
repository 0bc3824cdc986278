#pragma once
#include <Eigen/Dense>
#include <cstdint>
#include <vector>

#include "model/model.hpp"
#include "solver/interpolation/follower.hpp"
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
  /// Followers that share nodes.
  struct Group {
    std::vector<std::size_t> followers;
    std::vector<std::uint32_t> nodes;                 ///< followed, ascending
    std::vector<std::vector<std::size_t>> positions;  ///< by follower, of its nodes in these
    std::vector<Eigen::Index> first;                  ///< by follower: its first row
    Eigen::Index rows = 0;
    // The last forces at the nodes and the place where they act, for the work.
    Column at_nodes;
  };
  /// The elements whose failure deletes a node.
  struct Watched {
    std::uint32_t node = 0;
    std::size_t follower = 0;
    std::vector<std::uint32_t> shells, solids, beams;  ///< positions in the model
  };
  void make_groups();
  void watch_nodes(const model::Model& model);
  void find_deleted(const State& state);
  [[nodiscard]] Rows coefficients(const Group& group, const Column& places, const std::vector<Vector>& points) const;
  /// The inverse mass of a node's translations, 0 in held directions, and its velocity in the next step without loads.
  [[nodiscard]] Vector mobility_of(std::uint32_t node, const State& state, double next) const;
  [[nodiscard]] Vector free_velocity(std::uint32_t node, const State& state, double mean, double next,
                                     const Forces& net) const;
  void solve(Group& group, const State& state, double mean, double next, Forces& net, Forces& external);

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
