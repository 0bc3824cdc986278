#include "audit/rules.hpp"

namespace gapcheck::audit::rule::tie_moved {

const Rule definition{{"GC204", "tie-moved", Severity::note, "tying moves a node visibly, without stress"},
                     [](const RuleInfo&, Context& context, Report&) { context.want(TieReason::sep); }};

}  // namespace gapcheck::audit::rule::tie_moved
