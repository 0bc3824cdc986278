#include "audit/fix/wall_hits.hpp"

#include <algorithm>
#include <iterator>

#include "contact/rigid_wall.hpp"

namespace gapcheck::audit {

WallSearch::WallSearch(const model::Model& model) : model_(model) {
  if (model.rigid_walls.empty()) return;
  first_ = model.mesh.nodes.x;
  contact::WallNodes nodes(model);
  for (std::uint32_t i = 0; i < model.rigid_walls.size(); ++i) {
    const model::RigidWall& wall = model.rigid_walls[i];
    if (wall.birth > 0) continue;
    Wall one{i, nodes.of(wall), {}};
    for (const NodeIndex n : one.nodes)
      if (contact::wall_penetration(wall, first_[n.value])) one.hit.push_back(n);
    walls_.push_back(std::move(one));
  }
}

std::vector<WallHit> WallSearch::at(const std::vector<Vector>& x) {
  std::vector<WallHit> hits;
  if (walls_.empty()) return hits;
  std::vector<NodeIndex> moved, both;
  for (const NodeIndex n : positions<NodeIndex>(x.size()))
    if (x[n.value] != first_[n.value]) moved.push_back(n);
  for (const Wall& wall : walls_) {
    both.clear();
    std::set_intersection(wall.nodes.begin(), wall.nodes.end(), moved.begin(), moved.end(), std::back_inserter(both));
    const auto middle = static_cast<std::ptrdiff_t>(both.size());
    std::set_difference(wall.hit.begin(), wall.hit.end(), moved.begin(), moved.end(), std::back_inserter(both));
    std::inplace_merge(both.begin(), both.begin() + middle, both.end());
    for (const NodeIndex n : both)
      if (const auto in = contact::wall_penetration(model_.rigid_walls[wall.position], x[n.value]))
        hits.push_back({wall.position, n, in->depth, in->surface, in->normal});
  }
  return hits;
}

}  // namespace gapcheck::audit
