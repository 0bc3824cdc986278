#include "audit/shared/acting_contact.hpp"

#include "contact/crossing/crossings.hpp"

namespace gapcheck::audit {
namespace {

std::vector<bool> solid_parts(const model::Model& model, const contact::Segments& segments) {
  std::vector<bool> mask(model.parts.size(), false);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments.element_kind[i] != model::ElementKind::solid) continue;
    const PartIndex part = contact::part_of(model.mesh, segments, i);
    if (part != none<PartIndex>) mask[part.value] = true;
  }
  return mask;
}

}  // namespace

ContactIndex ActingContact::operator()(PartIndex p, PartIndex q) {
  for (const ContactIndex i : contacts_) {
    if (contact::classify(model_.contact(i)).pairing == contact::Pairing::none) continue;
    const SolidParts& parts = solids(i);
    const bool acts = (parts.a[p.value] && parts.b[q.value]) || (parts.a[q.value] && parts.b[p.value]);
    if (acts && contact::CrossingPairs(model_, model_.contact(i).id).counts(p, q)) return i;
  }
  return none<ContactIndex>;
}

const ActingContact::SolidParts& ActingContact::solids(ContactIndex contact) {
  const auto known = parts_.find(contact);
  if (known != parts_.end()) return known->second;
  const contact::ContactSurfaces& s = surfaces_(contact);
  SolidParts parts{solid_parts(model_, s.a.selection.segments), {}};
  parts.b = s.two_sided() ? solid_parts(model_, s.b.selection.segments) : parts.a;
  return parts_.emplace(contact, std::move(parts)).first->second;
}

}  // namespace gapcheck::audit
