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
  Finding f = finding_at(
      rule, context, *first,
      fmt::format("{} {} with IGNORE = 0 {} {} initial {}: the solver changes the geometry or starts with a force; "
                  "remove them, and set IGNORE = 1 or 2 on *CONTROL_CONTACT",
                  contacts, contacts == 1 ? "contact" : "contacts", contacts == 1 ? "has" : "have", nodes,
                  nodes == 1 ? "penetration" : "penetrations"));
  if (model.controls.contact_given) {
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
