#include "audit/rules.hpp"

namespace gapcheck::audit {

const Rule tie_moved{{"GC204", "tie-moved", Severity::note, "tying moves a node visibly, without stress"},
                     [](const RuleInfo&, Context& context, Report&) { context.want(TieReason::sep); }};

}  // namespace gapcheck::audit
