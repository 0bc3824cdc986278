#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/active_time.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit::rule::inactive_contact {
namespace {

/// A contact that ends within this fraction of the run is probably a slip in the exponent (1e-20 for 1e20).
constexpr double short_part = 1e-6;

std::string problem(const model::Contact& contact, double end_of_run) {
  const contact::ActiveTime time = contact::active_time(contact);
  if (time.by_curve) return {};
  if (time.end <= time.start)
    return fmt::format("BT = {:g} is not before DT = {:g}: the contact never acts; correct card 2", contact.birth,
                       contact.death);
  if (!(end_of_run > 0)) return {};
  if (time.start >= end_of_run)
    return fmt::format(
        "BT = {:g} is not before the end of the run ({:g}): the contact never acts; correct BT or ENDTIM",
        contact.birth, end_of_run);
  if (time.end <= short_part * end_of_run)
    return fmt::format("DT = {:g} ends the contact as good as at once (the run ends at {:g}); correct card 2",
                       contact.death, end_of_run);
  return {};
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
    // A transducer has no times of its own.
    if (contact::classify(contact).code == contact::ContactCode::transducer) continue;
    const std::string text = problem(contact, context.model().controls.endtim);
    if (!text.empty()) found.push_back(finding_at(rule, context, contact, text));
  }
  add_first(report, std::move(found), "more contacts never act");
}

}  // namespace

const Rule definition{{"GC414", "inactive-contact", Severity::warning,
                       "birth and death time leave a contact no time to act", Need::model, "The contact does nothing"},
                      run};

}  // namespace gapcheck::audit::rule::inactive_contact
