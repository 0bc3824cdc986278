#pragma once
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// Mooney–Rivlin rubber, material 027: per undeformed volume the energy
/// W = A (I₁ − 3) + B (I₂ − 3) + C (I₃⁻² − 1) + D (I₃ − 1)² of the invariants of b = F Fᵀ (LS-DYNA theory manual).
/// C frees the undeformed state from stress, D gives it Poisson's ratio ν; its shear modulus is 2 (A + B).
struct Rubber {
  double a = 0, b = 0, c = 0, d = 0;
};

/// The constants for A, B and ν in (−1, ½): C = A/2 + B, D = [A (5ν − 2) + B (11ν − 5)] / (2 (1 − 2ν)).
[[nodiscard]] Rubber mooney_rivlin(double a, double b, double poisson);

/// Cauchy stress of a deformation gradient F, det F > 0.
[[nodiscard]] Symmetric rubber_stress(const Rubber& rubber, const Matrix& f);

/// W of F, det F > 0.
[[nodiscard]] double rubber_energy(const Rubber& rubber, const Matrix& f);

/// An upper bound of the second derivative of W with respect to ε where F grows to (1 + ε g) F, per squared norm of g;
/// with the stress's own part, and for any g. Without deformation and for ν near ½ it is near 3 K.
[[nodiscard]] double rubber_stiffness_bound(const Rubber& rubber, const Matrix& f);

}  // namespace gapcheck::solver
