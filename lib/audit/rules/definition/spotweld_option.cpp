#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit::rule::spotweld_option {
namespace {

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
    if (contact.cparm8 == contact.mpp_cparm8 || !contact::classify(contact).edges) continue;
    const bool smp = contact.cparm8 != 0;
    found.push_back(
        finding_at(rule, context, contact,
                   fmt::format("CPARM8 = {} is on {}: {}; give it on both", smp ? contact.cparm8 : contact.mpp_cparm8,
                               smp ? "card E, and not on the MPP card" : "the MPP card, and not on card E",
                               smp ? "an MPP run may leave the spotweld beams out of the contact"
                                   : "an SMP run leaves the spotweld beams out of the contact")));
  }
  add_first(report, std::move(found), "more contacts give CPARM8 in one place only");
}

}  // namespace

const Rule definition{{"GC423", "spotweld-option", Severity::warning,
                       "CPARM8, which puts spotweld beams into a contact, is on one of its two cards only", Need::model,
                       "Spotweld beams are in the contact with one version of the solver and not with the other"},
                      run};

}  // namespace gapcheck::audit::rule::spotweld_option
