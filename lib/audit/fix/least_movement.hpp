#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck::audit {

/// A linear condition on the moves u of a few nodes: Σ coefficientᵢ · direction · uᵢ >= bound, or = bound.
struct MoveCondition {
  struct Term {
    std::uint32_t node = 0;  ///< position in the arrays of least_movement()
    double coefficient = 0;
  };
  std::array<Term, 5> terms{};
  std::uint8_t count = 0;  ///< of terms
  bool equal = false;
  Vector direction = Vector::Zero();
  double bound = 0;
  double multiplier = 0;  ///< where the search starts, and what it found; without `equal` never negative
  /// Adds to the coefficient of a node. The sixth different node is left out: facets have four corners.
  void add(std::uint32_t node, double coefficient);
};

/// How well the conditions are met.
struct MovementResult {
  std::size_t sweeps = 0;  ///< and steps of conjugate gradients
  double worst = 0;        ///< largest violation of any condition that has a movable node
};

/// The moves with the least Σ |uᵢ|² / mobilityᵢ (by axis) that satisfy all conditions: Gauss-Seidel with a projection
/// on the dual problem (Hildreth 1957), one multiplier per condition, with conjugate gradients in between, until no
/// condition is violated by more than `tolerance`, or after `sweeps`. `mobility`: by node and axis the inverse of the
/// weight; 0: held. `moves`: beside it, overwritten. Conditions whose nodes are all held are skipped. Contradicting
/// conditions stay violated, with growing multipliers. Source: C. Hildreth, A quadratic programming procedure, 1957.
MovementResult least_movement(std::span<MoveCondition> conditions, std::span<const Vector> mobility,
                              std::span<Vector> moves, double tolerance, std::size_t sweeps);

/// How far the condition is from being satisfied; negative: satisfied with a margin (0 for equations).
[[nodiscard]] double violation(const MoveCondition& condition, std::span<const Vector> moves);

/// How much the left side changes with the multiplier; 0: no node can move for it.
[[nodiscard]] double compliance(const MoveCondition& condition, std::span<const Vector> mobility);

}  // namespace gapcheck::audit
