#pragma once
#include <map>
#include <vector>

#include "contact/surface/contact_surfaces.hpp"
#include "model/model.hpp"
#include "records/start.hpp"

namespace gapcheck::solver {

/// Pairs of elements that cross each other at the start and not in the deck, by contact::find_crossings(), in contacts
/// that judge nodes. `start`: coordinates by node; `mover`: by moved node, id of the contact that moved it last.
/// `surfaces`: of this model.
[[nodiscard]] std::vector<StartCrossing> created_crossings(const model::Model& model, contact::SurfaceStore& surfaces,
                                                           const std::vector<Vector>& start,
                                                           const std::map<NodeIndex, std::int64_t>& mover);

}  // namespace gapcheck::solver
