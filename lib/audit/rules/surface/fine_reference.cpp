#include <fmt/format.h>

#include "audit/rules.hpp"
#include "contact/surface/surface_parts.hpp"

namespace gapcheck::audit::rule::fine_reference {
namespace {

/// A reference side finer than this is a mistake rather than a matter of meshing.
constexpr double factor = 1.5;

/// One-way penalty contact. In forming types fine rigid tools are common practice, and ties hold either way.
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
    const double tracked = contact::mean_edge(model, surfaces.a), reference = contact::mean_edge(model, surfaces.b);
    if (!(reference > 0) || !(tracked > factor * reference)) continue;
    report.findings.push_back(finding_at(
        rule, context, contact,
        fmt::format(
            "the reference side B is {:.3g} times finer than the tracked side A (mean edges {:.4g} and {:.4g}): its "
            "nodes pass between the tracked ones; exchange the sides, or take a two-way type",
            tracked / reference, reference, tracked)));
  }
}

}  // namespace

const Rule definition{{"GC417", "fine-reference", Severity::warning,
                       "the reference side of a one-way contact is finer than the tracked side", Need::surfaces},
                      run};

}  // namespace gapcheck::audit::rule::fine_reference
