#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solver/state/force.hpp"
#include "solver/tie/tie_system.hpp"

namespace gapcheck::solver {

/// The nodes of all ties by constraints: how they can move in the next step, and their velocities in it without and
/// with the ties' loads. All arrays are by node of the structure; entries of other nodes mean nothing.
class TieNodes {
 public:
  /// The tied nodes and those of their segments; `count` nodes in the structure.
  void start(const std::vector<Tie>& ties, std::size_t count);
  /// Notes which degrees of freedom are held from `time` on for `next`; true if that has changed.
  bool hold(const Structure& structure, double time, double next);
  /// Velocities in the next step by the net forces without the ties, over the mean step.
  void let_free(const Structure& structure, double mean, double next, const Forces& net);
  /// Sets the velocities with ties to those of `state`, or to the free ones.
  void start_from(const State& state);
  void start_from_free();
  /// Adds to the velocities with ties what a force and a moment do over `mean`.
  void push(NodeIndex node, const Vector& force, const Vector& moment, double mean);

  [[nodiscard]] const Mobility& mobility() const { return mobility_; }
  [[nodiscard]] const std::vector<Vector>& free_v() const { return free_v_; }
  [[nodiscard]] const std::vector<Vector>& free_w() const { return free_w_; }
  [[nodiscard]] const std::vector<Vector>& v() const { return v_; }
  [[nodiscard]] const std::vector<Vector>& w() const { return w_; }

 private:
  std::vector<NodeIndex> used_;     ///< ascending
  std::vector<std::uint8_t> held_;  ///< beside used_; empty before the first hold()
  Mobility mobility_;
  std::vector<Vector> free_v_, free_w_, v_, w_;
};

/// Neither zero nor too small to divide by.
bool has_mass(double mass);

}  // namespace gapcheck::solver
