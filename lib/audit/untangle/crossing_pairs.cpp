#include "audit/untangle/crossing_pairs.hpp"

#include <algorithm>
#include <vector>

#include "contact/crossing/crossings.hpp"
#include "contact/definition/repeated_contacts.hpp"

namespace gapcheck::audit {

std::vector<ContactCrossing> contact_crossings(const model::Model& model, contact::SurfaceStore& surfaces,
                                               const std::vector<Vector>& x) {
  std::vector<ContactIndex> contacts;
  const std::vector<ContactIndex> first = contact::repeated_contacts(model);
  for (const ContactIndex c : positions<ContactIndex>(model.contacts.size()))
    if (first[c.value] == none<ContactIndex>) contacts.push_back(c);
  contact::CrossingCounters counters;
  contact::CrossingOptions options;
  options.x = &x;
  std::vector<ContactCrossing> list;
  for (const contact::Crossing& c : contact::find_crossings(model, contacts, surfaces, options, counters)) {
    if (c.a.element == no_position || c.b.element == no_position) continue;
    const ElementOfKind a{c.a.kind, c.a.element}, b{c.b.kind, c.b.element};
    list.push_back({c.contact, {std::min(a, b), std::max(a, b)}});
  }
  return list;
}

std::set<ElementPair> crossing_pairs(const model::Model& model) {
  contact::SurfaceStore surfaces(model);
  std::set<ElementPair> pairs;
  for (const ContactCrossing& c : contact_crossings(model, surfaces, model.mesh.nodes.x)) pairs.insert(c.elements);
  return pairs;
}

std::span<const NodeIndex> nodes_of(const model::Mesh& mesh, const ElementOfKind& element) {
  const std::uint32_t i = element.second;
  const auto nodes = [&](const auto& elements) {
    return i < elements.size() ? std::span<const NodeIndex>(elements.nodes[i]) : std::span<const NodeIndex>{};
  };
  switch (element.first) {
    case model::ElementKind::shell:
      return nodes(mesh.shells);
    case model::ElementKind::solid:
      return nodes(mesh.solids);
    case model::ElementKind::thick_shell:
      return nodes(mesh.thick_shells);
    case model::ElementKind::beam:
      return nodes(mesh.beams);
    default:
      return {};
  }
}

}  // namespace gapcheck::audit
