#pragma once
#include <array>

namespace gapcheck::solver {

/// Weights of a segment's corners at parametric coordinates; of a triangle the last two belong to one node.
[[nodiscard]] inline std::array<double, 4> corner_weights(double s, double t) {
  const double left = (1 - s) / 2, right = (1 + s) / 2, low = (1 - t) / 2, high = (1 + t) / 2;
  return {left * low, right * low, right * high, left * high};
}

}  // namespace gapcheck::solver
