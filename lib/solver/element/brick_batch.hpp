#pragma once
#include <array>
#include <cstddef>

#include "base/ids.hpp"
#include "base/triple.hpp"
#include "solver/element/solid.hpp"
#include "solver/state/state.hpp"

namespace gapcheck::solver {

/// Bricks with one point side by side, all of one part: what brick_forces() does, several at once. Every operation is
/// that of brick_forces(), rounded in the same order, so the results are the same to the last bit whatever the
/// processor and the neighbours. Arrays by brick.
struct BrickBatch {
  static constexpr std::size_t capacity = 16;
  using Row = std::array<double, capacity>;
  using Rows = std::array<Row, 3>;  ///< of vectors, by axis
  using Six = std::array<Row, 6>;   ///< of tensors, by component

  /// Whether bricks with these properties can be in a batch. Not those whose stress follows from the deformation or
  /// from an equation of state, nor what may erode or tear, nor what stiffness holds in shape.
  [[nodiscard]] static bool takes(const SolidProperties& properties);

  std::size_t size = 0;
  // Set by add().
  std::array<Rows, 8> x, v;  ///< corners, as in SolidCorners
  Row mass;
  Row viscous_pressure;           ///< that of the end of the step after begin()
  std::array<Rows, 4> hourglass;  ///< stresses; those of the end of the step after begin()
  Six stress;  ///< begin() turns it with the material and, of Hooke's law alone, adds that of the step; integrate()
  // Set by begin().
  Row middle_volume, volume;
  std::array<Rows, 8> slope;       ///< V ∂N/∂x at the end of the step
  std::array<Rows, 4> middle_sum;  ///< Σ shape · x in the middle of the step
  std::array<Rows, 3> rate;        ///< velocity gradient in the middle of the step, by row
  std::array<Rows, 3> rotation;    ///< of the material in the step, by row
  Six strain;                      ///< of the step, in the axes of its end
  Row volume_rate, damping, viscous_work, hourglass_work;
  Row root;  ///< V^(2/3), of viscous hourglass control
  Row manual_step, stable_step;
  // Set by end().
  std::array<Rows, 8> force;

  /// The batch must not be full. `nodes`: of the corners.
  void add(const std::array<NodeIndex, 8>& nodes, const State& motion, const SolidState& state,
           const PointState& point);
  /// Everything but the forces; of Hooke's law alone the stress too. `lanes`: at most those of the processor.
  void begin(const SolidProperties& properties, double dt, Lanes lanes = lanes_of_processor());
  /// Between begin() and end(), for each brick: updates its point and its state to the end of the step, unless it has
  /// no volume. Returns the plastic work per volume.
  double integrate(std::size_t i, const SolidProperties& properties, double dt, SolidState& state, PointState& point);
  /// Forces of the stresses.
  void end(const SolidProperties& properties, Lanes lanes = lanes_of_processor());
  /// What brick_forces() returns. `plastic_work`: what integrate() returned.
  [[nodiscard]] SolidForces forces(std::size_t i, double dt, double plastic_work) const;
  [[nodiscard]] Vector velocity(std::size_t i, std::size_t k) const { return {v[k][0][i], v[k][1][i], v[k][2][i]}; }

 private:
  /// The brick has a volume in the middle and at the end of the step.
  [[nodiscard]] bool whole(std::size_t i) const { return middle_volume[i] > 0 && volume[i] > 0; }
};

}  // namespace gapcheck::solver
