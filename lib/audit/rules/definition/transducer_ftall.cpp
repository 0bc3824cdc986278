#include <fmt/format.h>

#include <algorithm>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/contact_type.hpp"
#include "contact/surface/contact_surfaces.hpp"
#include "contact/tie/transducers.hpp"

namespace gapcheck::audit::rule::transducer_ftall {
namespace {

/// Only automatic contacts say which of their forces act between two surfaces.
bool has_automatic_contact(const model::Model& model) {
  return std::any_of(model.contacts.begin(), model.contacts.end(), contact::tells_surfaces);
}

/// Transducers whose second surface has no effect; keeps the others of `transducers`.
void check_second_surfaces(const RuleIdentity& rule, Context& context, std::vector<ContactIndex>& transducers,
                           std::vector<Finding>& found) {
  const bool automatic = has_automatic_contact(context.model());
  std::erase_if(transducers, [&](ContactIndex i) {
    const model::Contact& contact = context.model().contact(i);
    const bool constraint = !contact::measures_between(contact);
    if (automatic && !constraint) return false;
    found.push_back(finding_at(
        rule, context, contact,
        fmt::format(
            "SURFB of *{} is ignored: a second surface needs {}; remove SURFB, or measure with _PENALTY between "
            "surfaces of an AUTOMATIC contact",
            contact.written,
            constraint ? model::two_sided_transducer : "an AUTOMATIC contact, and the deck has none")));
    return true;
  });
}

void check_overlaps(const RuleIdentity& rule, Context& context, const std::vector<ContactIndex>& transducers,
                    std::vector<Finding>& found) {
  if (transducers.size() < 2 || context.model().controls.ftall == 1) return;
  std::vector<contact::Transducer> sides;
  for (std::size_t i = 0; i < std::min(transducers.size(), contact::max_transducers); ++i) {
    const contact::ContactSurfaces& surfaces = context.surfaces(transducers[i]);
    sides.push_back({&surfaces.a.selection, &surfaces.b.selection});
  }
  if (sides.size() < transducers.size())
    context.skipped(rule,
                    fmt::format("{} of {} force transducers", transducers.size() - sides.size(), transducers.size()));
  const auto earlier = contact::overlapping_transducers(context.model().mesh, sides);
  for (std::size_t i = 0; i < earlier.size(); ++i) {
    if (!earlier[i]) continue;
    const model::Contact& contact = context.model().contact(transducers[i]);
    const model::Contact& first = context.model().contact(transducers[*earlier[i]]);
    found.push_back(finding_at(
        rule, context, contact,
        fmt::format(
            "transducer {} measures forces that transducer {} measures too, and each goes to the first one only; "
            "set FTALL = 1 on card 6 of *CONTROL_CONTACT",
            contact.id.value, first.id.value)));
  }
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  std::vector<ContactIndex> transducers = context.read_contacts();
  std::erase_if(transducers, [&](ContactIndex i) {
    const model::Contact& contact = context.model().contact(i);
    return contact::classify(contact).code != contact::ContactCode::transducer || !contact::has_second_surface(contact);
  });
  std::vector<Finding> found;
  check_second_surfaces(rule, context, transducers, found);
  check_overlaps(rule, context, transducers, found);
  add_first(report, std::move(found), "more force transducers do not measure what they seem to");
}

}  // namespace

const Rule definition{
    {"GC413", "transducer-ftall", Severity::warning, "a force transducer does not get all the forces that it should",
     Need::surfaces, "The forces in rcforc are too small"},
    run};

}  // namespace gapcheck::audit::rule::transducer_ftall
