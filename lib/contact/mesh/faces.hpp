#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/entity/faces.hpp"
#include "model/model.hpp"

namespace gapcheck::contact {

using model::Face;
using model::is_tetrahedron;

/// The faces of an 8-node element or a collapsed form, turned outward with the coordinates given.
[[nodiscard]] std::vector<Face> faces_of(const std::array<NodeIndex, 8>& nodes, std::uint32_t element,
                                         const std::vector<Vector>& x);

/// Orders a face's corners so that its normal points away from the middle of its element.
void turn_outward(Face& face, const std::array<NodeIndex, 8>& element_nodes, const std::vector<Vector>& x);

/// Faces that belong to exactly one of the elements, turned outward. `chosen`: positions in `elements`.
[[nodiscard]] std::vector<Face> free_faces(const model::Elements<8>& elements, const std::vector<std::uint32_t>& chosen,
                                           const std::vector<Vector>& x);

/// Volume of an 8-node element or a collapsed form; positive whatever the numbering.
[[nodiscard]] double volume(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& x);

/// Area of a segment: two triangles around the diagonal from its first corner.
[[nodiscard]] double area(const model::SegmentNodes& nodes, const std::vector<Vector>& x);

}  // namespace gapcheck::contact
