#pragma once
#include <array>
#include <cstdint>

#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// INN of *CONTROL_ACCURACY: where the first axis of a quad lies.
enum class ShellAxes : std::uint8_t {
  side,       ///< along the side from corner 1 to 2
  invariant,  ///< 45° from the bisector of ξ and η: starting with the next corner turns the axes by exactly 90°
};

inline Vector unit_of(const Vector& a) { return a.normalized(); }

/// The first of the invariant axes. `xi`, `eta`: between the middles of opposite sides, in the plane of the quad. The
/// bisector and what is left of the difference of two unit vectors are perpendicular.
template <class V>
V invariant_direction(const V& xi, const V& eta) {
  const V a = unit_of(xi), b = unit_of(eta);
  return unit_of(V(a + b)) + unit_of(V(a - b));
}

/// The axes of a quad with corners `x`, as columns: those of its points' stresses.
[[nodiscard]] Matrix quad_axes(const std::array<Vector, 4>& x, ShellAxes axes = ShellAxes::side);
/// The same of a triangle.
[[nodiscard]] Matrix triangle_axes(const std::array<Vector, 4>& x);
/// The same of a quad with 2 x 2 points.
[[nodiscard]] Matrix full_axes(const std::array<Vector, 4>& x, ShellAxes axes = ShellAxes::side);

}  // namespace gapcheck::solver
