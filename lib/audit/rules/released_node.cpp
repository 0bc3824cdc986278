#include "audit/rules.hpp"

namespace gapcheck::audit {

const Rule released_node{
    {"GC102", "released-node", Severity::error,
     "a tracked node penetrates so deep that the solver drops it from the contact"},
    [](const RuleInfo&, Context& context, Report&) { context.want(PenetrationKind::released); }};

}  // namespace gapcheck::audit
