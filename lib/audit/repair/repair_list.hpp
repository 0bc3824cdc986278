#pragma once
#include <vector>

#include "contact/initial.hpp"
#include "model/model.hpp"
#include "records/repair_plan.hpp"

namespace gapcheck::audit {

/// The repairs of each pair of parts with penetrations, not yet tried, by contact and parts, kinds in the order of
/// RepairKind; behind them the tied contacts with nodes too far away to tie. `state`: of the deck, with nodes not
/// moved. Changes the model's thicknesses on the way and restores them.
[[nodiscard]] std::vector<RepairPair> list_repairs(model::Model& model, const contact::InitialState& state);

}  // namespace gapcheck::audit
