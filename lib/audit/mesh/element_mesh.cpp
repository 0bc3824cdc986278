#include "audit/mesh/element_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gapcheck::audit {
namespace {

using model::ElementKind;

/// What contacts say about the elements of one kind.
struct InContact {
  std::vector<std::int64_t> contact;
  std::vector<double> thickness;

  explicit InContact(std::size_t elements) : contact(elements, 0), thickness(elements, 0) {}
};

class Contacts {
 public:
  explicit Contacts(const model::Mesh& mesh)
      : kinds_{InContact{mesh.shells.size()},
               InContact{mesh.solids.size()},
               InContact{mesh.thick_shells.size()},
               InContact{mesh.beams.size()},
               InContact{0},
               InContact{0},
               InContact{mesh.particles.size()}} {}

  void add(const contact::Segments& segments, std::int64_t contact) {
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
  [[nodiscard]] const InContact& of(ElementKind kind) const { return kinds_[static_cast<std::size_t>(kind)]; }

 private:
  std::array<InContact, 7> kinds_;  ///< by ElementKind
};

/// Puts elements into the mesh, kind by kind.
class Builder {
 public:
  Builder(const model::Model& model, const Contacts& contacts, ElementMesh& mesh)
      : model_(model), contacts_(contacts), mesh_(mesh), position_(model.mesh.nodes.size(), no_position) {}

  template <std::size_t N>
  void add(const model::Elements<N>& elements, ElementKind kind) {
    const InContact& in = contacts_.of(kind);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (!std::all_of(elements.nodes[i].begin(), elements.nodes[i].end(), [&](NodeIndex n) { return drawable(n); })) {
        ++mesh_.left_out;
        continue;
      }
      for (const NodeIndex node : elements.nodes[i]) mesh_.corners.push_back(position(node));
      mesh_.ends.push_back(mesh_.corners.size());
      mesh_.element_ids.push_back(elements.id[i]);
      const PartIndex part = elements.part[i];
      mesh_.part_ids.push_back(part.value < model_.parts.size() ? model_.part(part).id.value : 0);
      mesh_.contact_ids.push_back(in.contact[i]);
      mesh_.thickness.push_back(in.thickness[i]);
    }
  }

 private:
  [[nodiscard]] bool drawable(NodeIndex node) const {
    return node.value < position_.size() && model_.mesh.nodes.x[node.value].allFinite();
  }
  std::uint32_t position(NodeIndex node) {
    std::uint32_t& known = position_[node.value];
    if (known == no_position) {
      known = static_cast<std::uint32_t>(mesh_.x.size());
      mesh_.node_ids.push_back(model_.mesh.nodes.id[node.value]);
      mesh_.x.push_back(model_.mesh.nodes.x[node.value]);
    }
    return known;
  }

  const model::Model& model_;
  const Contacts& contacts_;
  ElementMesh& mesh_;
  std::vector<std::uint32_t> position_;  ///< in the mesh, of each node of the model
};

}  // namespace

ElementMesh element_mesh(const model::Model& model, contact::SurfaceStore& surfaces,
                         std::span<const ContactIndex> contacts) {
  Contacts in_contact(model.mesh);
  for (const ContactIndex i : contacts) {
    const model::Contact& contact = model.contact(i);
    if (!contact.known || contact.own_layout || !contact.cards.any) continue;
    const contact::ContactSurfaces& sides = surfaces.at(i);
    in_contact.add(sides.a.selection.segments, contact.id.value);
    if (sides.two_sided()) in_contact.add(sides.b.selection.segments, contact.id.value);
  }
  ElementMesh mesh;
  Builder builder(model, in_contact, mesh);
  builder.add(model.mesh.shells, ElementKind::shell);
  builder.add(model.mesh.solids, ElementKind::solid);
  builder.add(model.mesh.thick_shells, ElementKind::thick_shell);
  builder.add(model.mesh.beams, ElementKind::beam);
  builder.add(model.mesh.particles, ElementKind::particle);
  return mesh;
}

std::int64_t highest_set(const model::Sets& sets) {
  std::int64_t highest = 0;
  const auto count = [&](const auto& kind) {
    if (!kind.empty()) highest = std::max(highest, kind.rbegin()->first);
  };
  count(sets.nodes);
  count(sets.parts);
  count(sets.segments);
  count(sets.shells);
  count(sets.solids);
  count(sets.thick_shells);
  count(sets.beams);
  count(sets.discrete);
  return highest;
}

}  // namespace gapcheck::audit
