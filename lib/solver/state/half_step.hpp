#pragma once
#include <array>
#include <cstddef>

#include "base/vector.hpp"

namespace gapcheck::solver {

/// Where corners were half a step ago. `x`: positions at its end; `v`: velocities over it.
template <std::size_t N>
[[nodiscard]] std::array<Vector, N> half_step_ago(const std::array<Vector, N>& x, const std::array<Vector, N>& v,
                                                  double dt) {
  std::array<Vector, N> middle;
  for (std::size_t i = 0; i < N; ++i) middle[i] = x[i] - dt / 2 * v[i];
  return middle;
}

}  // namespace gapcheck::solver
