#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector.hpp"

namespace gapcheck {

/// What an element of a mesh is.
enum class MeshElement : std::uint8_t { shell, solid, thick_shell, beam, particle };

/// The elements of a deck and their nodes, for post-processors. Parallel arrays; everything is finite.
struct ElementMesh {
  std::vector<std::int64_t> node_ids;
  std::vector<Vector> x;               ///< beside node_ids
  std::vector<std::uint32_t> corners;  ///< positions of nodes, element after element
  std::vector<std::uint64_t> ends;     ///< where each element ends in `corners`
  std::vector<MeshElement> kinds;
  std::vector<std::int64_t> element_ids, part_ids;  ///< part 0: none
  std::vector<std::int64_t> contact_ids;            ///< of the first contact that has a segment of the element; 0: none
  std::vector<double> thickness;                    ///< contact thickness, the largest of all contacts; 0: none
  std::uint64_t left_out = 0;                       ///< elements with a node that has no finite coordinates

  [[nodiscard]] std::size_t size() const { return element_ids.size(); }
  [[nodiscard]] std::span<const std::uint32_t> corners_of(std::size_t element) const {
    const std::uint64_t first = element == 0 ? 0 : ends[element - 1];
    return {corners.data() + first, ends[element] - first};
  }
};

}  // namespace gapcheck
