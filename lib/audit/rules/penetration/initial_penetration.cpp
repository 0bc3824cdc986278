#include "audit/rules.hpp"

namespace gapcheck::audit::rule::initial_penetration {

// Severity warning: the solver copes, but the model is not the one that was meant.
const Rule definition{
    {"GC101", "initial-penetration", Severity::warning,
     "a tracked node is nearer to a segment than the contact distance when the solver starts"},
    [](const RuleInfo&, Context& context, Report&) { context.want(PenetrationKind::initial); }};

}  // namespace gapcheck::audit::rule::initial_penetration
