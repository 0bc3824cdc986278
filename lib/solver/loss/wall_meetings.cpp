#include "solver/loss/wall_meetings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "contact/rigid_wall.hpp"

namespace gapcheck::solver {
namespace {

constexpr int wall_steps = 1000;

/// A part for each node: that of the first element found; none: without.
std::vector<PartIndex> parts_of_nodes(const model::Mesh& mesh) {
  std::vector<PartIndex> parts(mesh.nodes.size(), none<PartIndex>);
  const auto take = [&](const auto& elements) {
    for (std::size_t i = 0; i < elements.size(); ++i)
      for (const NodeIndex node : elements.nodes[i])
        if (node != none<NodeIndex> && parts[node.value] == none<PartIndex>) parts[node.value] = elements.part[i];
  };
  take(mesh.shells);
  take(mesh.solids);
  take(mesh.thick_shells);
  take(mesh.beams);
  return parts;
}

/// When a node in front of the plane reaches it: with a constant velocity in one step, else by conservative
/// advancement.
std::optional<double> time_at_wall(const model::RigidWall& wall, const Vector& x, NodeIndex node, const Flight& flight,
                                   double until) {
  const double height = wall.normal.dot(x - wall.tail);
  if (!(height >= 0) || !std::isfinite(height)) return std::nullopt;
  const double speed = -wall.normal.dot(flight.base(node));
  if (flight.course(node) == no_position) {
    if (!(speed > 0) || !(height / speed < until)) return std::nullopt;
    return height / speed;
  }
  double time = 0;
  for (int i = 0; i < wall_steps; ++i) {
    const double left = height + wall.normal.dot(flight.way(node, time));
    if (left <= 1e-9 * std::max(height, std::abs(left))) return time;
    const double fastest = flight.greatest_speed(node, time, until);
    if (!(fastest > 0) || !(time + left / fastest < until)) return std::nullopt;
    time += left / fastest;
  }
  return std::nullopt;
}

bool inside_rectangle(const model::RigidWall& wall, const Vector& x) {
  const auto along = [&](const Vector& edge, double length) {
    if (!std::isfinite(length)) return true;
    const double place = edge.dot(x - wall.tail);
    return place >= 0 && place <= length;
  };
  return along(wall.edge_l, wall.length_l) && along(wall.edge_m, wall.length_m);
}

}  // namespace

std::vector<ExpectedWall> find_wall_meetings(const model::Model& model, const std::vector<Vector>& x,
                                             const Flight& flight, double until,
                                             std::vector<std::string>& not_looked_at) {
  std::vector<ExpectedWall> list;
  if (model.rigid_walls.empty()) return list;
  contact::WallNodes nodes(model);
  const std::vector<PartIndex> parts = parts_of_nodes(model.mesh);
  for (const model::RigidWall& wall : model.rigid_walls) {
    if (wall.shape != model::RigidWall::Shape::plane || wall.moving) {
      not_looked_at.push_back(fmt::format("rigid wall {}: it is not flat, or it moves", wall.id));
      continue;
    }
    std::map<PartIndex, ExpectedWall> by_part;
    for (const NodeIndex node : nodes.of(wall)) {
      if (!flight.known(node)) continue;
      const Vector& start = x[node.value];
      const std::optional<double> time = time_at_wall(wall, start, node, flight, until);
      if (!time || *time < wall.birth || (wall.death > 0 && *time >= wall.death)) continue;
      if (!inside_rectangle(wall, start + flight.way(node, *time))) continue;
      const double speed = -wall.normal.dot(flight.velocity(node, *time));
      if (!(speed > 0)) continue;
      ExpectedWall& entry = by_part[parts[node.value]];
      if (entry.nodes == 0 || *time < entry.time) {
        entry.time = *time;
        entry.node = model.mesh.nodes.id[node.value];
      }
      ++entry.nodes;
      entry.speed = std::max(entry.speed, speed);
      entry.wall = wall.id;
      entry.part = parts[node.value] == none<PartIndex> ? 0 : model.part(parts[node.value]).id.value;
    }
    for (const auto& [part, entry] : by_part) list.push_back(entry);
  }
  std::ranges::stable_sort(list, {}, &ExpectedWall::time);
  return list;
}

}  // namespace gapcheck::solver
