#include "contact/definition/same_surface.hpp"

#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit::rule::same_surface {
namespace {

void run(const RuleIdentity& rule, Context& context, Report& report) {
  using contact::Treatment;
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
    const contact::ContactType type = contact::classify(contact);
    if (type.treatment != Treatment::one_way && type.treatment != Treatment::two_way) continue;
    if (!contact::same_surface(context.model(), contact.a, contact.b)) continue;
    const bool tied = type.family == contact::Family::tied;
    found.push_back(
        finding_at(rule, context, contact,
                   fmt::format("SURFA and SURFB of *{} are the same; {}", contact.written,
                               tied ? "nothing can be tied to itself: name the two sides of the joint"
                                    : "take a SINGLE_SURFACE type for self-contact, or name two different surfaces")));
  }
  add_first(report, std::move(found), "more contacts have the same surface on both sides");
}

}  // namespace

const Rule definition{{"GC405", "same-surface", Severity::warning, "both sides of a two-surface contact are the same",
                       Need::model, "Each pair is treated twice, or the contact does nothing"},
                      run};

}  // namespace gapcheck::audit::rule::same_surface
