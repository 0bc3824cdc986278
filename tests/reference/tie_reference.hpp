#pragma once
#include <array>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck::reference {

/// One segment of a reference surface: corners (a triangle repeats its last one) and shell thickness.
struct TieSegment {
  std::array<Vector, 4> corners;
  bool triangle = false;
  double thickness = 0;
};

/// What the written rule says of one node.
struct TieVerdict {
  bool ties = false;
  /// False: within rounding of a limit, or the foot on a warped quad was not found; nothing follows from `ties` then.
  bool certain = true;
  long double nearest = -1;  ///< distance of the nearest segment that it ties to
};

/// The tie rule for shells in its plainest form: every segment, 64 digits of mantissa, the nearest point of a quad from
/// its edges and the feet found by Newton's method from a grid of starts. d <= max(0.6 (t + ts), 0.05 min diagonal),
/// with the tolerance 1e-9 d + 4 units in the last place of the largest coordinate; the foot within `parmax`.
/// Independent of lib/geometry and lib/contact on purpose.
[[nodiscard]] TieVerdict tie_verdict(const std::vector<TieSegment>& segments, const Vector& node, double node_thickness,
                                     double parmax);

}  // namespace gapcheck::reference
