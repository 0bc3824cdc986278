#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "model/model.hpp"
#include "records/element_mesh.hpp"

namespace gapcheck::audit {

/// All shells, solids, thick shells, beams and particles of the model, in this order, and the nodes that they have.
/// Those with a node whose coordinates are not finite are left out and counted. `contacts` say which contact and
/// thickness an element has, as far as their cards were read; their surfaces are built where they are not there yet.
/// Linear in the sizes of mesh and surfaces.
[[nodiscard]] ElementMesh element_mesh(const model::Model& model, contact::SurfaceStore& surfaces,
                                       std::span<const ContactIndex> contacts);

/// Largest id of all sets, of whatever kind; 0: none.
[[nodiscard]] std::int64_t highest_set(const model::Sets& sets);

}  // namespace gapcheck::audit
