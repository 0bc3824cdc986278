#pragma once
#include <string>

#include "base/result.hpp"
#include "keyword/deck.hpp"
#include "records/repair_plan.hpp"
#include "records/report.hpp"

namespace gapcheck::app {

/// Whether repairs may help against one of the findings.
[[nodiscard]] bool repairable(const Report& report);

/// The repairs of a deck that change cards, each tried; lines that are added end as those of their file. Errors: as
/// `gapcheck fix --plan`.
[[nodiscard]] Result<RepairPlan> plan_of_cards(const std::string& deck, const keyword::ReadOptions& read);

}  // namespace gapcheck::app
