#include "audit/rules.hpp"

namespace gapcheck::audit {

const Rule edge_zone_penetration{
    {"GC106", "edge-zone-penetration", Severity::note,
     "a node is within the contact distance of an edge or corner, but outside every segment's band"},
    [](const RuleInfo&, Context& context, Report&) { context.want(PenetrationKind::edge_zone); }};

}  // namespace gapcheck::audit
