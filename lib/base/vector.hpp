#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

namespace gapcheck {

/// A point or direction in space, in the deck's length unit.
using Vector = Eigen::Vector3d;

}  // namespace gapcheck
