#include "contact/present_surfaces.hpp"

#include "base/stopwatch.hpp"

namespace gapcheck::contact {

const ContactSurfaces& PresentSurfaces::at(ContactIndex contact) {
  if (moves_ == 0) return deck_.at(contact);
  const Stopwatch watch(counters_.surface_s);
  ++counters_.surfaces_built;
  return built_.emplace(deck_.build(contact, x_, &sides_));
}

void PresentSurfaces::move(NodeIndex node, const Vector& to) {
  x_[node.value] = to;
  ++moves_;
  sides_.clear();
}

TieResult PresentSurfaces::tie(const TieScene& scene, ContactIndex contact, const ContactSurfaces& surfaces,
                               TiedPairs& ties) {
  TieResult result = apply_ties(scene, contact, surfaces, x_, ties);
  if (result.moved > 0) {
    ++moves_;
    sides_.clear();
  }
  return result;
}

}  // namespace gapcheck::contact
