#pragma once
#include <vector>

#include "model/model.hpp"
#include "solver/structure/mass_points.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Sums over the elements of one rigid part.
struct RigidPart {
  std::vector<PointMass> points;
  std::vector<NodeIndex> nodes;  ///< with repeats
};

/// Makes the rigid bodies of a structure, once all its other masses are complete: one per rigid part, with the extra
/// nodes of *CONSTRAINED_EXTRA_NODES; parts that *CONSTRAINED_RIGID_BODIES merges are one body; one per nodal rigid
/// body. They come in the order of the parts, then of the nodal rigid bodies. `parts`: by part of the model.
void build_rigid_bodies(const model::Model& model, std::vector<RigidPart> parts, Structure& structure);

}  // namespace gapcheck::solver
