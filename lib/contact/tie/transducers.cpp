#include "contact/tie/transducers.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <string>

#include "contact/tie/ties.hpp"

namespace gapcheck::contact {
namespace {

/// One bit per side: 2 i and 2 i + 1 are the sides of transducer i.
using Sides = std::bitset<2 * max_transducers>;

/// Which sides meet in some element or node.
class Meetings {
 public:
  explicit Meetings(std::size_t sides) : meets_(sides) {}
  void add(const std::vector<Sides>& sides_of_item, const Sides& counted) {
    Sides last;
    for (const Sides& sides : sides_of_item) {
      if (sides == last) continue;
      last = sides;
      for (std::size_t s = 0; s < meets_.size(); ++s)
        if (sides.test(s)) meets_[s] |= counted.test(s) ? sides : sides & counted;
    }
  }
  [[nodiscard]] bool overlap(std::size_t i, std::size_t j) const {
    const auto meet = [&](std::size_t s, std::size_t t) { return meets_[s].test(t); };
    return (meet(2 * i, 2 * j) && meet(2 * i + 1, 2 * j + 1)) || (meet(2 * i, 2 * j + 1) && meet(2 * i + 1, 2 * j));
  }

 private:
  std::vector<Sides> meets_;
};

bool nodes_only(const Selection& side) { return side.segments.size() == 0; }

/// Sides by element: shells, then solids, thick shells and beams.
std::vector<Sides> sides_of_elements(const model::Mesh& mesh, const std::vector<const Selection*>& sides) {
  const std::size_t shells = mesh.shells.size(), solids = shells + mesh.solids.size(),
                    thick = solids + mesh.thick_shells.size(), all = thick + mesh.beams.size();
  std::vector<Sides> result(all);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const Segments& segments = sides[s]->segments;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (segments.element[i] == no_position) continue;
      std::size_t first = 0;
      if (segments.element_kind[i] == model::ElementKind::solid) first = shells;
      if (segments.element_kind[i] == model::ElementKind::thick_shell) first = solids;
      if (segments.element_kind[i] == model::ElementKind::beam) first = thick;
      result[first + segments.element[i]].set(s);
    }
  }
  return result;
}

std::vector<Sides> sides_of_nodes(const model::Mesh& mesh, const std::vector<const Selection*>& sides) {
  std::vector<Sides> result(mesh.nodes.size());
  for (std::size_t s = 0; s < sides.size(); ++s) {
    for (const NodeIndex node : sides[s]->nodes) result[node.value].set(s);
    for (const model::SegmentNodes& nodes : sides[s]->segments.nodes)
      for (const NodeIndex node : nodes) result[node.value].set(s);
  }
  return result;
}

}  // namespace

bool has_second_surface(const model::Contact& transducer) {
  const model::SurfaceInput& b = transducer.b;
  return b.given && (b.id != 0 || b.type == static_cast<std::int64_t>(model::SurfaceType::all));
}

bool measures_constraints(const model::Contact& transducer) {
  return transducer.kind != nullptr && transducer.kind->can(Ability::measures_constraints);
}

bool measures_between(const model::Contact& transducer) {
  return has_second_surface(transducer) && !measures_constraints(transducer);
}

bool tells_surfaces(const model::Contact& contact) {
  return contact.kind != nullptr && contact.kind->can(Ability::tells_surfaces);
}

bool measures(const model::Contact& transducer, const model::Contact& contact) {
  const ContactType type = classify(contact);
  const bool by_constraint = ties_by_constraint(type) || type.family == Family::constraint;
  return measures_constraints(transducer) == by_constraint;
}

std::vector<std::optional<std::uint32_t>> overlapping_transducers(const model::Mesh& mesh,
                                                                  const std::vector<Transducer>& transducers) {
  std::vector<std::optional<std::uint32_t>> earlier(transducers.size());
  const std::size_t count = std::min(transducers.size(), max_transducers);
  std::vector<const Selection*> sides;
  Sides of_nodes;
  for (std::size_t i = 0; i < count; ++i)
    for (const Selection* side : {transducers[i].a, transducers[i].b}) {
      of_nodes.set(sides.size(), nodes_only(*side));
      sides.push_back(side);
    }
  Meetings meetings(sides.size());
  meetings.add(sides_of_elements(mesh, sides), ~Sides());
  if (of_nodes.any()) meetings.add(sides_of_nodes(mesh, sides), of_nodes);
  for (std::uint32_t i = 1; i < count; ++i)
    for (std::uint32_t j = 0; j < i && !earlier[i]; ++j)
      if (meetings.overlap(i, j)) earlier[i] = j;
  return earlier;
}

}  // namespace gapcheck::contact
