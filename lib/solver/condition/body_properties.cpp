#include <fmt/format.h>

#include <cmath>

#include "solver/condition/condition_builder.hpp"

namespace gapcheck::solver {
namespace {

using GroupKind = model::RigidGroup::Kind;

/// Parts led by another one, by *CONSTRAINED_RIGID_BODIES.
std::vector<bool> led_parts(const model::Model& model) {
  std::vector<bool> led(model.parts.size());
  for (const model::RigidGroup& group : model.rigid_groups)
    for (std::size_t i = 1; group.kind == GroupKind::merged_parts && i < group.parts.size(); ++i)
      led[group.parts[i].value] = true;
  return led;
}

/// The masses of deformable neighbours and *ELEMENT_MASS on a body's nodes are added to the given ones.
void set_mass(Structure& structure, std::size_t body, const model::BodyInertia& inertia, const Vector& center) {
  const State& state = structure.state;
  double mass = inertia.mass;
  Vector sum = inertia.mass * center;
  for (const NodeIndex node : structure.rigid.nodes(body)) {
    mass += state.mass[node.value];
    sum += state.mass[node.value] * state.x[node.value];
  }
  const Vector middle = sum / mass;
  const auto spread = [&](double part, const Vector& x) {
    const Vector r = x - middle;
    return Matrix(part * (r.squaredNorm() * Matrix::Identity() - r * r.transpose()));
  };
  Matrix tensor = inertia.tensor + spread(inertia.mass, center);
  for (const NodeIndex node : structure.rigid.nodes(body))
    tensor += spread(state.mass[node.value], state.x[node.value]) + state.inertia[node.value] * Matrix::Identity();
  structure.rigid.set_mass(body, mass, middle, tensor, state);
}

void apply_inertia(ConditionBuilder& builder, std::size_t body, const BodyProperties& properties) {
  const model::BodyInertia& inertia = *properties.inertia;
  builder.refuse_system(inertia.system, properties.keyword, properties.place);
  Vector center = inertia.center;
  if (inertia.center_node > 0) {
    const auto node = builder.nodes({inertia.center_node, false}, properties.keyword, properties.place);
    if (!node.empty()) center = builder.model.mesh.nodes.x[node[0].value];
  }
  if (!(inertia.mass > 0) || !std::isfinite(inertia.mass) || !inertia.tensor.allFinite() || !center.allFinite() ||
      !(inertia.tensor.diagonal().minCoeff() > 0))
    builder.fail(Failure::Kind::zero_mass, properties.keyword, properties.place,
                 "mass and inertias about the three axes must be numbers above zero");
  if (!builder.failed()) set_mass(builder.structure, body, inertia, center);
}

void apply_constraint(ConditionBuilder& builder, std::size_t body, const BodyProperties& properties) {
  const model::BodyConstraint& constraint = properties.constraint;
  if (constraint.cmo < 0)
    builder.fail(Failure::Kind::not_calculated, properties.keyword, properties.place,
                 "constraints in a local system (CMO = -1) are not calculated; give them in the global one (CMO = 1)");
  if (!(constraint.cmo > 0)) return;
  builder.structure.rigid.hold(body, model::freedoms_of_code(constraint.translations) |
                                         static_cast<unsigned>(model::freedoms_of_code(constraint.rotations)) << 3);
}

/// A node belongs to only one body.
void check_membership(ConditionBuilder& builder, const std::vector<NodeIndex>& nodes, std::size_t body,
                      std::string_view keyword, model::Place place) {
  const Structure& structure = builder.structure;
  for (const NodeIndex node : nodes)
    if (structure.rigid.body_of(node.value) != body)
      return builder.fail(Failure::Kind::contradiction, keyword, place,
                          fmt::format("node {} belongs to another rigid body already; take it out of one or merge the "
                                      "bodies with *CONSTRAINED_RIGID_BODIES",
                                      structure.node_id[node.value]));
}

template <std::size_t N>
void check_elements(ConditionBuilder& builder, const model::Elements<N>& elements) {
  const model::Model& model = builder.model;
  for (std::size_t i = 0; i < elements.size() && !builder.failed(); ++i) {
    if (!model.rigid(elements.part[i])) continue;
    const model::Part& part = model.part(elements.part[i]);
    const auto body = builder.structure.body_of_id.find(part.id.value);
    if (body == builder.structure.body_of_id.end()) continue;
    check_membership(builder, {elements.nodes[i].begin(), elements.nodes[i].end()}, body->second, "PART", part.place);
  }
}

void check_bodies(ConditionBuilder& builder) {
  const model::Model& model = builder.model;
  check_elements(builder, model.mesh.shells);
  check_elements(builder, model.mesh.solids);
  for (const model::RigidGroup& group : model.rigid_groups) {
    const std::int64_t id = group.kind == GroupKind::nodal_rigid_body || group.parts.empty()
                                ? group.id
                                : model.part(group.parts[0]).id.value;
    const auto body = builder.structure.body_of_id.find(id);
    if (group.kind == GroupKind::merged_parts || body == builder.structure.body_of_id.end()) continue;
    check_membership(builder, group.nodes, body->second,
                     group.kind == GroupKind::extra_nodes ? "CONSTRAINED_EXTRA_NODES" : "CONSTRAINED_NODAL_RIGID_BODY",
                     group.place);
  }
}

}  // namespace

std::vector<BodyProperties> body_properties(const model::Model& model, const Structure& structure) {
  std::vector<BodyProperties> properties(structure.rigid.size());
  const std::vector<bool> led = led_parts(model);
  // Last come the leading parts, the first of them at the very end.
  for (const bool leading : {false, true})
    for (std::size_t i = model.parts.size(); i-- > 0;) {
      const model::Part& part = model.parts[i];
      const auto body = structure.body_of_id.find(part.id.value);
      if (led[i] == leading || body == structure.body_of_id.end() || !part.material) continue;
      const bool inertia = part.inertia.has_value();
      const model::Material& material = model.materials[*part.material];
      properties[body->second] = {material.constraint, inertia ? &*part.inertia : nullptr,
                                  inertia ? "PART_INERTIA" : "MAT_RIGID", inertia ? part.place : material.place};
    }
  for (const model::RigidGroup& group : model.rigid_groups) {
    const auto body = structure.body_of_id.find(group.id);
    if (group.kind == GroupKind::nodal_rigid_body && body != structure.body_of_id.end())
      properties[body->second] = {group.constraint, group.inertia ? &*group.inertia : nullptr,
                                  "CONSTRAINED_NODAL_RIGID_BODY", group.place};
  }
  return properties;
}

void apply_body_properties(ConditionBuilder& builder) {
  check_bodies(builder);
  const std::vector<BodyProperties> properties = body_properties(builder.model, builder.structure);
  for (std::size_t body = 0; body < properties.size() && !builder.failed(); ++body) {
    if (properties[body].inertia != nullptr) apply_inertia(builder, body, properties[body]);
    if (!builder.failed()) apply_constraint(builder, body, properties[body]);
  }
}

}  // namespace gapcheck::solver
