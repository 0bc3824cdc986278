#include <fmt/format.h>

#include "audit/grouped.hpp"
#include "audit/rules.hpp"
#include "contact/definition/friction.hpp"
#include "contact/surface/contact_surfaces.hpp"

namespace gapcheck::audit::rule::part_friction {
namespace {

bool gives_friction(const model::Part& part) {
  return part.contact && (part.contact->fs != 0 || part.contact->fd != 0 || part.contact->vc != 0);
}

/// True if a part of the surface gives friction; `gives` is by part.
bool any_part(const model::Mesh& mesh, const contact::ContactSide& side, const std::vector<bool>& gives) {
  const contact::Segments& segments = side.selection.segments;
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (const PartIndex part = contact::part_of(mesh, segments, i); part != none<PartIndex> && gives[part.value])
      return true;
  // Nodes without segments have the part of their elements.
  for (const PartIndex part : side.nodes.part)
    if (part != none<PartIndex> && gives[part.value]) return true;
  return false;
}

std::string problem(Context& context, ContactIndex i, const std::vector<bool>& gives, bool any_in_deck) {
  const model::Contact& contact = context.model().contact(i);
  if (!contact::takes_part_friction(contact))
    return fmt::format("FS = -1 is not available for *{}; give FS and FD on the contact", contact.written);
  if (any_in_deck) {
    const contact::ContactSurfaces& surfaces = context.surfaces(i);
    if (any_part(context.model().mesh, surfaces.a, gives) || any_part(context.model().mesh, surfaces.b, gives))
      return {};
  }
  return "FS = -1 takes the friction of the parts, and no part of this contact has any: it slides without friction; "
         "give FS and FD on *PART_CONTACT or on the contact";
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const model::Model& model = context.model();
  const model::Controls& controls = model.controls;
  const bool global = controls.sfric != 0 || controls.dfric != 0 || controls.vfc != 0;
  std::vector<bool> gives(model.parts.size(), global);
  bool any_in_deck = global;
  for (std::size_t i = 0; i < model.parts.size(); ++i)
    if (gives_friction(model.parts[i])) gives[i] = any_in_deck = true;
  std::vector<Finding> found;
  for (const ContactIndex i : context.read_contacts()) {
    if (model.contact(i).fs != contact::friction_of_parts || !contact::has_friction(model.contact(i))) continue;
    const std::string text = problem(context, i, gives, any_in_deck);
    if (!text.empty()) found.push_back(finding_at(rule, context, model.contact(i), text));
  }
  add_first(report, std::move(found), "more contacts with FS = -1 have no friction");
}

}  // namespace

const Rule definition{
    {"GC407", "part-friction", Severity::warning, "a contact takes its friction from parts that have none",
     Need::surfaces, "The contact runs without friction"},
    run};

}  // namespace gapcheck::audit::rule::part_friction
