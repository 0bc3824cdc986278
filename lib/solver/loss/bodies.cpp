#include "solver/loss/bodies.hpp"

#include <algorithm>
#include <map>

namespace gapcheck::solver {
namespace {

constexpr unsigned all_freedoms = 63, all_translations = 7;

template <class Elements, class Visit>
void for_each_element(const Elements& elements, const Visit& visit) {
  for (std::size_t i = 0; i < elements.size(); ++i) visit(elements.nodes[i], elements.part[i]);
}

/// Calls visit(nodes, part) for all elements that connect nodes.
template <class Visit>
void for_each_connection(const model::Mesh& mesh, const Visit& visit) {
  for_each_element(mesh.shells, visit);
  for_each_element(mesh.solids, visit);
  for_each_element(mesh.thick_shells, visit);
  for_each_element(mesh.beams, visit);
  for_each_element(mesh.discrete, visit);
}

}  // namespace

ConnectedBodies::ConnectedBodies(const model::Model& model, const Structure& structure,
                                 const contact::InitialState& initial, const StartMotion& start, const Flight& flight)
    : structure_(structure), start_(start), flight_(flight) {
  connect(model, initial);
  sum_up();
}

void ConnectedBodies::connect(const model::Model& model, const contact::InitialState& initial) {
  const State& state = structure_.state;
  UnionFind sets(state.x.size());
  // Elements of one rigid body do not deform.
  const auto deforms = [&](const auto& nodes) {
    return !std::ranges::all_of(nodes, [&](NodeIndex n) {
      return n != none<NodeIndex> && state.in_body(n.value) && state.body[n.value] == state.body[nodes[0].value];
    });
  };
  std::vector<bool> deformed(state.x.size(), false);
  for_each_connection(model.mesh, [&](const auto& nodes, PartIndex) {
    const bool changes = deforms(nodes);
    for (const NodeIndex node : nodes) {
      if (node == none<NodeIndex>) continue;
      sets.unite(nodes[0].value, node.value);
      if (changes) deformed[node.value] = true;
    }
  });
  for (std::size_t body = 0; body < structure_.rigid.size(); ++body) {
    const std::vector<NodeIndex>& nodes = structure_.rigid.nodes(body);
    for (const NodeIndex node : nodes) sets.unite(nodes[0].value, node.value);
  }
  for (const RigidJoint& joint : structure_.rigid.joints()) {
    const std::vector<NodeIndex>&a = structure_.rigid.nodes(joint.a), &b = structure_.rigid.nodes(joint.b);
    if (a.empty() || b.empty()) continue;
    sets.unite(a[0].value, b[0].value);
    deformed[a[0].value] = true;
  }
  connect_ties(model, initial, sets);
  for (const contact::JudgedNode& tie : initial.judged)
    if (tie.tied()) deformed[tie.node.value] = true;
  // Constraints between any nodes: rather one body too large than one too small.
  if (!model.interpolations.empty() || !model.joints.empty() || !model.node_constraints.empty())
    for (std::uint32_t i = 0; i < sets.size(); ++i) {
      sets.unite(0, i);
      deformed[i] = true;
    }
  root_.resize(sets.size());
  attached_.assign(sets.size(), false);
  for (std::uint32_t i = 0; i < sets.size(); ++i) {
    root_[i] = sets.root(i);
    if (deformed[i]) attached_[root_[i]] = true;
  }
}

void ConnectedBodies::connect_ties(const model::Model& model, const contact::InitialState& initial, UnionFind& sets) {
  // A tie holds on to a part: rather to all of it than to too little.
  std::map<PartIndex, NodeIndex> tied;
  for (const contact::JudgedNode& tie : initial.judged) {
    if (!tie.tied()) continue;
    const auto [at, added] = tied.try_emplace(tie.segment_part, tie.node);
    sets.unite(at->second.value, tie.node.value);
  }
  if (tied.empty()) return;
  for_each_connection(model.mesh, [&](const auto& nodes, PartIndex part) {
    if (const auto at = tied.find(part); at != tied.end()) sets.unite(at->second.value, nodes[0].value);
  });
}

ConnectedBodies::Kind ConnectedBodies::kind(std::span<const NodeIndex> nodes) const {
  const auto fixed = [&](NodeIndex node) {
    if (const BodyState* const body = rigid(node)) return (body->imposed & all_freedoms) == all_freedoms;
    return (structure_.constraints.mask(node.value) & all_translations) == all_translations;
  };
  if (std::ranges::all_of(nodes, fixed)) return Kind::fixed;
  if (std::ranges::any_of(nodes, fixed) || attached_[of(nodes.front())]) return Kind::elastic;
  if (rigid(nodes.front()) != nullptr) return Kind::rigid;
  // What is not attached to anything is a single node; held in part it would be guided.
  return structure_.constraints.mask(nodes.front().value) == 0 ? Kind::point : Kind::elastic;
}

double ConnectedBodies::mobility(NodeIndex node, const Vector& direction) const {
  if (const BodyState* const body = rigid(node)) return direction.cwiseAbs2().dot(body->push_response);
  const double mass = structure_.state.mass[node.value];
  return mass > 0 ? 1 / mass : 0;
}

void ConnectedBodies::sum_up() {
  const State& state = structure_.state;
  sums_.resize(root_.size());
  std::vector<bool> seen(start_.bodies.size(), false);
  for (std::uint32_t i = 0; i < root_.size(); ++i) {
    Sums& sums = sums_[root_[i]];
    sums.velocities.add(start_.v[i]);
    add_frame(NodeIndex{i}, sums);
    if (!state.in_body(i)) {
      sums.add(state.mass[i], start_.v[i]);
    } else if (const std::uint32_t number = state.body[i]; !seen[number]) {
      seen[number] = true;
      const BodyState& body = start_.bodies[number];
      sums.add(body.mass, body.velocity);
      sums.kinetic += body.spin.dot(body.inertia * body.spin) / 2;
    }
  }
}

void ConnectedBodies::add_frame(NodeIndex node, Sums& sums) const {
  const BodyState* const body = rigid(node);
  const Constraints& constraints = structure_.constraints;
  const unsigned mask = body != nullptr ? body->imposed : constraints.mask(node.value), moves = mask & all_translations;
  if (mask == 0) return;
  sums.free = false;
  Frame& frame = sums.frame;
  if (!flight_.steady(node)) frame.none = true;
  // A turn that is prescribed may do work without end.
  const unsigned turns = mask & ~all_translations;
  if (body != nullptr ? turns != 0 && body->spin != Vector::Zero()
                      : (turns & ~unsigned{constraints.held(node.value)}) != 0)
    frame.none = true;
  const Vector& velocity = body != nullptr ? body->velocity : start_.v[node.value];
  // Conditions in other axes than the global ones: the frame moves with the node.
  const bool turned = body == nullptr && constraints.axes(node.value) != nullptr && moves != 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (turned || (moves >> axis & 1u) != 0) frame.impose(axis, velocity[static_cast<int>(axis)]);
}

bool ConnectedBodies::flies_freely(std::uint32_t body, const Vector& velocity) const {
  const Sums& sums = sums_[body];
  const double tolerance = 1e-9 * velocity.norm();
  return sums.free && ((sums.velocities.low - velocity).cwiseAbs().array() <= tolerance).all() &&
         ((sums.velocities.high - velocity).cwiseAbs().array() <= tolerance).all();
}

std::optional<double> ConnectedBodies::energy(std::uint32_t a, std::uint32_t b) const {
  Sums both = sums_[a];
  if (b != a) {
    const Sums& other = sums_[b];
    both.mass += other.mass;
    both.kinetic += other.kinetic;
    both.momentum += other.momentum;
    both.frame.none = both.frame.none || other.frame.none;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (other.frame.imposed[axis]) both.frame.impose(axis, *other.frame.imposed[axis]);
  }
  if (both.frame.none || !(both.mass > 0)) return std::nullopt;
  Vector velocity = both.momentum / both.mass;
  for (int axis = 0; axis < 3; ++axis)
    if (const auto& imposed = both.frame.imposed[static_cast<std::size_t>(axis)]) velocity[axis] = *imposed;
  // Sums of squares leave some of the largest one by rounding.
  const double moved = both.mass * velocity.squaredNorm() / 2, rounding = 1e-14 * (both.kinetic + moved);
  return std::max(0.0, both.kinetic - velocity.dot(both.momentum) + moved) + rounding;
}

}  // namespace gapcheck::solver
