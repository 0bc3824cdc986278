#pragma once
#include <algorithm>

#include "model/entity/faces.hpp"
#include "model/entity/mesh.hpp"

namespace gapcheck::contact {

/// Calls visit(corners) for every shell and for the faces of every solid and thick shell that has a node for which
/// asked(node) is true. Linear in the size of the mesh.
template <class Asked, class Visit>
void for_each_face_at(const model::Mesh& mesh, const Asked& asked, const Visit& visit) {
  const auto has_one = [&](const auto& nodes) { return std::any_of(nodes.begin(), nodes.end(), asked); };
  for (const model::SegmentNodes& shell : mesh.shells.nodes)
    if (has_one(shell)) visit(shell);
  for (const auto* solids : {&mesh.solids, &mesh.thick_shells})
    for (const auto& solid : solids->nodes) {
      if (!has_one(solid)) continue;
      for (const model::SegmentNodes& face : model::SolidFaces(solid)) visit(face);
    }
}

}  // namespace gapcheck::contact
