#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/ids.hpp"
#include "solver/discrete/beam_ends.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// Rigid arms from nodes to the ends of beams that are off them; by beam. They turn with the nodes.
class BeamArms {
 public:
  /// A beam between its nodes.
  void add() { which_.push_back(no_position); }
  /// Gives the beam that was added last arms. `inertia`: of its ends per mass.
  void set_last(const std::array<Vector, 2>& arm, double inertia) {
    which_.back() = static_cast<std::uint32_t>(arms_.size());
    arms_.push_back({arm, share_left_by(arm, inertia)});
  }
  [[nodiscard]] bool has(std::size_t beam) const { return which_[beam] != no_position; }
  /// What the arms add to the way from the first node to the second, and to the rotational inertia per mass of one.
  [[nodiscard]] Vector way(std::size_t beam) const {
    return has(beam) ? Vector(of(beam).arm[1] - of(beam).arm[0]) : Vector(Vector::Zero());
  }
  [[nodiscard]] double inertia(std::size_t beam, std::size_t k) const {
    return has(beam) ? of(beam).arm[k].squaredNorm() : 0;
  }
  /// The share of the stable step that is left.
  [[nodiscard]] double step(std::size_t beam) const { return has(beam) ? of(beam).step : 1; }
  /// The moment on an end of forces and moments on the nodes, and the other way round.
  [[nodiscard]] Vector at_end(std::size_t beam, std::size_t k, const Vector& force, const Vector& moment) const {
    return has(beam) ? Vector(moment - of(beam).arm[k].cross(force)) : moment;
  }
  [[nodiscard]] Vector at_node(std::size_t beam, std::size_t k, const Vector& force, const Vector& moment) const {
    return has(beam) ? Vector(moment + of(beam).arm[k].cross(force)) : moment;
  }
  /// Turns the arms over the last step, of length dt; the ends of the beam with these nodes.
  [[nodiscard]] BeamEnds turn(std::size_t beam, const BeamEnds& nodes, double dt) {
    if (!has(beam)) return nodes;
    BeamEnds ends = nodes;
    for (std::size_t k = 0; k < 2; ++k) {
      Vector& arm = arms_[which_[beam]].arm[k];
      const Vector before = arm;
      if (dt > 0) arm = spin_rotation(dt * nodes.w[k]) * before;
      ends.x[k] += arm;
      ends.v[k] += dt > 0 ? Vector((arm - before) / dt) : nodes.w[k].cross(arm);
    }
    return ends;
  }

 private:
  struct Arms {
    std::array<Vector, 2> arm;
    double step;
  };
  [[nodiscard]] const Arms& of(std::size_t beam) const { return arms_[which_[beam]]; }
  /// An end at a distance a from its node, whose inertia per mass is i + a², answers to forces and moments at most c
  /// times as much as one with i at its node: |f|² + |m + a × f|²/(i + a²) ≤ c (|f|² + |m|²/i). So ω² grows by c at
  /// most.
  static double share_left_by(const std::array<Vector, 2>& arm, double inertia) {
    double most = 1;
    for (const Vector& one : arm) {
      const double squared = one.squaredNorm(), both = std::sqrt(squared * inertia);
      if (!(squared > 0)) continue;
      most = std::max({most, 1 + (squared + both) / (inertia + squared),
                       (1 + std::sqrt(squared / inertia)) * inertia / (inertia + squared)});
    }
    return 1 / std::sqrt(most);
  }
  std::vector<Arms> arms_;
  std::vector<std::uint32_t> which_;  ///< by beam: position in arms_; no_position: none
};

}  // namespace gapcheck::solver
