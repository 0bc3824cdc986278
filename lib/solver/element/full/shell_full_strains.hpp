#pragma once
#include "solver/element/full/membrane_modes.hpp"
#include "solver/element/full/shell_full_frame.hpp"

namespace gapcheck::solver {

/// Rates of all strains of a quad with four points, or all its resultants, at the points.
struct FullStrains {
  PlaneTensor membrane, bending;
  Four zx, yz;  ///< whole shear angles
};

/// x: positions, n: normals at the corners, v and m: their rates. x,α·v,β is the rate of the metric, x,α·m,β + n,α·v,β
/// that of the curvature, x,α·m + n·v,α that of the transverse shear. None of them sees a rigid motion, warped or not.
[[nodiscard]] FullStrains full_rates(const FullFrame& frame, const MembraneModes& modes, const Bilinear& v,
                                     const Bilinear& m);

/// What works on v and m; the transpose of full_rates times the area.
void pull(const FullFrame& frame, const MembraneModes& modes, const FullStrains& resultants, Bilinear& on_v,
          Bilinear& on_m);

}  // namespace gapcheck::solver
