#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/ids.hpp"
#include "solver/state.hpp"

namespace gapcheck::solver {

/// A velocity over time, linear between points, constant beyond them; zero without points.
struct VelocityCurve {
  std::vector<std::array<double, 2>> points;  ///< time, velocity; times ascending
  [[nodiscard]] double at(double time) const;
};

/// Degrees of freedom that do not follow from forces: held, or moved with a given velocity. Six per node: x y z, then
/// the rotations about them.
class Constraints {
 public:
  void resize(std::size_t nodes) { mask_.assign(nodes, 0); }
  /// Holds the degrees of freedom in `mask` (bit 0: x … bit 5: rotation about z).
  void hold(NodeIndex node, std::uint8_t mask) { mask_[node.value] |= mask; }
  /// Moves one degree of freedom with the curve's velocity; of several on the same one the last counts.
  void move(NodeIndex node, std::size_t freedom, VelocityCurve curve);
  /// Once all are there.
  void finish();

  [[nodiscard]] std::uint8_t mask(std::size_t node) const { return mask_[node]; }
  /// The velocity of a constrained degree of freedom at a time. Moved ones are found by bisection.
  [[nodiscard]] double velocity(std::size_t node, std::size_t freedom, double time) const;

 private:
  struct Moved {
    std::uint64_t key;  ///< 6 · node + freedom
    VelocityCurve curve;
  };
  std::vector<std::uint8_t> mask_;
  std::vector<Moved> moved_;
};

}  // namespace gapcheck::solver
