#pragma once
#include <Eigen/Dense>
#include <array>
#include <cstdint>
#include <vector>

#include "model/entity/part.hpp"
#include "solver/state/tensor.hpp"

namespace gapcheck::solver {

/// A node of *CONSTRAINED_INTERPOLATION that follows the rigid motion next to that of other nodes.
struct Follower {
  std::int64_t id = 0;
  std::uint32_t node = 0;
  /// By column: the direction of a degree of freedom that follows, of its velocity or its angular velocity.
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6> axes;
  std::vector<std::uint32_t> nodes;  ///< followed, each once, ascending; none of them follows others
  std::vector<Matrix> weights;       ///< of their translations, in global axes
  bool ends_run = true;              ///< when all elements of one of its nodes have failed (IDNSW = 1)
  model::Place place;
};

}  // namespace gapcheck::solver
