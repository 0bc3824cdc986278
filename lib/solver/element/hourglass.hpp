#pragma once
#include <cstdint>

namespace gapcheck::solver {

/// How modes without strain are controlled: by their velocity or by their amplitude.
enum class HourglassKind : std::uint8_t { none, viscous, stiffness };

/// IHQ 1–3 are viscous, 4 and 5 stiffness; QM is the coefficient (default 0.1).
struct Hourglass {
  HourglassKind kind = HourglassKind::viscous;
  double coefficient = 0.1;
  /// Of bricks, IHQ 3, 5 and above: gradients and volume are means over the brick, otherwise those of its centre.
  bool exact_volume = false;
};

}  // namespace gapcheck::solver
