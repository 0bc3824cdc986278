#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::contact {

/// A face of a solid or thick shell, corners counter-clockwise seen from outside; a triangle repeats its last node.
struct Face {
  model::SegmentNodes nodes;
  std::uint32_t element = 0;  ///< position in the element array it was made from
};

/// The 4 to 6 faces of an 8-node element with its collapsed forms (wedge, pyramid, tetrahedron), turned outward with the
/// coordinates given. Faces without area in their node list are left out.
[[nodiscard]] std::vector<Face> faces_of(const std::array<NodeIndex, 8>& nodes, std::uint32_t element,
                                         const std::vector<Vector>& x);

/// Orders a face's corners so that its normal points away from the middle of its element.
void turn_outward(Face& face, const std::array<NodeIndex, 8>& element_nodes, const std::vector<Vector>& x);

/// Faces that belong to exactly one of the elements. `chosen`: positions in `elements`.
[[nodiscard]] std::vector<Face> free_faces(const model::Elements<8>& elements, std::span<const std::uint32_t> chosen,
                                           const std::vector<Vector>& x);

/// Volume of an 8-node element or a collapsed form; positive whatever the numbering.
[[nodiscard]] double volume(const std::array<NodeIndex, 8>& nodes, const std::vector<Vector>& x);

/// True if the element is a tetrahedron (n4 = … = n8).
[[nodiscard]] bool is_tetrahedron(const std::array<NodeIndex, 8>& nodes);

/// Area of a segment: two triangles around the diagonal from its first corner.
[[nodiscard]] double area(const model::SegmentNodes& nodes, const std::vector<Vector>& x);

}  // namespace gapcheck::contact
