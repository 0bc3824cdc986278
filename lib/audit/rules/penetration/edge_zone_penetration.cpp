#include "audit/rules.hpp"

namespace gapcheck::audit::rule::edge_zone_penetration {

const Rule definition{
    {"GC106", "edge-zone-penetration", Severity::note,
     "a node is within the contact distance of an edge or corner, but outside every segment's band"},
    [](const RuleInfo&, Context& context, Report&) { context.want(PenetrationKind::edge_zone); }};

}  // namespace gapcheck::audit::rule::edge_zone_penetration
