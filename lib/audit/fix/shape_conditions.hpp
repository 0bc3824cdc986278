#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "audit/fix/element_bounds.hpp"
#include "audit/untangle/crossing_pairs.hpp"

namespace gapcheck::audit {

/// Σ coefficientᵢ · direction · uᵢ >= bound for the moves u of an element's nodes.
struct ShapeCondition {
  std::array<NodeIndex, 4> nodes{};
  std::array<double, 4> coefficient{};
  Vector direction = Vector::Zero();
  double bound = 0;
  double multiplier = 0;  ///< of least_movement(), to start from
};

/// Conditions, linear in the moves, under which an element stays well within its limits for small rotations: the nodes
/// of a quadrilateral leave its plane alternately by no more than the warp allows, and edges are not shortened too
/// much. They pull neighbours along where a single node would go too far. `x`: the deck's coordinates.
[[nodiscard]] std::vector<ShapeCondition> shape_conditions(const model::Mesh& mesh, const std::vector<Vector>& x,
                                                           const ElementOfKind& element, const ShapeLimits& limits);

}  // namespace gapcheck::audit
