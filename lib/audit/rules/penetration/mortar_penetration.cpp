#include "audit/rules.hpp"

namespace gapcheck::audit::rule::mortar_penetration {

const Rule definition{
    {"GC108", "mortar-penetration", Severity::warning,
     "a corner of a segment is nearer to another segment than the contact distance, in a mortar contact"},
    [](const RuleInfo&, Context& context, Report&) { context.want(PenetrationKind::mortar); }};

}  // namespace gapcheck::audit::rule::mortar_penetration
