#pragma once
#include <nlohmann/json_fwd.hpp>

#include "records/repair_plan.hpp"

namespace gapcheck::report {

/// The lines of a repair as a fix object of SARIF: whole lines are taken out and put in.
[[nodiscard]] nlohmann::ordered_json sarif_fix(const Repair& repair);

}  // namespace gapcheck::report
