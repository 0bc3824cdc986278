#pragma once
#include <cstdint>

namespace gapcheck::solver {

/// How modes without strain are controlled: by their velocity, by their amplitude, or, in bricks, by the strain that is
/// assumed for their amplitude.
enum class HourglassKind : std::uint8_t { none, viscous, stiffness, assumed_strain };

/// IHQ 1–3 are viscous, 4 and 5 stiffness, in bricks 6 and 7 assumed strain; QM is the coefficient (default 0.1).
struct Hourglass {
  HourglassKind kind = HourglassKind::viscous;
  double coefficient = 0.1;  ///< QM; of shells that of the membrane
  double bending = 0.1;      ///< of shells: QB, rotations
  double warping = 0.1;      ///< of shells: QW, deflection
  /// Of bricks, IHQ 3, 5 and above: gradients and volume are means over the brick, otherwise those of its centre.
  bool exact_volume = false;
  /// Of bricks, IHQ 1: the modes' own shapes, which linear motion of a brick that is no parallelepiped has a part in.
  bool plain_shapes = false;

  void set_all(double q) { coefficient = bending = warping = q; }
};

}  // namespace gapcheck::solver
