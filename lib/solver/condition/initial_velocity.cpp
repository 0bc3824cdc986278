#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "solver/condition/condition_builder.hpp"
#include "solver/element/nodal_mass.hpp"

namespace gapcheck::solver {
namespace {

using model::InitialVelocity;
using VelocityKind = InitialVelocity::Kind;

constexpr std::string_view row_keyword = "INITIAL_VELOCITY_NODE";

/// Which nodes have an initial velocity; a second mark if it also overrides *PART_INERTIA.
struct Given {
  std::vector<bool> node, over_inertia;
};

std::vector<NodeIndex> all_nodes(const model::Model& model) {
  std::vector<NodeIndex> nodes;
  for (std::uint32_t i = 0; i < model.mesh.nodes.size(); ++i) nodes.emplace_back(i);
  return nodes;
}

std::vector<NodeIndex> nodes_of_list(const model::Model& model, const std::vector<PartIndex>& parts) {
  std::vector<bool> wanted(model.parts.size());
  for (const PartIndex part : parts) wanted[part.value] = true;
  return nodes_of_parts(model, wanted);
}

/// Of a part or of a nodal rigid body.
std::vector<NodeIndex> nodes_of_part(ConditionBuilder& builder, const InitialVelocity& initial) {
  const auto part = builder.model.part_of_id.find(initial.id);
  if (part != builder.model.part_of_id.end()) return nodes_of_list(builder.model, {part->second});
  for (const model::RigidGroup& group : builder.model.rigid_groups)
    if (group.kind == model::RigidGroup::Kind::nodal_rigid_body && group.id == initial.id) return group.nodes;
  builder.fail(Failure::Kind::unknown_reference, initial.keyword, initial.place,
               fmt::format("part {} is not defined; define it or remove the velocity", initial.id));
  return {};
}

/// The nodes of a card before its box and its exemptions.
std::vector<NodeIndex> chosen_nodes(ConditionBuilder& builder, const InitialVelocity& initial) {
  if (initial.id == 0) return all_nodes(builder.model);
  const bool part_set = initial.kind == VelocityKind::generation ? initial.target == 1 : initial.irigid == -1;
  const bool part = initial.kind == VelocityKind::generation ? initial.target == 2 : initial.irigid == -2;
  if (part_set) return nodes_of_list(builder.model, builder.part_set(initial.id, initial.keyword, initial.place));
  if (part) return nodes_of_part(builder, initial);
  if (initial.kind == VelocityKind::generation && initial.target != 3) {
    builder.fail(Failure::Kind::not_calculated, initial.keyword, initial.place,
                 fmt::format("STYP {} is not calculated; 1, 2 and 3 are", initial.target));
    return {};
  }
  return builder.nodes({initial.id, true}, initial.keyword, initial.place);
}

/// Removes nodes outside the card's box.
void keep_inside(ConditionBuilder& builder, const InitialVelocity& initial, std::vector<NodeIndex>& nodes) {
  if (initial.box == 0) return;
  const auto box = builder.model.boxes.find(initial.box);
  if (box == builder.model.boxes.end())
    return builder.fail(Failure::Kind::unknown_reference, initial.keyword, initial.place,
                        fmt::format("box {} is not defined; define it or remove the velocity", initial.box));
  std::erase_if(nodes, [&](NodeIndex node) { return !box->second.contains(builder.model.mesh.nodes.x[node.value]); });
}

void set(State& state, Given& given, NodeIndex node, const Vector& velocity, const Vector& spin, bool over_inertia) {
  state.v[node.value] = velocity;
  state.w[node.value] = spin;
  given.node[node.value] = true;
  given.over_inertia[node.value] = over_inertia;
}

/// ω of a generation whose axis runs between two nodes.
Vector generated_spin(ConditionBuilder& builder, const InitialVelocity& initial) {
  if (initial.axis_nodes[0] == 0 && initial.axis_nodes[1] == 0) return initial.spin;
  std::array<Vector, 2> ends;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto node = builder.nodes({initial.axis_nodes[k], false}, initial.keyword, initial.place);
    if (node.empty()) return Vector::Zero();
    ends[k] = builder.model.mesh.nodes.x[node[0].value];
  }
  const Vector axis = ends[1] - ends[0];
  return axis.norm() > 0 ? Vector(initial.rate / axis.norm() * axis) : Vector::Zero();
}

void apply_card(ConditionBuilder& builder, const InitialVelocity& initial, Given& given) {
  builder.refuse_system(initial.system, initial.keyword, initial.place);
  if (builder.relaxing && initial.kind == VelocityKind::generation && initial.phase == 0)
    builder.fail(Failure::Kind::not_calculated, initial.keyword, initial.place,
                 "velocities that begin with the dynamic relaxation (PHASE = 0) are not calculated; set PHASE to 1, "
                 "with which they begin after it");
  if (initial.phase == 1 && !builder.relaxing)
    builder.warn(initial.keyword, initial.place, "there is no dynamic relaxation before the run; PHASE 1 is as 0");
  std::vector<NodeIndex> nodes = chosen_nodes(builder, initial);
  keep_inside(builder, initial, nodes);
  State& state = builder.structure.state;
  const bool over = initial.irigid != 0;
  if (initial.kind == VelocityKind::generation) {
    const Vector spin = generated_spin(builder, initial);
    if (!builder.failed() && spin == Vector::Zero() && initial.rate != 0)
      builder.fail(Failure::Kind::contradiction, initial.keyword, initial.place,
                   "OMEGA is given without an axis; give NX, NY and NZ");
    for (const NodeIndex node : nodes)
      set(state, given, node, initial.velocity + spin.cross(state.x[node.value] - initial.origin), spin, over);
    return;
  }
  std::vector<NodeIndex> exempted;
  if (initial.exempted_set > 0) exempted = builder.nodes({initial.exempted_set, true}, initial.keyword, initial.place);
  std::vector<bool> is_exempted(state.x.size());
  for (const NodeIndex node : exempted) is_exempted[node.value] = true;
  for (const NodeIndex node : nodes) {
    if (is_exempted[node.value])
      set(state, given, node, initial.exempted_velocity, initial.exempted_spin, over);
    else
      set(state, given, node, initial.velocity, initial.spin, over);
  }
}

/// The rigid motion nearest to the velocities of some nodes, weighted with their masses: momentum over mass, angular
/// momentum over inertia of these nodes. About axes on which all of them lie, the mean of their angular velocities.
struct Fit {
  double mass = 0;
  Vector center = Vector::Zero(), velocity = Vector::Zero(), spin = Vector::Zero();
};

Fit fit(const State& state, const std::vector<NodeIndex>& nodes, const std::vector<double>& weights) {
  Fit result;
  Vector mean_spin = Vector::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    result.mass += weights[i];
    result.center += weights[i] * state.x[nodes[i].value];
    result.velocity += weights[i] * state.v[nodes[i].value];
    mean_spin += weights[i] * state.w[nodes[i].value];
  }
  result.center /= result.mass;
  result.velocity /= result.mass;
  mean_spin /= result.mass;
  Matrix inertia = Matrix::Zero();
  Vector momentum = Vector::Zero();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vector r = state.x[nodes[i].value] - result.center;
    inertia += weights[i] * (r.squaredNorm() * Matrix::Identity() - r * r.transpose());
    momentum += weights[i] * r.cross(state.v[nodes[i].value] - result.velocity);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> axes(inertia);
  for (int k = 0; k < 3; ++k) {
    const Vector axis = axes.eigenvectors().col(k);
    const bool turns = axes.eigenvalues()[k] > 1e-9 * axes.eigenvalues()[2];
    result.spin += (turns ? axis.dot(momentum) / axes.eigenvalues()[k] : axis.dot(mean_spin)) * axis;
  }
  return result;
}

/// Rigid bodies take part in the velocities of their nodes.
void move_bodies(ConditionBuilder& builder, const Given& given) {
  Structure& structure = builder.structure;
  State& state = structure.state;
  if (structure.rigid.size() == 0) return;
  std::vector<bool> rigid_parts(builder.model.parts.size());
  for (std::uint32_t i = 0; i < rigid_parts.size(); ++i) rigid_parts[i] = builder.model.rigid(PartIndex{i});
  const std::vector<double> masses = nodal_masses(builder.model, rigid_parts);
  const std::vector<BodyProperties> properties = body_properties(builder.model, structure);
  for (std::size_t body = 0; body < structure.rigid.size(); ++body) {
    const model::BodyInertia* inertia = properties[body].inertia;
    std::vector<NodeIndex> nodes;
    std::vector<double> weights;
    bool ignored = false;
    for (const NodeIndex node : structure.rigid.nodes(body)) {
      if (!given.node[node.value]) continue;
      if (inertia != nullptr && !given.over_inertia[node.value]) {
        ignored = true;
        continue;
      }
      nodes.push_back(node);
      weights.push_back(masses[node.value] + state.mass[node.value]);
    }
    if (inertia != nullptr && nodes.empty()) {
      if (ignored)
        builder.warn(properties[body].keyword, properties[body].place,
                     "its velocities go over those of the nodes; IRIGID = 1 turns that round");
      structure.rigid.set_motion(body, inertia->velocity, inertia->spin, state);
    }
    if (nodes.empty()) continue;
    if (std::none_of(weights.begin(), weights.end(), [](double weight) { return weight > 0; }))
      weights.assign(weights.size(), 1);
    const Fit motion = fit(state, nodes, weights);
    const Vector velocity = motion.velocity + motion.spin.cross(structure.rigid[body].center() - motion.center);
    structure.rigid.set_motion(body, velocity, motion.spin, state);
  }
}

void apply_rows(ConditionBuilder& builder, Given& given) {
  for (const model::NodeVelocity& row : builder.model.node_velocities) {
    builder.refuse_system(row.system, row_keyword, row.place);
    const auto node = builder.model.mesh.nodes.lookup.find(row.node);
    if (!node)
      builder.fail(Failure::Kind::unknown_reference, row_keyword, row.place,
                   fmt::format("node {} is not defined; define it or remove the velocity", row.node));
    if (builder.failed()) return;
    set(builder.structure.state, given, NodeIndex{*node}, row.velocity, row.spin, false);
  }
}

}  // namespace

void apply_initial_velocities(ConditionBuilder& builder) {
  const std::size_t nodes = builder.structure.state.x.size();
  Given given{std::vector<bool>(nodes), std::vector<bool>(nodes)};
  for (const VelocityKind kind : {VelocityKind::general, VelocityKind::generation})
    for (const InitialVelocity& initial : builder.model.initial_velocities)
      if (initial.kind == kind && !builder.failed()) apply_card(builder, initial, given);
  if (!builder.failed()) apply_rows(builder, given);
  if (builder.failed()) return;
  move_bodies(builder, given);
  for (const InitialVelocity& initial : builder.model.initial_velocities) {
    if (initial.kind != VelocityKind::rigid_body) continue;
    builder.refuse_system(initial.system, initial.keyword, initial.place);
    const auto body = builder.body(initial.id, initial.keyword, initial.place);
    if (builder.failed()) return;
    builder.structure.rigid.set_motion(*body, initial.velocity, initial.spin, builder.structure.state);
  }
}

}  // namespace gapcheck::solver
