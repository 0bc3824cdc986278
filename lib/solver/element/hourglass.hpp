#pragma once
#include <cstdint>

namespace gapcheck::solver {

/// How the modes without strain are held: by their speed or by their size.
enum class HourglassKind : std::uint8_t { none, viscous, stiffness };

/// IHQ 1–3 are viscous, 4 and 5 stiffness; QM is the coefficient (default 0.1).
struct Hourglass {
  HourglassKind kind = HourglassKind::viscous;
  double coefficient = 0.1;
};

}  // namespace gapcheck::solver
