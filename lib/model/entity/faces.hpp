#pragma once
#include <cstdint>
#include <vector>

#include "model/entity/mesh.hpp"
#include "model/entity/sets.hpp"

namespace gapcheck::model {

/// The faces of a solid or thick shell with eight nodes, normals outward for a regularly numbered element; for
/// degenerated ones (wedge, pyramid, tetrahedron) only faces with three or more different nodes, a triangle with its
/// last node repeated.
class SolidFaces {
 public:
  explicit SolidFaces(const std::array<NodeIndex, 8>& nodes);
  [[nodiscard]] const SegmentNodes* begin() const { return faces_.data(); }
  [[nodiscard]] const SegmentNodes* end() const { return faces_.data() + count_; }
  [[nodiscard]] std::size_t size() const { return count_; }

 private:
  std::array<SegmentNodes, 6> faces_{};
  std::size_t count_ = 0;
};

/// True if the element is a tetrahedron (n4 = … = n8).
[[nodiscard]] bool is_tetrahedron(const std::array<NodeIndex, 8>& nodes);

/// A face and the element it belongs to.
struct Face {
  SegmentNodes nodes;
  std::uint32_t element = 0;  ///< position in the element array
};

/// The faces that only one of the given elements has, in the order of the elements. `members`: positions in `elements`,
/// each once. Linear in the number of faces.
[[nodiscard]] std::vector<Face> exterior_faces(const Elements<8>& elements, const std::vector<std::uint32_t>& members);

}  // namespace gapcheck::model
