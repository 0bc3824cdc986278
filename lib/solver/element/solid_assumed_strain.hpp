#pragma once
#include <array>

#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// Amplitudes of the hourglass modes ηζ, ζξ, ξη and ξηζ of a brick, in its axes.
using BrickModeAmplitudes = std::array<Vector, 4>;

/// Elastic energy of a brick's hourglass modes with assumed strains (Belytschko and Bindeman, Comput. Methods Appl.
/// Mech. Engng 105, 1993: ASQBI), in the axes of the brick and integrated over the box with the sides 2 sᵢ. A strain
/// that is linear in one direction is a bending of a plate across it: direct strains of the two other directions
/// without stress in the first, and their twist, but no shear of the bending itself. The fourth mode stretches in one
/// direction at a time, without stress across. Coefficient 1: a single layer of bricks has the bending stiffness of a
/// plate and does not lock where the material is incompressible.
struct AssumedStrain {
  Vector half_side = Vector::Ones();  ///< sᵢ
  double bending = 0;                 ///< E / (1 − ν²) V / 3, times the coefficient
  double poisson = 0;
  double twisting = 0;  ///< G V / 3
  double single = 0;    ///< E V / 9

  [[nodiscard]] double energy(const BrickModeAmplitudes& q) const;
  /// ∂(energy)/∂q.
  [[nodiscard]] BrickModeAmplitudes forces(const BrickModeAmplitudes& q) const;
  /// The largest row sum of the second derivatives: a bound of the largest eigenvalue.
  [[nodiscard]] double bound() const;
};

/// The elastic constants by shear and bulk modulus; nothing without shear stiffness.
[[nodiscard]] AssumedStrain assumed_strain(double coefficient, double shear, double bulk, double volume,
                                           const Vector& half_side);

/// The rotation in a = R S, S symmetric: axes that do not depend on the order of a's columns beyond their own names.
[[nodiscard]] Matrix polar_rotation(const Matrix& a);

/// ∂(m · δθ)/∂a for the turn δθ of a's polar rotation `r`: the matrix g with g : δa = m · δθ.
[[nodiscard]] Matrix polar_turn(const Matrix& a, const Matrix& r, const Vector& m);

}  // namespace gapcheck::solver
