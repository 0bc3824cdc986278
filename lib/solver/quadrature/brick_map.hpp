#pragma once
#include <array>

#include "solver/quadrature/eight_points.hpp"
#include "solver/quadrature/solid_rule.hpp"

namespace gapcheck::solver {

/// A field on a brick by the products of ξ, η, ζ, without its constant: linear.col(j) ξⱼ, pairs.col(m) of the product
/// of the two others than ξₘ, and all ξηζ. For forces the sums over corners that belong to these shapes.
struct BrickModes {
  Matrix linear = Matrix::Zero(), pairs = Matrix::Zero();
  Vector all = Vector::Zero();
};

/// The modes of corner values.
[[nodiscard]] BrickModes brick_modes(const std::array<Vector, 8>& corners);
/// The corner forces of forces on modes; the transpose of brick_modes().
[[nodiscard]] std::array<Vector, 8> corner_forces(const BrickModes& forces);

/// One configuration of a brick at its 2 x 2 x 2 Gauss points.
///
/// Gradients follow from the columns ∂x/∂ξⱼ of the Jacobian. ELFORM -1 and -2 scale them (Borrvall, 7th European
/// LS-DYNA Conference, 2009) to J*, in which a term with ξₖ in column j has the factor κⱼₖ = min(1, lⱼ / lₖ) of the
/// lengths of the brick's axes. The same is done to the velocities, so linear fields are exact. ELFORM -1 scales all
/// components. ELFORM -2 resolves velocities in the brick's own axes eᵢ and leaves ∂vᵢ/∂ξᵢ as it is, in v and, for the
/// gradient of vᵢ, in J*: so the shear across the brick is scaled, but not the true strains. Then the mean is set to
/// that of the exact gradients, so that equal stresses have the forces of the patch test.
struct BrickMap {
  SolidRule rule = SolidRule::eight_points;
  bool good = false;              ///< the determinants at all points are above zero
  Matrix scale = Matrix::Ones();  ///< κ
  Matrix axes;                    ///< of ELFORM -2: columns eᵢ, the axes orthogonal in the order of their lengths
  EightMatrices inverse;          ///< of J*; not of ELFORM -2
  std::array<EightMatrices, 3> component_inverse;  ///< of ELFORM -2: of J* for each component
  Eight volume = Eight::Zero();                    ///< of the points
  double total = 0;                                ///< volume
  double least = 0;                                ///< eight times the volume of the least point
  BrickModes slope;                                ///< ∂(total)/∂x
};

[[nodiscard]] BrickMap brick_map(SolidRule rule, const BrickModes& x);

/// The mean of ∂v/∂x over the volume, exact.
[[nodiscard]] Matrix mean_gradient(const BrickMap& map, const BrickModes& v);
/// ∂v/∂x at the points; the mean over the volume is mean_gradient().
[[nodiscard]] EightMatrices brick_gradients(const BrickMap& map, const BrickModes& v);
/// Forces whose power is Σ volume · stress : brick_gradients() for any v.
[[nodiscard]] BrickModes brick_stress_forces(const BrickMap& map, const EightMatrices& stress);

/// An upper bound of what Σ volume · (`mean` |mean_gradient|² + `rest` |brick_gradients − mean_gradient|²) is at most
/// for velocities with Σ |v|² = 1 over the eight corners; `x`: of the map.
[[nodiscard]] double gradient_bound(const BrickMap& map, const BrickModes& x, double mean, double rest);

}  // namespace gapcheck::solver
