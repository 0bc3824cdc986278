#include "audit/rules.hpp"

namespace gapcheck::audit::rule::untied_node {

const Rule definition{{"GC201", "untied-node", Severity::warning, "a node of a tied contact stays untied"},
                       [](const RuleInfo&, Context& context, Report&) {
                         for (const TieReason reason :
                              {TieReason::too_far, TieReason::too_short, TieReason::not_found, TieReason::rigslav,
                               TieReason::rigmast, TieReason::conflict})
                           context.want(reason);
                       }};

}  // namespace gapcheck::audit::rule::untied_node
