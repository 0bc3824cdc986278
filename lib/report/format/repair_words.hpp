#pragma once
#include <string>

#include "records/repair_plan.hpp"

namespace gapcheck::report {

/// "SST = 0.7 in contact 1 (18 nodes stay without force)", or why the repair cannot be written.
[[nodiscard]] std::string what_it_does(const Repair& repair);

}  // namespace gapcheck::report
