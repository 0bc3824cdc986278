#include "solver/output/boundary_work.hpp"

#include <algorithm>

#include "solver/output/body_states.hpp"

namespace gapcheck::solver {
namespace {

using results::BoundaryKind;

std::vector<NodeIndex> chosen_nodes(const model::Model& model, const model::NodeChoice& choice) {
  if (choice.set) {
    const auto set = model.sets.nodes.find(choice.id);
    return set == model.sets.nodes.end() ? std::vector<NodeIndex>() : set->second.members;
  }
  const auto node = model.mesh.nodes.lookup.find(choice.id);
  return node ? std::vector<NodeIndex>{NodeIndex{*node}} : std::vector<NodeIndex>();
}

/// The components of a node's reaction in these degrees of freedom, in global axes.
std::array<Vector, 2> part_of_reaction(const Run& run, std::uint32_t node, unsigned freedoms) {
  const Matrix* axes = run.stepper().structure().constraints.axes(node);
  std::array<Vector, 2> reaction = run.stepper().reaction(node);
  for (std::size_t kind = 0; kind < 2; ++kind) {
    Vector& whole = reaction[kind];
    if (axes != nullptr) whole = axes->transpose() * whole;
    for (int axis = 0; axis < 3; ++axis)
      if ((freedoms >> (3 * kind + static_cast<std::size_t>(axis)) & 1u) == 0) whole[axis] = 0;
    if (axes != nullptr) whole = *axes * whole;
  }
  return reaction;
}

}  // namespace

HeldFreedoms::HeldFreedoms(const Run& run) : held(run.model().mesh.nodes.size(), 0) {
  const model::Model& model = run.model();
  const RigidBodies& rigid = run.stepper().structure().rigid;
  std::vector<std::int64_t> system_of(held.size(), 0);
  for (const model::SinglePointConstraint& spc : model.spcs)
    for (const NodeIndex node : chosen_nodes(model, spc.nodes)) {
      if (rigid.holds(node.value)) continue;
      held[node.value] |= spc.freedoms;
      system_of[node.value] = spc.system;
      nodes.push_back(node.value);
    }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  for (const std::uint32_t node : nodes) {
    supports.push_back(held[node]);
    systems.push_back(system_of[node]);
  }
  for (const model::NodeConstraint& constraint : model.node_constraints)
    for (const NodeIndex node : constraint.nodes) held[node.value] |= constraint.freedoms;
}

results::SupportStates support_states(const Run& run, const HeldFreedoms& held) {
  results::SupportStates states;
  for (std::size_t k = 0; k < held.nodes.size(); ++k) {
    const auto [force, moment] = part_of_reaction(run, held.nodes[k], held.supports[k]);
    results::SupportState state;
    state.node = run.model().mesh.nodes.id[held.nodes[k]];
    state.translation = (held.supports[k] & 7u) != 0;
    state.rotation = held.supports[k] >> 3 != 0;
    const auto system = run.model().systems.find(held.systems[k]);
    const Matrix axes = held.systems[k] != 0 && system != run.model().systems.end() ? Matrix(system->second.axes)
                                                                                    : Matrix(Matrix::Identity());
    state.force = axes.transpose() * force;
    state.moment = axes.transpose() * moment;
    states.resultant += force;
    states.supports.push_back(state);
  }
  return states;
}

BoundaryWork::BoundaryWork(const Run& run, const HeldFreedoms& held) : held_(held.held) {
  const Run::Conditions& conditions = run.conditions();
  if (conditions.loads != nullptr) {
    add(BoundaryKind::discrete, false, conditions.loads->targets(false), run);
    add(BoundaryKind::discrete, true, conditions.loads->targets(true), run);
  }
  if (conditions.pressures != nullptr) add(BoundaryKind::pressure, false, conditions.pressures->nodes(), run);
  std::vector<std::uint32_t> moved;
  for (const model::PrescribedMotion& motion : run.model().prescribed_motions)
    if (!motion.rigid)
      for (const NodeIndex node : chosen_nodes(run.model(), motion.nodes)) moved.push_back(node.value);
  std::sort(moved.begin(), moved.end());
  moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
  add(BoundaryKind::velocity, false, moved, run);
  std::vector<std::uint32_t> bodies;
  const RigidBodies& rigid = run.stepper().structure().rigid;
  for (std::uint32_t body = 0; body < rigid.size(); ++body)
    if (!rigid.motions(body).empty()) bodies.push_back(body);
  add(BoundaryKind::velocity, true, bodies, run);
}

void BoundaryWork::add(BoundaryKind kind, bool body, const std::vector<std::uint32_t>& targets, const Run& run) {
  const std::vector<ListedBody> listed = body ? listed_bodies(run) : std::vector<ListedBody>();
  for (const std::uint32_t target : targets) {
    Entry entry;
    entry.target = target;
    entry.state.kind = kind;
    entry.state.body = body;
    if (!body) entry.state.id = run.model().mesh.nodes.id[target];
    for (const ListedBody& one : listed)
      if (one.body == target) entry.state.id = one.id;
    entries_.push_back(entry);
  }
}

/// The forces and moments of an entry now.
void BoundaryWork::load(const Run& run, Entry& entry, const Forces& loads, const Forces& pressures) const {
  results::BoundaryState& state = entry.state;
  const RigidBodies& rigid = run.stepper().structure().rigid;
  if (state.kind == BoundaryKind::velocity && !state.body) {
    const auto freedoms = static_cast<unsigned>(~held_[entry.target]) & 63u;
    const auto [force, moment] = part_of_reaction(run, entry.target, freedoms);
    state.force = force;
    entry.turn = moment;
  } else if (state.kind == BoundaryKind::velocity) {
    const RigidBodies::Response& response = rigid.response(entry.target);
    state.force = state.moment = Vector::Zero();
    for (const auto& [freedom, motion] : rigid.motions(entry.target)) {
      const auto axis = static_cast<Eigen::Index>(freedom % 3);
      (freedom < 3 ? state.force : state.moment)[axis] =
          (freedom < 3 ? response.reaction : response.reaction_moment)[axis];
    }
    entry.turn = state.moment;
  } else {
    const Forces& from = state.kind == BoundaryKind::discrete ? loads : pressures;
    state.force = (state.body ? from.body_force : from.force)[entry.target];
    entry.turn = (state.body ? from.body_moment : from.moment)[entry.target];
  }
}

void BoundaryWork::advance(const Run& run) {
  if (entries_.empty()) return;
  const State& state = run.stepper().state();
  const RigidBodies& rigid = run.stepper().structure().rigid;
  Forces loads, pressures;
  if (run.conditions().loads != nullptr) {
    loads.resize(state.x.size(), rigid.size());
    run.conditions().loads->add_at(state, loads);
  }
  if (run.conditions().pressures != nullptr) {
    pressures.resize(state.x.size(), rigid.size());
    run.conditions().pressures->add_at(state, pressures);
  }
  for (Entry& entry : entries_) {
    const Vector force = entry.state.force, turn = entry.turn;
    load(run, entry, loads, pressures);
    const bool carried = !entry.state.body && rigid.holds(entry.target);
    // Nodes of rigid bodies have the velocity of the step that ended here.
    if (carried) entry.velocity = state.v[entry.target];
    if (carried) entry.spin = state.w[entry.target];
    entry.state.energy +=
        state.dt / 2 * ((force + entry.state.force).dot(entry.velocity) + (turn + entry.turn).dot(entry.spin));
    entry.velocity = entry.state.body ? rigid[entry.target].velocity() : state.v[entry.target];
    entry.spin = entry.state.body ? rigid[entry.target].angular_velocity() : state.w[entry.target];
  }
}

std::vector<results::BoundaryState> BoundaryWork::states() const {
  std::vector<results::BoundaryState> list;
  for (const Entry& entry : entries_) list.push_back(entry.state);
  return list;
}

}  // namespace gapcheck::solver
