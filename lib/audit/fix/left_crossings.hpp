#pragma once
#include <functional>
#include <vector>

#include "model/model.hpp"
#include "records/fix.hpp"

namespace gapcheck::audit {

/// Crossings at the model's present coordinates, contour by contour, each with the reason why it is still there.
/// `reason`: why a node could not move; `none` if it could.
[[nodiscard]] std::vector<LeftCrossing> left_crossings(const model::Model& model,
                                                       const std::function<HoldReason(NodeIndex)>& reason);

/// Bodies of solids that lie wholly inside another part that a contact keeps apart (GC105), at the model's present
/// coordinates.
[[nodiscard]] std::vector<EnclosedSolids> enclosed_solids(const model::Model& model);

}  // namespace gapcheck::audit
