#include <fmt/format.h>

#include "audit/rules.hpp"
#include "audit/shared/side_sizes.hpp"
#include "contact/surface/surface_parts.hpp"

namespace gapcheck::audit::rule::fine_reference {
namespace {

/// One-way penalty contact. In forming types fine rigid tools are common practice; ties have a rule of their own.
bool one_way(const contact::ContactType& type) {
  using contact::Family;
  return type.treatment == contact::Treatment::one_way &&
         (type.family == Family::old || type.family == Family::automatic);
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  for (const ContactIndex i : context.contacts()) {
    const model::Contact& contact = model.contact(i);
    if (!contact.known || contact.own_layout) continue;
    const contact::ContactType type = contact::classify(contact);
    if (!one_way(type) || !type.checked()) continue;
    const contact::ContactSurfaces& surfaces = context.surfaces(i);
    const SideSizes sizes{contact::mean_edge(model, surfaces.a), contact::mean_edge(model, surfaces.b)};
    if (!sizes.reference_too_fine()) continue;
    report.findings.push_back(finding_at(
        rule, context, contact,
        fmt::format("{}: its nodes pass between the tracked ones; exchange the sides, or take a two-way type",
                    sizes.text())));
  }
}

}  // namespace

const Rule definition{{"GC417", "fine-reference", Severity::warning,
                       "the reference side of a one-way contact is finer than the tracked side", Need::surfaces,
                       "Fine reference nodes pass through the coarse tracked side"},
                      run};

}  // namespace gapcheck::audit::rule::fine_reference
