#include <fmt/format.h>

#include "audit/rules.hpp"
#include "audit/shared/contact_thickness.hpp"

namespace gapcheck::audit::rule::thickness_ignored {
namespace {

/// Thickness of a deformable shell; 0 for other segments.
double shell_at(const model::Model& model, const contact::Segments& s, std::size_t i) {
  if (s.element_kind[i] != model::ElementKind::shell) return 0;
  const PartIndex part = part_of(model.mesh, s, i);
  return part == none<PartIndex> || model.rigid(part) ? 0 : contact::element_thickness(model, s.element[i]);
}

/// *CONTROL_CONTACT counts only if THKOPT allows it.
const char* advice(const model::Contact& contact) {
  if (contact.thkopt == 1) return "set SHLTHK = 1 on card B";
  if (contact.thkopt == 2) return "set THKOPT and SHLTHK = 1 on card B";
  return "set THKOPT and SHLTHK = 1 on card B or SHLTHK = 1 in *CONTROL_CONTACT";
}

std::string message(const model::Contact& contact, const Worst& shells) {
  const bool card = contact.sst != 0 || contact.mst != 0;
  const char* cause = contact.thkopt == 2                         ? "THKOPT = 2"
                      : contact.thkopt == 0 && contact.shlthk > 0 ? "SHLTHK of card B needs THKOPT = 1"
                                                                  : "SHLTHK = 0";
  return fmt::format(
      "{} ignores thickness ({}): {} shells, up to {:.4g} thick{}, meet at their mid-surfaces; {}, or use the "
      "AUTOMATIC type",
      contact.written, cause, shells.count, shells.weight, card ? ", and SST/MST" : "", advice(contact));
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  for (const ContactIndex c : contacts_with_thickness(rule, context)) {
    const model::Contact& contact = model.contact(c);
    const contact::ContactType type = contact::classify(contact);
    if (type.family != contact::Family::old || settings(contact, type, model.controls).shlthk != 0) continue;
    const contact::ContactSurfaces& surfaces = context.surfaces(c);
    Worst shells;
    for (const contact::ContactSide* side : {&surfaces.a, &surfaces.b}) {
      const contact::Segments& s = side->selection.segments;
      for (const Worst& w : worst_by_key(s.size(), [&](std::size_t i) { return Weighed{0, shell_at(model, s, i)}; })) {
        shells.count += w.count;
        shells.weight = std::max(shells.weight, w.weight);
      }
    }
    if (shells.count == 0) continue;
    Finding f = finding_at(rule, context, contact, message(contact, shells));
    f.count = shells.count;
    report.findings.push_back(std::move(f));
  }
}

}  // namespace

const Rule definition{
    {"GC305", "thickness-ignored", Severity::warning, "a contact of an old type ignores the thickness of its shells",
     Need::surfaces, "Contact happens at the mid-surface: the parts overlap by their thickness"},
    run};

}  // namespace gapcheck::audit::rule::thickness_ignored
