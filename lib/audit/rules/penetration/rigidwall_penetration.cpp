#include <fmt/format.h>

#include "audit/members.hpp"
#include "audit/rules.hpp"
#include "audit/shared/mesh_finding.hpp"
#include "contact/rigid_wall.hpp"

namespace gapcheck::audit::rule::rigidwall_penetration {
namespace {

std::string wall_name(const model::RigidWall& wall) {
  return wall.title.empty() ? fmt::format("rigid wall {}", wall.id)
                            : fmt::format("rigid wall {} \"{}\"", wall.id, wall.title);
}

void check(const RuleIdentity& rule, Context& context, Report& report, contact::WallNodes& wall_nodes,
           std::size_t position) {
  const model::Model& model = context.model();
  const model::RigidWall& wall = model.rigid_walls[position];
  const std::vector<NodeIndex> nodes = wall_nodes.of(wall);
  const std::vector<Vector>& x = model.mesh.nodes.x;
  std::vector<Found> found = find_all(nodes.size(), [&](std::size_t i, std::vector<Found>& list) {
    if (const auto in = contact::wall_penetration(wall, x[nodes[i].value]))
      list.push_back({static_cast<std::int64_t>(position), in->depth, nodes[i].value});
  });
  add_grouped(
      report, std::move(found),
      [&](const Found& f) {
        const NodeIndex node{static_cast<std::uint32_t>(f.item)};
        const auto in = contact::wall_penetration(wall, x[node.value]);
        Finding finding =
            node_finding(rule, context, node,
                         fmt::format("node {} is {:.6g} deep in {}; move the wall or the node, or exempt the node "
                                     "(NSIDEX)",
                                     model.mesh.nodes.id[node.value], f.weight, wall_name(wall)));
        finding.penetration = f.weight;
        if (in) finding.point = in->surface;
        return finding;
      },
      [&](const Found& f, std::uint64_t count) {
        Finding finding = audit::finding(
            rule, fmt::format("{} more nodes are in {}, up to {:.6g} deep", count, wall_name(wall), f.weight),
            context.path(wall.place.file), wall.place.line);
        finding.penetration = f.weight;
        return finding;
      },
      collect_nodes(context, [](const Found& f) { return NodeIndex{static_cast<std::uint32_t>(f.item)}; }));
}

void run(const RuleIdentity& rule, Context& context, Report& report) {
  const auto& walls = context.model().rigid_walls;
  if (walls.empty()) return;
  contact::WallNodes nodes(context.model());
  std::size_t unborn = 0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (walls[i].birth > 0)
      ++unborn;
    else
      check(rule, context, report, nodes, i);
  }
  if (unborn > 0) context.skipped(rule, fmt::format("{} rigid walls that are born later", unborn));
}

}  // namespace

const Rule definition{
    {"GC110", "rigidwall-penetration", Severity::warning, "a node lies behind or in a rigid wall that is to stop it",
     Need::model, "The wall throws the nodes out in the first step, or never stops them"},
    run};

}  // namespace gapcheck::audit::rule::rigidwall_penetration
