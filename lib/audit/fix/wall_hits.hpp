#pragma once
#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace gapcheck::audit {

/// A node in a rigid wall.
struct WallHit {
  std::uint32_t wall = 0;  ///< position in Model::rigid_walls
  NodeIndex node;
  double depth = 0;
  Vector surface = Vector::Zero();  ///< nearest point of the wall's surface
  Vector normal = Vector::Zero();   ///< there, away from the wall
};

/// Finds the nodes that rigid walls stop and that lie in them (GC110), at different coordinates of one model, which
/// must outlive it. Walls that are born later do not count.
class WallSearch {
 public:
  /// The model has its first coordinates: they decide which nodes a wall with a box or an offset sees.
  explicit WallSearch(const model::Model& model);
  /// By wall, then node. A node that has not moved since the first search is not looked at again.
  [[nodiscard]] std::vector<WallHit> at(const std::vector<Vector>& x);

 private:
  struct Wall {
    std::uint32_t position = 0;
    std::vector<NodeIndex> nodes;  ///< ascending
    std::vector<NodeIndex> hit;    ///< of these, at the first coordinates
  };
  const model::Model& model_;
  std::vector<Vector> first_;
  std::vector<Wall> walls_;
};

}  // namespace gapcheck::audit
