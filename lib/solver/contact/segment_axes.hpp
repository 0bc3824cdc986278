#pragma once
#include <array>
#include <vector>

#include "model/entity/sets.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// Axes that turn with a segment: the normal of its diagonals (of a triangle: of two sides) and, in the plane, the
/// bisector of these. Their angular velocity is linear in the velocities of the corners.
struct SegmentAxes {
  SegmentAxes() { turn.fill(Matrix::Zero()); }
  SegmentAxes(const model::SegmentNodes& nodes, const std::vector<Vector>& x);
  /// Positions of the corners after `time` with these velocities.
  SegmentAxes(const model::SegmentNodes& nodes, const std::vector<Vector>& x, const std::vector<Vector>& v,
              double time);
  bool sound = false;                ///< false: the segment has no area; the rest is undefined
  Matrix axes = Matrix::Identity();  ///< by column
  std::array<Matrix, 4> turn{};      ///< angular velocity = Σ turn[i] · velocity of corner i
  [[nodiscard]] Vector spin(const model::SegmentNodes& nodes, const std::vector<Vector>& v) const;
  /// The part of a rotation about the normal, as a projector.
  [[nodiscard]] Matrix drill() const { return axes.col(2) * axes.col(2).transpose(); }

 private:
  SegmentAxes(const std::array<Vector, 4>& corners, bool triangle);
};

}  // namespace gapcheck::solver
