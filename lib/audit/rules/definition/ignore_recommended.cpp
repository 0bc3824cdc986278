#include <fmt/format.h>

#include "audit/rules.hpp"
#include "audit/shared_results.hpp"
#include "contact/definition/contact_type.hpp"

namespace gapcheck::audit::rule::ignore_recommended {
namespace {

/// Mortar types read IGNORE too, but keep their penetrations with any value.
bool can_ignore(const contact::ContactType& type) {
  return contact::knows_ignore(type) && type.family != contact::Family::mortar;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  const std::vector<ContactSummary>& summaries = context.results().initial().contacts;
  std::uint64_t contacts = 0, nodes = 0;
  const model::Contact* first = nullptr;
  for (const ContactIndex i : context.read_contacts()) {
    const contact::ContactType type = contact::classify(model.contact(i));
    if (!can_ignore(type) || summaries[i.value].penetrations == 0) continue;
    if (contact::settings(model.contact(i), type, model.controls).ignore != 0) continue;
    if (first == nullptr) first = &model.contact(i);
    ++contacts;
    nodes += summaries[i.value].penetrations;
  }
  if (first == nullptr) return;
  // On the card of all contacts they are counted; at the one contact's own keyword its number goes without saying.
  const bool at_card = model.controls.contact_given;
  const std::string with = fmt::format("{} initial {}", nodes, nodes == 1 ? "penetration" : "penetrations");
  const std::string which = contacts == 1 && !at_card ? "IGNORE = 0 and " + with
                                                      : fmt::format("{} {} with IGNORE = 0 {} {}", contacts,
                                                                    contacts == 1 ? "contact" : "contacts",
                                                                    contacts == 1 ? "has" : "have", with);
  Finding f = finding_at(rule, context, *first,
                         which +
                             ": the solver changes the geometry or starts with a force; remove them, and set "
                             "IGNORE = 1 or 2 on *CONTROL_CONTACT");
  if (contacts > 1) f.contact = 0;
  if (at_card) {
    f.file = context.path(model.controls.contact_place.file);
    f.line = model.controls.contact_place.line;
    f.contact = 0;
  }
  report.findings.push_back(std::move(f));
}

}  // namespace

const Rule definition{
    {"GC421", "ignore-recommended", Severity::note, "initial penetrations in contacts with IGNORE = 0",
     Need::node_penetrations, "The start geometry or the start forces are not those of the deck"},
    run};

}  // namespace gapcheck::audit::rule::ignore_recommended
