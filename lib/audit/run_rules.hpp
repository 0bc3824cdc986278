#pragma once
#include "audit/rule.hpp"

namespace gapcheck::audit {

/// Runs the selected rules in order of their ids.
void run_rules(Context& context, Report& report);

}  // namespace gapcheck::audit
