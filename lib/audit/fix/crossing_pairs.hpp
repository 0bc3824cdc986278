#pragma once
#include <cstdint>
#include <set>
#include <span>
#include <utility>

#include "model/model.hpp"

namespace gapcheck::audit {

/// An element by its kind and position in the array of its kind.
using ElementOfKind = std::pair<model::ElementKind, std::uint32_t>;
using ElementPair = std::pair<ElementOfKind, ElementOfKind>;

/// Pairs of elements that pass through each other in contacts that judge nodes, on the model's present coordinates.
/// Segments whose element is not known are left out.
[[nodiscard]] std::set<ElementPair> crossing_pairs(const model::Model& model);

/// The nodes of a shell, solid, thick shell or beam; none of any other kind.
[[nodiscard]] std::span<const NodeIndex> nodes_of(const model::Mesh& mesh, const ElementOfKind& element);

}  // namespace gapcheck::audit
