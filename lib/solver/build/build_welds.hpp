#pragma once
#include "base/diagnostic.hpp"
#include "model/model.hpp"
#include "solver/structure/structure.hpp"

namespace gapcheck::solver {

/// Makes a rigid body of each weld's nodes, once all other rigid bodies and all masses are complete. Welds of two nodes
/// fail by their forces, all by their time; plastic strain at failure, and forces of more than two nodes, are reported
/// in `diagnostics` and not calculated. A weld with a node that another rigid body or weld holds is reported and left
/// out.
void build_welds(const model::Model& model, Structure& structure, Diagnostics& diagnostics);

}  // namespace gapcheck::solver
