#pragma once
#include <array>

namespace gapcheck::solver {

/// Weights of a segment's corners at parametric coordinates (-1 to 1); of a triangle the last two belong to one node.
/// `line`: a beam axis, which has the first two corners and s alone.
[[nodiscard]] inline std::array<double, 4> corner_weights(bool line, double s, double t) {
  const double left = (1 - s) / 2, right = (1 + s) / 2, low = (1 - t) / 2, high = (1 + t) / 2;
  if (line) return {left, right, 0, 0};
  return {left * low, right * low, right * high, left * high};
}

}  // namespace gapcheck::solver
