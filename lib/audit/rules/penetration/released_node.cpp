#include "audit/rules.hpp"

namespace gapcheck::audit::rule::released_node {

const Rule definition{
    {"GC102", "released-node", Severity::error,
     "a tracked node penetrates so deep that the solver drops it from the contact"},
    [](const RuleInfo&, Context& context, Report&) { context.want(PenetrationKind::released); }};

}  // namespace gapcheck::audit::rule::released_node
