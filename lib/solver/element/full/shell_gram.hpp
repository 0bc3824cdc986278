#pragma once
#include "solver/element/full/shell_full_frame.hpp"

namespace gapcheck::solver {

/// Largest quotients of energy over Σ u² of the corners for bilinear fields in a quad with four points, in units in
/// which the mass of a corner and the moduli are one. With corner values u, the coefficients of 1, ξ, η and ξη
/// have Σ u² = 4 (mean² + xi² + eta² + both²).
struct QuadGram {
  Four xi, eta, both;  ///< at the points: ∇ξ·∇ξ, ∇η·∇η, ∇ξ·∇η, times the area that a point stands for

  /// Of ∫ |∇u|². Exact.
  [[nodiscard]] double gradient() const;
  /// Of the transverse shear, by deflections and by rotations of this inertia per mass: an upper bound, at most 9 %
  /// too large. `along`, `across`, `skew`: coefficients of ξ, η and ξη of the positions.
  [[nodiscard]] double shear(const Vector& along, const Vector& across, const Vector& skew, double inertia) const;
};

/// The largest eigenvalue of a symmetric matrix, in closed form (Smith, Comm. ACM 4, 1961).
[[nodiscard]] double largest_eigenvalue(const Eigen::Matrix3d& a);

}  // namespace gapcheck::solver
