#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace gapcheck::api {

/// What an element of a mesh is.
enum class ElementKind : std::uint8_t { shell, solid, thick_shell, beam, particle };

/// m elements of a deck and the n nodes that they have, as parallel arrays. Coordinates are those of the deck, all
/// finite; elements with other nodes are left out. Shells first, then solids, thick shells, beams and particles. The
/// views live as long as the report.
struct Mesh {
  [[nodiscard]] std::size_t size() const { return element.size(); }

  std::span<const std::int64_t> node;      ///< n ids
  std::span<const double> points;          ///< n × 3
  std::span<const std::uint32_t> corners;  ///< positions in `node`, element after element
  std::span<const std::uint64_t> ends;     ///< m: where each element ends in `corners`
  std::span<const ElementKind> kind;       ///< m: shells have 4 corners, solids and thick shells 8, beams 2, particles
                                           ///< 1; those with fewer nodes repeat the last one
  std::span<const std::int64_t> element;   ///< m ids
  std::span<const std::int64_t> part;      ///< m ids; 0: none
  std::span<const std::int64_t> contact;   ///< m ids: the first contact with a segment of the element; 0: none
  std::span<const double> thickness;       ///< m: the largest contact thickness of all contacts; 0: none
  std::uint64_t left_out = 0;              ///< elements with a node that has no finite coordinates
};

}  // namespace gapcheck::api
