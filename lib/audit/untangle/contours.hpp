#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "audit/untangle/crossing_pairs.hpp"

namespace gapcheck::audit {

/// The line along which one surface passes through another: crossing pairs of elements that are neighbours on both.
struct Contour {
  std::array<std::vector<ElementOfKind>, 2> elements;  ///< of the two surfaces; ascending, each once
  std::size_t pairs = 0;
};

/// Groups crossing pairs by the contour that they belong to, in the order of their first pairs. Two pairs are on the
/// same contour if their elements touch (are equal or share a node) on both surfaces. Within a contour, pairs are
/// turned so that all first elements are on one surface; a sheet that crosses itself next to a fold may have an element
/// on both. `pairs`: of this mesh.
[[nodiscard]] std::vector<Contour> find_contours(const model::Mesh& mesh, std::span<const ElementPair> pairs);

}  // namespace gapcheck::audit
