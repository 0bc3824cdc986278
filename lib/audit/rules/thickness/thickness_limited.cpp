#include <fmt/format.h>

#include <array>

#include "audit/rules.hpp"
#include "audit/shared/contact_thickness.hpp"

namespace gapcheck::audit::rule::thickness_limited {
namespace {

constexpr std::array thresholds{
    Threshold{"share", 0.8, 0, 1, "share of its thickness that an element counts, up to which it is listed"}};
constexpr double rounding = 1e-9;

/// The thickness that a shell segment would have without the limit.
double unlimited(const model::Model& model, const contact::ThicknessSide& side, const contact::Segments& s,
                 std::size_t i) {
  const PartIndex index = part_of(model.mesh, s, i);
  if (index == none<PartIndex>) return 0;
  const model::Part& part = model.part(index);
  return contact::shell_thickness(contact::element_thickness(model, s.element[i]), 0,
                                  part.contact ? &*part.contact : nullptr, model.rigid(index), side)
      .value;
}

contact::ThicknessSide side_without_limit(const model::Model& model, const model::Contact& contact,
                                          const contact::ContactSettings& settings) {
  contact::ThicknessSide side = contact::thickness_side(contact, settings, model.controls, false);
  side.edge_limit = false;
  return side;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  const double share = context.threshold(rule, thresholds[0]);
  std::vector<PartSegments> parts;
  for (const ContactIndex c : contacts_with_thickness(rule, context)) {
    const contact::ContactSurfaces& surfaces = context.surfaces(c);
    if (!surfaces.settings.thickness_limit) continue;
    const contact::Segments& s = surfaces.a.selection.segments;
    const auto side = side_without_limit(model, model.contact(c), surfaces.settings);
    weigh_by_part(parts, context, c, s, [&](std::size_t i) {
      if (s.rule[i] != ThicknessRule::edge_limit) return 0.0;
      const double counted = 2 * s.half[i], own = unlimited(model, side, s, i);
      return counted <= share * own * (1 + rounding) ? own / counted : 0.0;
    });
  }
  const auto words = [&](const PartSegments& p) {
    const contact::Segments& s = *p.segments;
    const std::uint32_t worst = p.worst.item;
    const auto side = side_without_limit(model, model.contact(p.contact), context.surfaces(p.contact).settings);
    return fmt::format(
        "{}: {} count only 0.4 of their shortest edge as thickness, {} the least: {:.4g} of {:.4g}; refine less, or "
        "set SSTHK = 1 in *CONTROL_CONTACT",
        part_name(model, p.part()), count_elements(p.worst.count), element_name(model.mesh, s, worst),
        2 * s.half[worst], unlimited(model, side, s, worst));
  };
  add_by_part(rule, context, report, parts, words, "parts that count less than their thickness");
}

}  // namespace

const Rule definition{.identity = {"GC302", "thickness-limited", Severity::note,
                                   "a contact counts 0.4 of an element's edge instead of its thickness", Need::surfaces,
                                   "Contact happens later than the shell's thickness says"},
                      .run = run,
                      .thresholds = thresholds};

}  // namespace gapcheck::audit::rule::thickness_limited
