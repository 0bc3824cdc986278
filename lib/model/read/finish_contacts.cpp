#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/read/context.hpp"

namespace gapcheck::model {
namespace {

/// Reports ids that two contacts share, and numbers contacts without an id as the solver does.
void number_contacts(Context& context) {
  std::vector<Contact>& contacts = context.model.contacts;
  std::map<std::int64_t, const Contact*> taken;
  std::int64_t highest = 0;
  for (const Contact& contact : contacts) {
    const std::int64_t id = contact.id.value;
    if (id <= 0) continue;
    const auto [entry, is_new] = taken.try_emplace(id, &contact);
    if (!is_new) context.duplicate("contact", id, entry->second->place, contact.place);
    highest = std::max(highest, id);
  }
  highest = std::max(highest, static_cast<std::int64_t>(contacts.size()));
  for (Contact& contact : contacts) {
    if (contact.id.value > 0 || contact.order == 0) continue;
    contact.default_id = true;
    contact.id = ContactId(contact.order);
    if (taken.contains(contact.order)) {
      contact.id = ContactId(++highest);
      context.warning(contact.place, fmt::format("the default id {} of this contact is taken by another one; it is "
                                                 "called {}; give it an id of its own with *{}_ID",
                                                 contact.order, highest, contact.written));
    }
  }
}

/// The missing reference of a side, in words; empty if it exists or there is none.
std::string missing_reference(const Model& model, const SurfaceInput& side) {
  const auto say = [&](std::string_view what, bool there) {
    return there ? std::string() : fmt::format("{} {}", what, side.id);
  };
  switch (static_cast<SurfaceType>(side.type)) {
    case SurfaceType::segment_set:
      return say("segment set", model.sets.segments.contains(side.id));
    case SurfaceType::shell_set:
      return say("shell set", model.sets.shells.contains(side.id));
    case SurfaceType::part_set:
    case SurfaceType::exempted_part_set:
      return say("part set", model.sets.parts.contains(side.id));
    case SurfaceType::part:
      return say("part", model.part_of_id.contains(side.id));
    case SurfaceType::node_set:
      return say("node set", model.sets.nodes.contains(side.id));
    case SurfaceType::branch:
      return say("branch", model.sets.branches.contains(side.id));
    case SurfaceType::all:
      return {};
  }
  return {};
}

void check_side(Context& context, const Contact& contact, const SurfaceInput& side, std::string_view name) {
  if (side.type < 0 || side.type > static_cast<std::int64_t>(SurfaceType::branch)) {
    context.warning(contact.place,
                    fmt::format("contact {}: {} is not a type of surface for {} (0 to 7); the side is taken as empty",
                                contact.id.value, side.type, name));
    return;
  }
  if (side.id != 0)
    if (const std::string missing = missing_reference(context.model, side); !missing.empty())
      context.unknown(fmt::format("contact {}: {} of {} is not defined", contact.id.value, missing, name),
                      contact.place);
  // A negative number means a contact volume, not a box.
  if (side.box > 0 && !context.model.boxes.contains(side.box))
    context.unknown(fmt::format("contact {}: box {} of {} is not defined", contact.id.value, side.box, name),
                    contact.place);
}

/// Airbags: the thickness that LCIDAB gives at the start.
void resolve_thickness_curve(Context& context, Contact& contact) {
  if (contact.lcidab <= 0 || !contact.kind->can(Ability::thickness_curve) || contact.options.mortar) return;
  const auto curve = context.model.curves.find(contact.lcidab);
  if (curve == context.model.curves.end())
    context.unknown(fmt::format("contact {}: curve {} of LCIDAB is not defined", contact.id.value, contact.lcidab),
                    contact.place);
  else if (const double thickness = curve->second.at(0); std::isfinite(thickness))
    contact.airbag_thickness = thickness;
}

/// Pre-processors write SPOTHIN into every deck; it matters where shells are welded.
void name_thinning(Context& context) {
  const std::vector<Material>& materials = context.model.materials;
  const double thinning = context.spot_thinning;
  if (!(thinning > 0 && thinning < 1) ||
      std::none_of(materials.begin(), materials.end(), [](const Material& material) { return material.spotweld; }))
    return;
  context.warning(context.spot_thinning_place,
                  fmt::format("SPOTHIN = {}: shells at spot welds keep their contact thickness; next to welds "
                              "penetrations may be listed that the solver does not find",
                              thinning));
}

}  // namespace

void finish_contacts(Context& context) {
  number_contacts(context);
  name_thinning(context);
  for (Contact& contact : context.model.contacts) {
    if (contact.kind == nullptr) continue;
    resolve_thickness_curve(context, contact);
    check_side(context, contact, contact.a, "SURFA");
    check_side(context, contact, contact.b, "SURFB");
  }
}

}  // namespace gapcheck::model
