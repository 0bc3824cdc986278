#include "audit/mesh/element_mesh.hpp"

#include <algorithm>
#include <array>

#include "audit/mesh/elements_in_contact.hpp"

namespace gapcheck::audit {
namespace {

using model::ElementKind;

MeshElement mesh_element(ElementKind kind) {
  switch (kind) {
    case ElementKind::solid:
      return MeshElement::solid;
    case ElementKind::thick_shell:
      return MeshElement::thick_shell;
    case ElementKind::beam:
      return MeshElement::beam;
    case ElementKind::particle:
      return MeshElement::particle;
    default:
      return MeshElement::shell;
  }
}

/// Puts elements into the mesh, kind by kind.
class Builder {
 public:
  Builder(const model::Model& model, const ElementsInContact& contacts, ElementMesh& mesh)
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
      mesh_.kinds.push_back(mesh_element(kind));
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
  const ElementsInContact& contacts_;
  ElementMesh& mesh_;
  std::vector<std::uint32_t> position_;  ///< in the mesh, of each node of the model
};

}  // namespace

ElementMesh element_mesh(const model::Model& model, contact::SurfaceStore& surfaces,
                         std::span<const ContactIndex> contacts) {
  const ElementsInContact in_contact(model, surfaces, contacts);
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
  count(sets.branches);
  count(sets.segments);
  count(sets.shells);
  count(sets.solids);
  count(sets.thick_shells);
  count(sets.beams);
  count(sets.discrete);
  return highest;
}

}  // namespace gapcheck::audit
