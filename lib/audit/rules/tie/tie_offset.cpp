#include "audit/rules.hpp"

namespace gapcheck::audit::rule::tie_offset {

const Rule definition{
    {"GC202", "tie-offset", Severity::warning, "a tied node keeps a distance whose moments the tie does not carry"},
    [](const RuleInfo&, Context& context, Report&) { context.want(TieReason::offset); }};

}  // namespace gapcheck::audit::rule::tie_offset
