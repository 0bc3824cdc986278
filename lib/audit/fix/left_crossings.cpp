#include "audit/fix/left_crossings.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

#include "audit/shared/acting_contact.hpp"
#include "audit/untangle/untangling.hpp"
#include "contact/crossing/enclosed_bodies.hpp"

namespace gapcheck::audit {
namespace {

/// Steps at most to find out why elements still cross: a few seconds.
constexpr std::uint64_t most_work = 1'000'000'000;

struct IdAndPart {
  std::int64_t id = 0, part = 0;
};

IdAndPart id_and_part(const model::Model& model, const ElementOfKind& element) {
  const auto of = [&](const auto& elements) {
    const PartIndex part = elements.part[element.second];
    return IdAndPart{elements.id[element.second], part == none<PartIndex> ? 0 : model.parts[part.value].id.value};
  };
  switch (element.first) {
    case model::ElementKind::shell:
      return of(model.mesh.shells);
    case model::ElementKind::solid:
      return of(model.mesh.solids);
    case model::ElementKind::thick_shell:
      return of(model.mesh.thick_shells);
    default:
      return of(model.mesh.beams);
  }
}

std::string why_left(const CrossingPlace& place, const std::function<HoldReason(NodeIndex)>& reason) {
  if (!place.divided)
    return "the line in which they cross divides neither of them: it is not clear which side is right";
  if (place.too_deep > 0) return fmt::format("a piece would have to come back by {:.4g}", place.too_deep);
  std::map<HoldReason, std::size_t> reasons;
  for (const NodeIndex n : place.nodes) ++reasons[reason(n)];
  HoldReason most = HoldReason::none;
  std::size_t count = 0;
  for (const auto& [one, nodes] : reasons) {
    if (one == HoldReason::none || nodes <= count) continue;
    most = one;
    count = nodes;
  }
  return std::string(words(most));
}

}  // namespace

std::vector<LeftCrossing> left_crossings(const model::Model& model,
                                         const std::function<HoldReason(NodeIndex)>& reason) {
  contact::SurfaceStore surfaces(model);
  const std::vector<Vector>& x = model.mesh.nodes.x;
  std::uint64_t work = most_work;
  const auto crossings = contact_crossings(model, surfaces, x);
  const Untangling untangling(model, surfaces, x, crossings, {}, work);
  std::vector<LeftCrossing> list;
  for (const CrossingPlace& place : untangling.places()) {
    const IdAndPart a = id_and_part(model, place.elements[0].front()),
                    b = id_and_part(model, place.elements[1].front());
    list.push_back({place.contact.value, a.part, b.part, a.id, b.id, place.pairs, why_left(place, reason)});
  }
  return list;
}

std::vector<EnclosedSolids> enclosed_solids(const model::Model& model) {
  contact::SurfaceStore surfaces(model);
  std::vector<ContactIndex> contacts;
  for (const ContactIndex c : positions<ContactIndex>(model.contacts.size())) contacts.push_back(c);
  ActingContact acting(model, std::move(contacts),
                       [&](ContactIndex c) -> const contact::ContactSurfaces& { return surfaces.at(c); });
  contact::CrossingCounters counters;
  std::vector<EnclosedSolids> list;
  for (const contact::EnclosedBody& body : contact::find_enclosed_bodies(
           model, [&](PartIndex p, PartIndex q) { return acting(p, q); }, {}, counters))
    list.push_back({body.contact.value, model.part(body.inner).id.value, model.part(body.outer).id.value,
                    model.mesh.solids.id[body.first_solid], body.solids});
  return list;
}

}  // namespace gapcheck::audit
