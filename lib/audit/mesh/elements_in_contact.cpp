#include "audit/mesh/elements_in_contact.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::audit {

ElementsInContact::ElementsInContact(const model::Model& model, contact::SurfaceStore& surfaces,
                                     std::span<const ContactIndex> contacts) {
  using enum model::ElementKind;
  const auto resize = [&](model::ElementKind kind, std::size_t elements) {
    InContact& in = kinds_[static_cast<std::size_t>(kind)];
    in.contact.resize(elements, 0);
    in.thickness.resize(elements, 0);
  };
  resize(shell, model.mesh.shells.size());
  resize(solid, model.mesh.solids.size());
  resize(thick_shell, model.mesh.thick_shells.size());
  resize(beam, model.mesh.beams.size());
  resize(particle, model.mesh.particles.size());
  for (const ContactIndex i : contacts) {
    const model::Contact& contact = model.contact(i);
    if (!contact.known || contact.own_layout || !contact.cards.any) continue;
    const contact::ContactSurfaces& sides = surfaces.at(i);
    add(sides.a.selection.segments, contact.id.value);
    if (sides.two_sided()) add(sides.b.selection.segments, contact.id.value);
  }
}

void ElementsInContact::add(const contact::Segments& segments, std::int64_t contact) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    InContact& kind = kinds_[static_cast<std::size_t>(segments.element_kind[i])];
    const std::uint32_t element = segments.element[i];
    if (element >= kind.contact.size()) continue;
    if (kind.contact[element] == 0) kind.contact[element] = contact;
    if (i >= segments.half.size()) continue;
    const double thickness = 2 * segments.half[i];
    if (std::isfinite(thickness)) kind.thickness[element] = std::max(kind.thickness[element], thickness);
  }
}

}  // namespace gapcheck::audit
