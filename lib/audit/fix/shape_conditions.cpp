#include "audit/fix/shape_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapcheck::audit {
namespace {

/// The share of the limits that the linear conditions use; the rest is for nonlinear effects.
constexpr double linear_share = 0.8;

void add_warp(std::span<const NodeIndex> n, const std::vector<Vector>& x, double degrees,
              std::vector<ShapeCondition>& list) {
  const Vector a = x[n[2].value] - x[n[0].value], b = x[n[3].value] - x[n[1].value];
  const Vector normal = a.cross(b);
  const double longest = std::max(a.norm(), b.norm());
  if (!(normal.norm() > 0) || !(longest > 0)) return;
  ShapeCondition c;
  c.direction = normal.normalized();
  // A corner this far above the plane of the others turns the two triangles at a diagonal by the angle.
  const double reach = normal.norm() / 2 / longest * std::tan(linear_share * degrees * std::numbers::pi / 180);
  const double now = c.direction.dot(x[n[0].value] - x[n[1].value] + x[n[2].value] - x[n[3].value]);
  const double most = std::max(reach, std::abs(now));
  for (std::size_t i = 0; i < 4; ++i) {
    c.nodes[i] = n[i];
    c.coefficient[i] = i % 2 == 0 ? 1 : -1;
  }
  c.bound = -most - now;
  list.push_back(c);
  c.direction = -c.direction;
  c.bound = -most + now;
  list.push_back(c);
}

void add_edges(std::span<const NodeIndex> n, const std::vector<Vector>& x, double from,
               std::vector<ShapeCondition>& list) {
  constexpr std::array<std::array<std::size_t, 2>, 12> edges{
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  const std::size_t count = n.size() == 2 ? 1 : n.size() == 4 ? 4 : 12;
  for (std::size_t i = 0; i < count; ++i) {
    const NodeIndex a = n[edges[i][0]], b = n[edges[i][1]];
    const Vector along = x[b.value] - x[a.value];
    if (!(along.norm() > 0)) continue;
    ShapeCondition c;
    c.nodes = {b, a, a, a};
    c.coefficient = {1, -1, 0, 0};
    c.direction = along.normalized();
    c.bound = -linear_share * (1 - from) * along.norm();
    list.push_back(c);
  }
}

}  // namespace

std::vector<ShapeCondition> shape_conditions(const model::Mesh& mesh, const std::vector<Vector>& x,
                                             const ElementOfKind& element, const ShapeLimits& limits) {
  std::vector<ShapeCondition> list;
  const std::span<const NodeIndex> n = nodes_of(mesh, element);
  if (n.empty() || std::find(n.begin(), n.end(), none<NodeIndex>) != n.end()) return list;
  if (n.size() == 4 && n[2] != n[3]) add_warp(n, x, limits.warp, list);
  add_edges(n, x, limits.edge_from, list);
  return list;
}

}  // namespace gapcheck::audit
