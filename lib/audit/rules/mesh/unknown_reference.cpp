#include "audit/rules.hpp"

namespace gapcheck::audit::rule::unknown_reference {

const Rule definition{{"GC502", "unknown-reference", Severity::error, "something refers to an id that does not exist",
                       Need::model, "The solver stops, or leaves out what refers to it"},
                      [](const RuleIdentity& rule, Context& context, Report& report) {
                        add_faults(rule, context, report, model::Fault::Kind::unknown_reference);
                      }};

}  // namespace gapcheck::audit::rule::unknown_reference
