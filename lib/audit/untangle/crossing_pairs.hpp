#pragma once
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "model/model.hpp"

namespace gapcheck::audit {

/// An element by its kind and position in the array of its kind.
using ElementOfKind = std::pair<model::ElementKind, std::uint32_t>;
using ElementPair = std::pair<ElementOfKind, ElementOfKind>;

/// A pair that the contact should keep apart.
struct ContactCrossing {
  ContactIndex contact;  ///< the first that has it
  ElementPair elements;  ///< in order
};

/// Elements that pass through each other in contacts that keep surfaces apart, by contact and elements; segments whose
/// element is not known are left out. `surfaces`: of this model, on the coordinates that count.
[[nodiscard]] std::vector<ContactCrossing> contact_crossings(const model::Model& model, contact::SurfaceStore& surfaces,
                                                             const std::vector<Vector>& x);

/// Pairs of elements that pass through each other in contacts that keep surfaces apart, on the model's present
/// coordinates. Segments whose element is not known are left out.
[[nodiscard]] std::set<ElementPair> crossing_pairs(const model::Model& model);

/// The nodes of a shell, solid, thick shell or beam; none of any other kind.
[[nodiscard]] std::span<const NodeIndex> nodes_of(const model::Mesh& mesh, const ElementOfKind& element);

}  // namespace gapcheck::audit
