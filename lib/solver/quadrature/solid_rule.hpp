#pragma once
#include <array>
#include <cstdint>

#include "base/ids.hpp"

namespace gapcheck::solver {

/// How a solid with eight corners is integrated.
enum class SolidRule : std::uint8_t {
  one_point,       ///< ELFORM 1
  eight_points,    ///< ELFORM 2
  efficient,       ///< ELFORM -1: eight points, gradients scaled by the ratios of the sides
  accurate,        ///< ELFORM -2: the same, but in the shear terms of the brick's own axes alone
  wedge,           ///< ELFORM 15: eight points of a brick with two collapsed edges, and the masses of six corners
  nodal_pressure,  ///< ELFORM 13, tetrahedra alone: one point, the volume strain is averaged at the nodes
};

/// The shapes that eight corners can have, some of them equal.
enum class SolidShape : std::uint8_t {
  brick,        ///< eight different corners
  wedge,        ///< six; the two edges that are points are opposite edges of one side
  tetrahedron,  ///< n4 … n8 are equal
  other,        ///< a pyramid, or any other
};
[[nodiscard]] SolidShape solid_shape(const std::array<NodeIndex, 8>& nodes);

/// The rules of one part: of its bricks, its wedges, its tetrahedra and whatever else has repeated corners. Tetrahedra
/// are always linear ones.
struct SolidRules {
  SolidRule brick = SolidRule::one_point, wedge = SolidRule::one_point, other = SolidRule::one_point,
            tetrahedron = SolidRule::one_point;
  [[nodiscard]] SolidRule of(SolidShape shape) const {
    if (shape == SolidShape::tetrahedron) return tetrahedron;
    return shape == SolidShape::brick ? brick : shape == SolidShape::wedge ? wedge : other;
  }
};

/// The rules for ELFORM of *SECTION_SOLID and ESORT of *CONTROL_SOLID (1 and 3 sort wedges of every part to ELFORM 15,
/// 2 and 4 those of parts with eight points; 11 to 14 as 1 to 4, and tetrahedra of every part but those of ELFORM 10 to
/// ELFORM 13). Unknown ELFORMs have one point.
[[nodiscard]] SolidRules solid_rules(std::int64_t elform, std::int64_t esort);

/// Tetrahedra that do not lock where volume is kept: 4, and 16 and 17 with ten nodes, are calculated as ELFORM 13.
[[nodiscard]] constexpr bool stands_in_nodal_pressure(std::int64_t elform) {
  return elform == 4 || elform == 16 || elform == 17;
}
/// Bricks that are calculated as ELFORM 2: 3, with rotations, and 18, with enhanced strains.
[[nodiscard]] constexpr bool stands_in_eight_points(std::int64_t elform) { return elform == 3 || elform == 18; }

/// False: one point.
[[nodiscard]] constexpr bool has_eight_points(SolidRule rule) {
  return rule != SolidRule::one_point && rule != SolidRule::nodal_pressure;
}

/// A corner's share of the mass: an eighth; of wedges a sixth, and half of that where two corners are one.
[[nodiscard]] std::array<double, 8> corner_shares(SolidRule rule, const std::array<NodeIndex, 8>& nodes);

}  // namespace gapcheck::solver
