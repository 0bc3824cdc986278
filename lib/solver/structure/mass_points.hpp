#pragma once
#include <array>
#include <vector>

#include "solver/rigid/rigid_body.hpp"

namespace gapcheck::solver {

/// Point masses with the mass, centre and inertia of an element; for rigid bodies. Bricks: 2 x 2 x 2 Gauss points;
/// tetrahedra (corners 4 … 8 equal): four points, exact. Nothing if the volume is not above zero.
[[nodiscard]] std::vector<PointMass> solid_mass_points(const std::array<Vector, 8>& x, double density);

/// Shells: 2 x 2 Gauss points (corners 3 and 4 equal: the same on the collapsed quad), each halved to both sides of the
/// mid-surface by t / √12.
[[nodiscard]] std::vector<PointMass> shell_mass_points(const std::array<Vector, 4>& x, double thickness,
                                                       double density);

/// Beams: two Gauss points. Nothing without length.
[[nodiscard]] std::vector<PointMass> beam_mass_points(const std::array<Vector, 2>& x, double area, double density);

}  // namespace gapcheck::solver
