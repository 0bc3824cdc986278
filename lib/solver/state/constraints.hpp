#pragma once
#include <cstdint>
#include <vector>

#include "base/ids.hpp"
#include "solver/state/motion.hpp"
#include "solver/state/state.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// Degrees of freedom that do not follow from forces: held, or moved with a given velocity. Six per node: x y z, then
/// the rotations about them, in the global axes or in the node's own ones, which stay as they are.
class Constraints {
 public:
  void resize(std::size_t nodes) { held_.assign(nodes, 0), ever_.assign(nodes, 0); }
  /// Axes (columns) for any number of nodes; returns their position.
  std::uint32_t add_axes(const Matrix& axes);
  /// Gives a node axes of its own, before anything holds or moves it.
  void set_axes(NodeIndex node, std::uint32_t axes);
  /// The axes of a node's degrees of freedom; nullptr: global ones.
  [[nodiscard]] const Matrix* axes(std::size_t node) const {
    return axes_of_.empty() || axes_of_[node] == no_position ? nullptr : &axes_[axes_of_[node]];
  }
  /// A node with its own axes; none if there is no such node.
  [[nodiscard]] NodeIndex first_with_axes() const;
  /// Holds the degrees of freedom in `mask` (bit 0: x … bit 5: rotation about z).
  void hold(NodeIndex node, std::uint8_t mask);
  /// A motion for any number of degrees of freedom; returns its position.
  std::uint32_t add(Motion motion);
  /// Moves one degree of freedom; of several active motions of the same one the last counts.
  void move(NodeIndex node, std::size_t freedom, std::uint32_t motion);
  void move(NodeIndex node, std::size_t freedom, Motion motion) { move(node, freedom, add(std::move(motion))); }
  /// Call it once all are added.
  void finish();
  /// Lets those motions act that do in a dynamic relaxation, or in the run.
  void begin_phase(bool relaxing) {
    for (Motion& motion : motions_) motion.relaxing = relaxing;
  }

  /// Degrees of freedom that are held or moved at any time.
  [[nodiscard]] std::uint8_t mask(std::size_t node) const { return ever_[node]; }
  [[nodiscard]] std::uint8_t held(std::size_t node) const { return held_[node]; }
  /// The motions of one degree of freedom, in the order in which they were given.
  [[nodiscard]] std::vector<const Motion*> motions(std::size_t node, std::size_t freedom) const;
  /// Those that are held or moved in the step from `time` over dt.
  [[nodiscard]] std::uint8_t mask(std::size_t node, double time, double dt) const;
  /// The velocity of a constrained degree of freedom in that step. Moved ones are found by bisection.
  [[nodiscard]] double velocity(std::size_t node, std::size_t freedom, double time, double dt) const;

 private:
  struct Moved {
    std::uint64_t key;  ///< 6 · node + freedom
    std::uint32_t motion;
  };
  [[nodiscard]] const Motion* active(std::size_t node, std::size_t freedom, double time, double dt) const;
  std::vector<std::uint8_t> held_, ever_;
  std::vector<Matrix> axes_;
  std::vector<std::uint32_t> axes_of_;  ///< by node; empty: all have global axes
  std::vector<Motion> motions_;
  std::vector<Moved> moved_;
};

}  // namespace gapcheck::solver
