#include "audit/rules.hpp"

namespace gapcheck::audit {

const Rule duplicate_id{{"GC501", "duplicate-id", Severity::error, "an id is defined twice; the first definition is used"},
                        [](const RuleInfo& rule, Context& context, Report& report) {
                          add_faults(rule, context, report, model::Fault::Kind::duplicate_id);
                        }};

}  // namespace gapcheck::audit
