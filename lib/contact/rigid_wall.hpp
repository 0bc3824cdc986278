#pragma once
#include <optional>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::contact {

/// How deep a point lies in a rigid wall, in deck units, and the point of the wall's surface that is nearest to it.
struct WallPenetration {
  double depth = 0;
  Vector surface = Vector::Zero();
};

/// Nothing where the point is outside, touches (up to 1e-9 of the coordinates' size), or is no finite number. Behind a
/// plane every depth counts; of a rectangle only what lies behind it along its normal. A prism, cylinder or sphere is
/// deep by the distance to the nearest of its faces that is not at infinity.
[[nodiscard]] std::optional<WallPenetration> wall_penetration(const model::RigidWall& wall, const Vector& x);

/// The nodes that a wall stops, ascending: those of its set (or all that an element uses), without exempted ones, those
/// of rigid bodies (where RWPNAL = 0), those outside its box or offset.
[[nodiscard]] std::vector<NodeIndex> nodes_of_wall(const model::Model& model, const model::RigidWall& wall);

}  // namespace gapcheck::contact
