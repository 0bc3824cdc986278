#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit::rule::surplus_surface {
namespace {

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
    if (contact.b.id == 0 || contact::classify(contact).treatment != contact::Treatment::single_surface) continue;
    found.push_back(finding_at(rule, context, contact,
                               fmt::format("*{} has one surface, and SURFB = {} is ignored; put everything into SURFA, "
                                           "or take a SURFACE_TO_SURFACE type",
                                           contact.written, contact.b.id)));
  }
  add_first(report, std::move(found), "more single-surface contacts name a SURFB");
}

}  // namespace

const Rule definition{{"GC404", "surplus-surface", Severity::warning, "a single-surface contact names a second surface",
                       Need::model, "The second surface is ignored"},
                      run};

}  // namespace gapcheck::audit::rule::surplus_surface
