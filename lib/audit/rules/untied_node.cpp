#include "audit/rules.hpp"

namespace gapcheck::audit {

const Rule untied_node{{"GC201", "untied-node", Severity::warning, "a node of a tied contact stays untied"},
                       [](const RuleInfo&, Context& context, Report&) { context.want_untied(); }};

}  // namespace gapcheck::audit
