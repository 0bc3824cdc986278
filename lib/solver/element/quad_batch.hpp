#pragma once
#include <array>
#include <cstddef>
#include <span>

#include "base/ids.hpp"
#include "base/triple.hpp"
#include "solver/element/shell.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// Flat quads with one point in the plane side by side, all of one part: what quad_forces() does, several at once.
/// Every operation is that of quad_forces(), rounded in the same order, so the results are the same to the last bit
/// whatever the processor and the neighbours. Arrays by quad.
struct QuadBatch {
  static constexpr std::size_t capacity = 16;
  using Row = std::array<double, capacity>;
  using Rows = std::array<Row, 3>;  ///< of vectors, by axis

  /// Whether quads with these properties can be in a batch.
  [[nodiscard]] static bool takes(const ShellProperties& properties);

  std::size_t size = 0;
  // Set by add(); hourglass stresses are updated by begin(), the thickness by integrate().
  std::array<Rows, 4> x, v, w;  ///< corners, as in ShellCorners
  Row thickness;
  std::array<Row, 5> hourglass, stiffness;
  // Set by begin().
  Rows e1, e2, e3;  ///< axes at the end of the step
  Row area, bx1, bx2, by1, by2, shape_x, shape_y, warp;
  Row middle_area, hourglass_work;
  std::array<Row, 8> strain;  ///< in the order of ShellStrain's members
  // Set by integrate().
  std::array<Row, 8> resultant;  ///< in the order of ShellResultants' members
  // Set by end().
  std::array<Rows, 4> force, moment;
  Row manual_step, stable_step;
  Row gradient;  ///< of end() alone

  /// The batch must not be full. `nodes`: of the corners.
  void add(const std::array<NodeIndex, 4>& nodes, const State& motion, const ShellState& state);
  /// Between begin() and end(), for each quad: updates its points and its state to the end of the step. Returns the
  /// plastic work per area.
  double integrate(std::size_t i, const ShellProperties& properties, double dt, ShellState& state,
                   std::span<PointState> points);
  /// Replaces the corners' forces and moments; returns the work of the old and the new ones over the step.
  [[nodiscard]] double exchange(std::size_t i, double dt, std::span<Vector, 4> forces,
                                std::span<Vector, 4> moments) const;
  /// Everything else that quad_forces() returns; forces and moments are not set.
  [[nodiscard]] ShellForces rest_of(std::size_t i, const ShellProperties& properties, double plastic_work) const;

  /// Frames, hourglass stresses and strains. `lanes`: at most those of the processor.
  void begin(const ShellProperties& properties, double dt, Lanes lanes = lanes_of_processor());
  /// Forces and steps of the resultants.
  void end(const ShellProperties& properties, Lanes lanes = lanes_of_processor());

 private:
  void pad_corners();
  void pad_resultants();
};

}  // namespace gapcheck::solver
