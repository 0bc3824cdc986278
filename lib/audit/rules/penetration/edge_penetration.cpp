#include "audit/rules.hpp"

namespace gapcheck::audit::rule::edge_penetration {

const Rule definition{
    {"GC109", "edge-penetration", Severity::warning,
     "two edges or beams are nearer to each other than the contact distance, in a contact of type 26"},
    [](const RuleInfo&, Context& context, Report&) { context.want(PenetrationKind::edge); }};

}  // namespace gapcheck::audit::rule::edge_penetration
