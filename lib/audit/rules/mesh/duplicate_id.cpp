#include "audit/rules.hpp"

namespace gapcheck::audit::rule::duplicate_id {

const Rule definition{{"GC501", "duplicate-id", Severity::error, "an id is defined twice; the first definition is used",
                       Need::model, "One of the two definitions is lost"},
                      [](const RuleIdentity& rule, Context& context, Report& report) {
                        add_faults(rule, context, report, model::Fault::Kind::duplicate_id);
                      }};

}  // namespace gapcheck::audit::rule::duplicate_id
