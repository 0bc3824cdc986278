#include "solver/build/build_rigid.hpp"

#include "base/union_find.hpp"

namespace gapcheck::solver {
namespace {

using GroupKind = model::RigidGroup::Kind;

/// For every part the first part of those that it is merged with.
std::vector<std::uint32_t> merged_parts(const model::Model& model) {
  UnionFind merged(model.parts.size());
  for (const model::RigidGroup& group : model.rigid_groups)
    if (group.kind == GroupKind::merged_parts)
      for (const PartIndex part : group.parts) merged.unite(group.parts[0].value, part.value);
  std::vector<std::uint32_t> lead(model.parts.size());
  for (std::uint32_t part = 0; part < lead.size(); ++part) lead[part] = merged.root(part);
  return lead;
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void build_rigid_bodies(const model::Model& model, std::vector<RigidPart> parts, Structure& structure) {
  structure.rigid.resize(structure.state.x.size());
  for (const model::RigidGroup& group : model.rigid_groups)
    if (group.kind == GroupKind::extra_nodes && !group.parts.empty() && model.rigid(group.parts[0]))
      append(parts[group.parts[0].value].nodes, group.nodes);
  const std::vector<std::uint32_t> lead = merged_parts(model);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (lead[i] == i) continue;
    append(parts[lead[i]].points, parts[i].points);
    append(parts[lead[i]].nodes, parts[i].nodes);
    parts[i] = {};
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].nodes.empty()) continue;
    const std::size_t body = structure.rigid.add(std::move(parts[i].points), parts[i].nodes, structure.state);
    for (std::size_t other = 0; other < parts.size(); ++other)
      if (lead[other] == i) structure.body_of_id.emplace(model.parts[other].id.value, body);
  }
  for (const model::RigidGroup& group : model.rigid_groups)
    if (group.kind == GroupKind::nodal_rigid_body && !group.nodes.empty())
      structure.body_of_id.emplace(group.id, structure.rigid.add({}, group.nodes, structure.state));
}

}  // namespace gapcheck::solver
