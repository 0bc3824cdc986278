#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "solver/condition/condition_builder.hpp"

namespace gapcheck::solver {
namespace {

using JointKind = model::Joint::Kind;

/// The places of a joint's nodes and the bodies that they belong to.
struct JointNodes {
  std::size_t a = 0, b = 0;
  std::array<Vector, 6> x;
};

std::size_t needed_nodes(JointKind kind) {
  if (kind == JointKind::spherical) return 2;
  return kind == JointKind::translational ? 6 : 4;
}

/// The body of one of the nodes; nothing after a failure.
std::optional<std::size_t> body_at(ConditionBuilder& builder, const model::Joint& joint, NodeIndex node) {
  const RigidBodies& rigid = builder.structure.rigid;
  const auto body = rigid.body_of(node.value);
  const auto& known = builder.structure.body_of_id;
  const bool named =
      body && std::any_of(known.begin(), known.end(), [&](const auto& one) { return one.second == *body; });
  if (named && rigid[*body].mass() > 0) return body;
  builder.fail(
      Failure::Kind::contradiction, joint.keyword, joint.place,
      fmt::format("joint {}: node {} belongs to no rigid body with a mass; joints are between rigid bodies: add "
                  "the node to one by *CONSTRAINED_EXTRA_NODES",
                  joint.id, builder.structure.node_id[node.value]));
  return std::nullopt;
}

std::optional<JointNodes> nodes_of(ConditionBuilder& builder, const model::Joint& joint) {
  JointNodes result;
  for (std::size_t k = 0; k < needed_nodes(joint.kind); ++k) {
    const auto node = builder.nodes({joint.nodes[k], false}, joint.keyword, joint.place);
    if (node.empty()) return std::nullopt;
    const auto body = body_at(builder, joint, node[0]);
    if (!body) return std::nullopt;
    std::size_t& side = k % 2 == 0 ? result.a : result.b;
    if (k < 2) side = *body;
    if (side != *body)
      builder.fail(
          Failure::Kind::contradiction, joint.keyword, joint.place,
          fmt::format("joint {}: N1, N3 and N5 must belong to one rigid body, N2, N4 and N6 to another; node {} "
                      "does not",
                      joint.id, joint.nodes[k]));
    result.x[k] = builder.structure.state.x[node[0].value];
  }
  if (result.a == result.b)
    builder.fail(Failure::Kind::contradiction, joint.keyword, joint.place,
                 fmt::format("joint {}: nodes {} and {} belong to the same rigid body", joint.id, joint.nodes[0],
                             joint.nodes[1]));
  if (builder.failed()) return std::nullopt;
  return result;
}

/// The unit vector from one node to another; nothing after a failure.
std::optional<Vector> axis_between(ConditionBuilder& builder, const model::Joint& joint, const JointNodes& nodes,
                                   std::size_t from, std::size_t to) {
  const Vector axis = nodes.x[to] - nodes.x[from];
  if (axis.norm() > 1e-12 * nodes.x[from].norm()) return Vector(axis.normalized());
  builder.fail(Failure::Kind::contradiction, joint.keyword, joint.place,
               fmt::format("joint {}: nodes {} and {} are at one place and give no axis", joint.id, joint.nodes[from],
                           joint.nodes[to]));
  return std::nullopt;
}

/// Pairs that should coincide and do not stay apart as they are.
void name_gaps(ConditionBuilder& builder, const model::Joint& joint, const JointNodes& nodes) {
  const std::size_t pairs = joint.kind == JointKind::spherical || joint.kind == JointKind::universal ? 1
                            : joint.kind == JointKind::translational                                 ? 3
                                                                                                     : 2;
  const double size = (nodes.x[2] - nodes.x[0]).norm();
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    const double gap = (nodes.x[2 * pair] - nodes.x[2 * pair + 1]).norm();
    if (gap > 1e-6 * (pairs > 1 ? size : nodes.x[0].norm() + 1))
      builder.warn(joint.keyword, joint.place,
                   fmt::format("joint {}: nodes {} and {} are {:g} apart and stay so; put them at one place", joint.id,
                               joint.nodes[2 * pair], joint.nodes[2 * pair + 1], gap));
  }
}

/// The rows of a joint: `first` is its axis on A, `second` that on B.
void add_rows(JointKind kind, const JointNodes& nodes, const Vector& first, const Vector& second, RigidJoint& result) {
  const Vector across = kind == JointKind::translational
                            ? Vector((nodes.x[4] - nodes.x[0]) - (nodes.x[4] - nodes.x[0]).dot(first) * first)
                            : Vector(Vector::Zero());
  const Vector u = across.norm() > 0 ? Vector(across.normalized()) : Vector(first.unitOrthogonal());
  const Vector w = first.cross(u);
  const auto along = [&](const Vector& direction) { result.rows.push_back({false, direction, Vector::Zero(), 0}); };
  const auto angle = [&](const Vector& of_a, const Vector& of_b) { result.rows.push_back({true, of_a, of_b, 0}); };
  const bool point = kind == JointKind::spherical || kind == JointKind::revolute || kind == JointKind::universal;
  if (point || kind == JointKind::planar) along(first);
  if (kind != JointKind::planar) {
    along(u);
    along(w);
  }
  if (kind == JointKind::universal) angle(first, second);
  if (kind == JointKind::spherical || kind == JointKind::universal) return;
  angle(u, second);
  angle(w, second);
  if (kind == JointKind::translational) angle(u, second.cross(u).normalized());
}

void apply_joint(ConditionBuilder& builder, const model::Joint& joint) {
  const auto nodes = nodes_of(builder, joint);
  if (!nodes) return;
  Vector first = Vector::UnitX(), second = first;
  if (joint.kind != JointKind::spherical) {
    const auto on_a = axis_between(builder, joint, *nodes, 0, 2), on_b = axis_between(builder, joint, *nodes, 1, 3);
    if (!on_a || !on_b) return;
    first = *on_a;
    second = *on_b;
  }
  if (joint.kind == JointKind::universal && std::abs(first.dot(second)) > 0.999)
    return builder.fail(Failure::Kind::contradiction, joint.keyword, joint.place,
                        fmt::format("joint {}: N1 N3 and N2 N4 are along one line; they must cross", joint.id));
  name_gaps(builder, joint, *nodes);
  RigidBodies& rigid = builder.structure.rigid;
  RigidJoint result;
  result.a = nodes->a;
  result.b = nodes->b;
  result.point_a = nodes->x[0] - rigid[result.a].center();
  result.point_b = nodes->x[1] - rigid[result.b].center();
  add_rows(joint.kind, *nodes, first, second, result);
  rigid.add_joint(std::move(result));
}

}  // namespace

void apply_joints(ConditionBuilder& builder) {
  for (const model::Joint& joint : builder.model.joints) {
    apply_joint(builder, joint);
    if (builder.failed()) return;
  }
}

}  // namespace gapcheck::solver
