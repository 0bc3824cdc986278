#pragma once
#include "audit/rule.hpp"

namespace gapcheck::audit {

/// Sets Finding::key and Finding::cause: a surface is empty because its set names members that are not defined, and
/// what is not defined may be in an include that was not found. Adds the finding that a deck is only a piece of one.
void link_causes(const Context& context, Report& report);

}  // namespace gapcheck::audit
