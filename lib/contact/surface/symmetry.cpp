#include "contact/surface/symmetry.hpp"

#include <algorithm>
#include <cmath>

#include "base/quad.hpp"

namespace gapcheck::contact {

SymmetryPlanes::SymmetryPlanes(const model::Model& model) : held_(model.mesh.nodes.size()) {
  constexpr unsigned translations = 7;
  const auto hold = [&](const std::vector<NodeIndex>& nodes, std::uint8_t freedoms) {
    for (const NodeIndex node : nodes)
      if (node.value < held_.size())
        held_[node.value] = static_cast<std::uint8_t>(held_[node.value] | (freedoms & translations));
  };
  for (const model::NodeConstraint& constraint : model.node_constraints) hold(constraint.nodes, constraint.freedoms);
  for (const model::SinglePointConstraint& spc : model.spcs) {
    if (spc.system != 0 || !spc.lifetime.always()) continue;
    if (!spc.nodes.set) {
      if (const auto node = model.mesh.nodes.lookup.find(spc.nodes.id)) hold({NodeIndex(*node)}, spc.freedoms);
    } else if (const auto set = model.sets.nodes.find(spc.nodes.id); set != model.sets.nodes.end()) {
      hold(set->second.members, spc.freedoms);
    }
  }
}

bool SymmetryPlanes::holds(const model::SegmentNodes& face, const std::vector<Vector>& x) const {
  constexpr double slope = 1e-3;
  const Vector normal = quad_normal(face, x).normalized();
  unsigned wanted = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(normal[axis]) > slope) wanted |= 1u << axis;
  return wanted != 0 &&
         std::all_of(face.begin(), face.end(), [&](NodeIndex node) { return (held_[node.value] & wanted) == wanted; });
}

void SymmetryPlanes::leave_out(Segments& segments, const std::vector<Vector>& x) const {
  std::size_t place = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const bool solid = segments.kind[i] == SegmentKind::solid;
    if (solid && holds(segments.nodes[i], x)) continue;
    segments.nodes[place] = segments.nodes[i];
    segments.element[place] = segments.element[i];
    segments.element_kind[place] = segments.element_kind[i];
    segments.kind[place++] = segments.kind[i];
  }
  segments.nodes.resize(place);
  segments.element.resize(place);
  segments.element_kind.resize(place);
  segments.kind.resize(place);
}

}  // namespace gapcheck::contact
