#include <fmt/format.h>

#include "audit/rules.hpp"
#include "contact/definition/contact_type.hpp"
#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::audit::rule::empty_surface {
namespace {

void check_side(const RuleIdentity& rule, Context& context, Report& report, const model::Contact& contact, char side,
                const contact::Selection& selection) {
  if (selection.empty_reason.empty() || selection.unknown_id || selection.later) return;
  report.findings.push_back(
      finding_at(rule, context, contact,
                 fmt::format("surface {} of *{} is empty: {}", side, contact.written, selection.empty_reason)));
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  for (const ContactIndex i : context.read_contacts()) {
    const model::Contact& contact = context.model().contact(i);
    // Transducers, draw beads and edges may have a second surface.
    const bool reference = contact::classify(contact).treatment != contact::Treatment::none || contact.b.id != 0;
    const contact::ContactSurfaces& surfaces = context.surfaces(i);
    check_side(rule, context, report, contact, 'A', surfaces.a.selection);
    if (reference) check_side(rule, context, report, contact, 'B', surfaces.b.selection);
  }
}

}  // namespace

const Rule definition{
    {"GC503", "empty-surface", Severity::error, "a side of a contact names nothing that could be in contact",
     Need::surfaces, "The contact does nothing, or the solver stops"},
    run};

}  // namespace gapcheck::audit::rule::empty_surface
