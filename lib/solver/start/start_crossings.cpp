#include "solver/start/start_crossings.hpp"

#include <algorithm>
#include <set>

#include "contact/crossing/crossings.hpp"
#include "contact/definition/repeated_contacts.hpp"

namespace gapcheck::solver {
namespace {

using contact::Crossing;
using contact::CrossingSegment;
using ElementKey = std::pair<model::ElementKind, std::uint32_t>;

std::vector<ContactIndex> contacts_that_judge_nodes(const model::Model& model) {
  const std::vector<ContactIndex> first = contact::repeated_contacts(model);
  std::vector<ContactIndex> list;
  for (const ContactIndex c : positions<ContactIndex>(model.contacts.size()))
    if (first[c.value] == none<ContactIndex> && contact::classify(model.contact(c)).checked()) list.push_back(c);
  return list;
}

std::pair<ElementKey, ElementKey> key_of(const Crossing& crossing) {
  const ElementKey a{crossing.a.kind, crossing.a.element}, b{crossing.b.kind, crossing.b.element};
  return {std::min(a, b), std::max(a, b)};
}

template <class Elements>
StartCrossing::Element crossing_element(const model::Model& model, const Elements& elements, std::string_view kind,
                                        std::uint32_t i) {
  if (i >= elements.size()) return {kind};
  const PartIndex part = elements.part[i];
  return {kind, elements.id[i], part == none<PartIndex> ? 0 : model.part(part).id.value};
}

StartCrossing::Element element_of(const model::Model& model, const CrossingSegment& segment) {
  const model::Mesh& mesh = model.mesh;
  switch (segment.kind) {
    case model::ElementKind::shell:
      return crossing_element(model, mesh.shells, "shell", segment.element);
    case model::ElementKind::solid:
      return crossing_element(model, mesh.solids, "solid", segment.element);
    case model::ElementKind::thick_shell:
      return crossing_element(model, mesh.thick_shells, "thick shell", segment.element);
    case model::ElementKind::beam:
      return crossing_element(model, mesh.beams, "beam", segment.element);
    default:
      return {"segment"};
  }
}

}  // namespace

std::vector<StartCrossing> created_crossings(const model::Model& model, contact::SurfaceStore& surfaces,
                                             const std::vector<Vector>& start,
                                             const std::map<NodeIndex, std::int64_t>& mover) {
  const std::vector<ContactIndex> contacts = contacts_that_judge_nodes(model);
  contact::CrossingCounters counters;
  contact::CrossingOptions options;
  std::set<std::pair<ElementKey, ElementKey>> before;
  for (const Crossing& c : contact::find_crossings(model, contacts, surfaces, options, counters))
    before.insert(key_of(c));
  options.x = &start;
  std::vector<StartCrossing> created;
  for (const Crossing& c : contact::find_crossings(model, contacts, surfaces, options, counters)) {
    if (before.contains(key_of(c))) continue;
    StartCrossing crossing{element_of(model, c.a), element_of(model, c.b), model.contact(c.contact).id.value, 0,
                           c.depth};
    double farthest = 0;
    for (const CrossingSegment* segment : {&c.a, &c.b})
      for (const NodeIndex node : segment->nodes) {
        const double way = (start[node.value] - model.mesh.nodes.x[node.value]).norm();
        const auto who = mover.find(node);
        if (who == mover.end() || way <= farthest) continue;
        farthest = way;
        crossing.moved_by = who->second;
      }
    created.push_back(crossing);
  }
  return created;
}

}  // namespace gapcheck::solver
