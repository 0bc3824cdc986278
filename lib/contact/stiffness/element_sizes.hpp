#pragma once
#include <vector>

#include "model/model.hpp"

namespace gapcheck::contact {

/// Sizes of all elements, for masses, stiffness and time steps. Arrays parallel to those of Mesh.
struct ElementSizes {
  std::vector<double> shell_area, shell_thickness;
  std::vector<double> shell_length;  ///< characteristic length, ISDO of *CONTROL_TIMESTEP
  std::vector<double> solid_volume, thick_shell_volume;
};
[[nodiscard]] ElementSizes element_sizes(const model::Model& model);

/// Area of a shell as the solver's one-point elements measure it: half the cross product of the diagonals.
[[nodiscard]] double shell_area(const model::SegmentNodes& nodes, const std::vector<Vector>& x);

/// Volume of an 8-node element with bilinear faces, or of a collapsed form; positive whatever the numbering.
[[nodiscard]] double brick_volume(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& x);

/// Characteristic length of a shell. Triangles count double the area. ISDO = 1: A / longest diagonal; ISDO = 2: the
/// larger of A / longest side and, for quads, the shortest side; else: A / longest side.
[[nodiscard]] double shell_length(const model::SegmentNodes& nodes, double area, std::int64_t isdo,
                                  const std::vector<Vector>& x);

}  // namespace gapcheck::contact
