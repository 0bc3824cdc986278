#include "audit/fix/thickness_trial.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "audit/fix/gaps.hpp"
#include "audit/shared/records_of.hpp"

namespace gapcheck::audit {
namespace {

constexpr int searches = 2;

bool between(const Penetration& p, std::int64_t a, std::int64_t b) {
  return std::minmax(p.part, p.element_part) == std::minmax(a, b);
}

/// Sets OPTT of two parts as long as it lives.
class WithOptt {
 public:
  WithOptt(model::Model& model, PartIndex a, PartIndex b, double value)
      : a_(model.parts[a.value]), b_(model.parts[b.value]), contact_a_(a_.contact), contact_b_(b_.contact) {
    for (model::Part* part : {&a_, &b_}) {
      if (!part->contact) part->contact.emplace();
      part->contact->optt = value;
    }
  }
  WithOptt(const WithOptt&) = delete;
  WithOptt& operator=(const WithOptt&) = delete;
  ~WithOptt() {
    a_.contact = contact_a_;
    b_.contact = contact_b_;
  }

 private:
  model::Part &a_, &b_;
  std::optional<model::PartContact> contact_a_, contact_b_;
};

}  // namespace

double share_of_thickness(const model::Model& model, const Penetration& p) {
  return (solid_part(model, p.part) ? 0 : 0.5) + (solid_part(model, p.element_part) ? 0 : 0.5);
}

double given_away(const model::Model& model, std::span<const Penetration> records, double thickness) {
  double largest = 0;
  for (const Penetration& p : records)
    largest = std::max(largest, 1 - share_of_thickness(model, p) * thickness / p.contact_distance);
  return largest;
}

std::vector<FreeCard> ThicknessTrial::cards(std::span<const ContactIndex> contacts,
                                            const contact::InitialState& state) {
  const FreeCardScene scene{
      model_, [&](ContactIndex contact) -> const contact::ContactSurfaces& { return present_.at(contact); },
      [&](std::vector<contact::ThicknessChange> changes, const std::vector<ContactIndex>& chosen) {
        return search(std::move(changes), chosen);
      }};
  return free_cards(scene, contacts, state);
}

contact::InitialState ThicknessTrial::search(std::vector<contact::ThicknessChange> changes,
                                             const std::vector<ContactIndex>& chosen) {
  contact::InitialOptions options;
  options.nodes_stay = true;
  for (const ContactIndex i : chosen) options.contacts.push_back(model_.contact(i).id.value);
  // Tied nodes are not reported against the parts they are tied to, so the ties must be made.
  for (const model::Contact& contact : model_.contacts)
    if (contact::classify(contact).family == contact::Family::tied) options.contacts.push_back(contact.id.value);
  contact::SurfaceStore surfaces(model_, std::move(changes));
  contact::InitialCounters counters;
  return contact::initialise_contacts(model_, surfaces, options, counters);
}

double ThicknessTrial::free_optt(ContactIndex contact, std::int64_t a, std::int64_t b,
                                 std::span<const Penetration> records, std::span<const Penetration> all) {
  const auto part_a = model_.part_of_id.find(a), part_b = model_.part_of_id.find(b);
  if (part_a == model_.part_of_id.end() || part_b == model_.part_of_id.end()) return 0;
  const auto limit = [&](std::span<const Penetration> some) {
    return free_thickness(some, [&](const Penetration& p) { return DistanceRule{share_of_thickness(model_, p), 0}; });
  };
  const auto others = [&](std::span<const Penetration> some) {
    return std::count_if(some.begin(), some.end(),
                         [&](const Penetration& p) { return listed_by_solver(p.kind) && !between(p, a, b); });
  };
  FreeThickness bound = limit(records);
  for (int i = 0; i < searches; ++i) {
    if (bound.stuck_count > 0 || !std::isfinite(bound.value)) return 0;
    const double thickness = rounded_down(bound.value);
    const WithOptt optt(model_, part_a->second, part_b->second, thickness);
    const contact::InitialState state = search({}, {contact});
    const auto found = records_of(state, contact);
    std::vector<Penetration> left;
    for (const Penetration& p : found)
      if (listed_by_solver(p.kind) && between(p, a, b)) left.push_back(p);
    if (left.empty()) return others(found) <= others(all) ? thickness : 0;
    bound = limit(left);
  }
  return 0;
}

/// The thickness that a part's section needs for a contact thickness; nothing if other settings decide too.
std::optional<double> ThicknessTrial::section_thickness(ContactIndex contact, PartIndex index, double thickness) const {
  const model::Part& part = model_.part(index);
  if (!part.section || part.composite_thickness > 0) return std::nullopt;
  const model::Section& section = model_.sections[*part.section];
  const double present = section.thickness[0];
  const auto same = [&](double t) { return t == present; };
  if (section.kind != model::SectionKind::shell || section.nloc != 0 ||
      !std::all_of(section.thickness.begin(), section.thickness.end(), same))
    return std::nullopt;
  for (const model::ShellThickness& own : model_.mesh.shells.own_thickness)
    if (model_.mesh.shells.part[own.shell] == index) return std::nullopt;
  const model::Contact& card = model_.contact(contact);
  const auto settings = contact::settings(card, contact::classify(card), model_.controls);
  const auto scale = [&](bool b) {
    return contact::scale_of(part.contact ? &*part.contact : nullptr,
                             contact::thickness_side(card, settings, model_.controls, b));
  };
  if (scale(false) != scale(true)) return std::nullopt;
  const double needed = rounded_down(thickness / scale(false));
  if (!(needed > 0) || needed > present) return std::nullopt;
  return needed;
}

std::optional<ThinnerSections> ThicknessTrial::sections(ContactIndex contact, std::int64_t a, std::int64_t b,
                                                        std::span<const Penetration> records, double thickness) const {
  const bool by_element = std::all_of(records.begin(), records.end(), [&](const Penetration& p) {
    const auto fits = [&](ThicknessRule rule, std::int64_t part) {
      return rule == ThicknessRule::element || (rule == ThicknessRule::none && solid_part(model_, part));
    };
    return fits(p.node_rule, p.part) && fits(p.segment_rule, p.element_part);
  });
  if (!by_element) return std::nullopt;
  ThinnerSections thinner;
  for (const std::int64_t id : {a, b}) {
    if (solid_part(model_, id)) continue;
    const auto part = model_.part_of_id.find(id);
    if (part == model_.part_of_id.end()) return std::nullopt;
    const auto needed = section_thickness(contact, part->second, thickness);
    if (!needed) return std::nullopt;
    const std::int64_t section = model_.part(part->second).section_id;
    const auto [entry, is_new] = thinner.thickness.emplace(section, *needed);
    entry->second = std::min(entry->second, *needed);
  }
  if (thinner.thickness.empty()) return std::nullopt;
  for (const model::Part& part : model_.parts)
    if (part.id.value != a && part.id.value != b && thinner.thickness.contains(part.section_id)) ++thinner.other_parts;
  return thinner;
}

}  // namespace gapcheck::audit
