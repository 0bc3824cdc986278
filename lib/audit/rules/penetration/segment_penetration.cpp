#include "audit/rules.hpp"

namespace gapcheck::audit::rule::segment_penetration {

const Rule definition{
    {"GC107", "segment-penetration", Severity::warning,
     "a corner of a segment is nearer to another segment than the contact distance, in a contact with SOFT = 2"},
    [](const RuleInfo&, Context& context, Report&) { context.want(PenetrationKind::segment); }};

}  // namespace gapcheck::audit::rule::segment_penetration
