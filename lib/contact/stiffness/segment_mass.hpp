#pragma once
#include <vector>

#include "contact/stiffness/element_sizes.hpp"
#include "contact/surface/surface.hpp"

namespace gapcheck::contact {

/// Mass of a segment in the stiffness of SOFT = 2: that of its shell or beam, half that of its solid; of a segment
/// whose element is not known, or has no mass, a quarter of the mass of its nodes for each corner. `node_mass`: by
/// node. Source: contact rules, section 6.4; the last case is our own choice.
[[nodiscard]] double segment_mass(const model::Model& model, const ElementSizes& sizes,
                                  const std::vector<double>& node_mass, const Segments& segments, std::size_t segment);

}  // namespace gapcheck::contact
