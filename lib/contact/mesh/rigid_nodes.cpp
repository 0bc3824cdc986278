#include "contact/mesh/rigid_nodes.hpp"

#include <algorithm>

namespace gapcheck::contact {

RigidNodes::RigidNodes(const model::Model& model) : parts_(static_cast<std::uint32_t>(model.parts.size())) {
  std::vector<bool> rigid(model.parts.size());
  for (std::uint32_t p = 0; p < parts_; ++p) rigid[p] = model.rigid(PartIndex{p});
  const bool any_part = std::find(rigid.begin(), rigid.end(), true) != rigid.end();
  if (!any_part && model.rigid_groups.empty()) return;
  owner_.assign(model.mesh.nodes.size(), 0);
  const auto claim = [&](NodeIndex node, std::uint32_t owner) {
    if (node.value < owner_.size() && owner_[node.value] == 0) owner_[node.value] = owner;
  };
  const auto claim_elements = [&](const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const PartIndex part = elements.part[e];
      if (part == none<PartIndex> || !rigid[part.value]) continue;
      for (const NodeIndex n : elements.nodes[e]) claim(n, 1 + part.value);
    }
  };
  if (any_part) {
    claim_elements(model.mesh.shells);
    claim_elements(model.mesh.solids);
    claim_elements(model.mesh.thick_shells);
    claim_elements(model.mesh.beams);
  }
  for (std::uint32_t g = 0; g < model.rigid_groups.size(); ++g)
    for (const NodeIndex n : model.rigid_groups[g].nodes) claim(n, 1 + parts_ + g);
}

RigidOwner RigidNodes::owner(NodeIndex node) const {
  if (owner_.empty() || owner_[node.value] == 0) return {};
  const std::uint32_t owner = owner_[node.value] - 1;
  if (owner < parts_) return {RigidOwner::Kind::part, owner};
  return {RigidOwner::Kind::group, owner - parts_};
}

}  // namespace gapcheck::contact
