#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/rules.hpp"
#include "audit/shared/contact_thickness.hpp"
#include "audit/shared/free_thickness.hpp"
#include "audit/shared/length_unit.hpp"
#include "audit/shared_results.hpp"

namespace gapcheck::audit::rule::penetration_free_at {
namespace {

std::string segment_words(const Penetration& p) {
  return p.element != 0 ? fmt::format("element {}", p.element) : fmt::format("segment {}", p.segment_number);
}

/// A thickness would help, but one that nobody can use.
std::string close_words(const FreeCard& card) {
  const Penetration& p = card.bound.closest;
  return fmt::format(
      "no useful SST makes it free: the closest of {} penetrating nodes, node {}, is {:.4g} from {}, of a contact "
      "distance of {:.4g}; move the nodes",
      card.penetrations, p.node, p.remaining(), segment_words(p), p.contact_distance);
}

std::string words(const Context& context, const LengthUnit& unit, const FreeCard& card) {
  const model::Contact& contact = context.model().contact(card.contact);
  const bool single = contact::classify(contact).treatment == contact::Treatment::single_surface;
  std::string text = fmt::format("free of penetrations with {}{} <= {:.4g}", card.optt ? "OPTT = 0 and " : "",
                                 single ? "SST" : "SST = MST", rounded_down(card.value));
  const Penetration& closest = card.bound.closest;
  if (card.bound.free_count > 0 && !far_enough(closest)) return close_words(card);
  if (card.bound.free_count > 0)
    text += fmt::format("; the closest is node {}, {:.4g} from {}", closest.node, closest.remaining(),
                        segment_words(closest));
  const double recommended = recommended_millimetres * unit.millimetre;
  if (card.value < recommended)
    text += fmt::format("; below the {:.4g} ({} mm{}) at which a deck should be free", recommended,
                        recommended_millimetres, unit.clause());
  return text;
}

std::string stuck_words(const FreeCard& card) {
  const Penetration& p = card.bound.stuck;
  return fmt::format(
      "no SST makes it free: {} of {} penetrating nodes lie on the segment itself or behind it, node {} {:.4g} "
      "behind {}; move them",
      card.bound.stuck_count, card.penetrations, p.node, std::max(0.0, -p.remaining()), segment_words(p));
}

std::string coated_words(const Context& context, const FreeCard& card) {
  const double coating = std::abs(context.model().contact(card.contact).sldthk);
  const Penetration& p = card.bound.coated;
  return fmt::format(
      "no SST makes it free: the coating SLDTHK = {:g} of solids alone makes {} of {} nodes penetrate; with SLDTHK <= "
      "{:.4g} it would not (node {}, {:.4g} from {})",
      coating, card.bound.coated_count, card.penetrations, rounded_down(coating * card.bound.coat_factor), p.node,
      p.remaining(), segment_words(p));
}

/// The record that the words are about.
const Penetration& shown(const FreeThickness& b) {
  return b.stuck_count > 0 ? b.stuck : b.coated_count > 0 ? b.coated : b.closest;
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const FreeCardScene scene{
      context.model(),
      [&](ContactIndex contact) -> const contact::ContactSurfaces& { return context.surfaces(contact); },
      [&](std::vector<contact::ThicknessChange> changes, const std::vector<ContactIndex>& chosen) {
        contact::SurfaceStore surfaces(context.model(), std::move(changes));
        contact::InitialState state = context.results().initial_if(surfaces, chosen);
        context.results().count_other(surfaces);
        return state;
      }};
  const std::vector<ContactIndex> contacts = contacts_with_thickness(rule, context);
  if (contacts.empty()) return;
  const LengthUnit unit = length_unit(context);
  for (const FreeCard& card : free_cards(scene, contacts, context.results().initial())) {
    const FreeThickness& b = card.bound;
    Finding f = finding_at(rule, context, context.model().contact(card.contact),
                           b.stuck_count > 0    ? stuck_words(card)
                           : b.coated_count > 0 ? coated_words(context, card)
                                                : words(context, unit, card));
    f.count = card.penetrations;
    if (b.count() > 0) {
      const Penetration& p = shown(b);
      f.node = p.node;
      f.part = p.part;
      f.element = p.element;
      f.element_part = p.element_part;
      f.point = p.original;
    }
    report.findings.push_back(std::move(f));
  }
}

}  // namespace

const Rule definition{
    {"GC308", "penetration-free-at", Severity::note, "the largest SST with which a contact has no initial penetrations",
     Need::surfaces | Need::node_penetrations, "A smaller contact thickness would start free of penetrations"},
    run};

}  // namespace gapcheck::audit::rule::penetration_free_at
