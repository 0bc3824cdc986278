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

template <class Visit>
void ConnectedBodies::for_each_mass(std::uint32_t a, std::uint32_t b, const Visit& visit) const {
  const State& state = structure_.state;
  std::vector<bool> seen(start_.bodies.size(), false);
  for (std::uint32_t i = 0; i < root_.size(); ++i) {
    if (root_[i] != a && root_[i] != b) continue;
    if (!state.in_body(i)) {
      visit(state.mass[i], start_.v[i]);
    } else if (!seen[state.body[i]]) {
      seen[state.body[i]] = true;
      visit(start_.bodies[state.body[i]].mass, start_.bodies[state.body[i]].velocity);
    }
  }
}

double ConnectedBodies::mass(std::uint32_t body) const {
  double sum = 0;
  for_each_mass(body, body, [&](double mass, const Vector&) { sum += mass; });
  return sum;
}

bool ConnectedBodies::flies_freely(std::uint32_t body, const Vector& velocity) const {
  const double tolerance = 1e-9 * velocity.norm();
  for (std::uint32_t i = 0; i < root_.size(); ++i) {
    if (root_[i] != body) continue;
    const BodyState* const rigid_body = rigid(NodeIndex{i});
    if (rigid_body != nullptr ? rigid_body->imposed != 0 : structure_.constraints.mask(i) != 0) return false;
    if (!((start_.v[i] - velocity).norm() <= tolerance)) return false;
  }
  return true;
}

struct ConnectedBodies::Frame {
  std::array<std::optional<double>, 3> imposed;
  bool contradicts = false;
  void impose(std::size_t axis, double velocity) {
    if (imposed[axis] && *imposed[axis] != velocity) contradicts = true;
    imposed[axis] = velocity;
  }
};

std::optional<ConnectedBodies::Frame> ConnectedBodies::frame(std::uint32_t a, std::uint32_t b) const {
  Frame frame;
  for (std::uint32_t i = 0; i < root_.size(); ++i) {
    if (root_[i] != a && root_[i] != b) continue;
    const NodeIndex node{i};
    const BodyState* const body = rigid(node);
    const unsigned mask = body != nullptr ? body->imposed : structure_.constraints.mask(i);
    const unsigned moves = mask & all_translations;
    if (mask == 0) continue;
    if (!flight_.steady(node)) return std::nullopt;
    // A turn that is prescribed may do work without end.
    if (body != nullptr && (mask & ~all_translations) != 0 && body->spin != Vector::Zero()) return std::nullopt;
    if (body == nullptr && (mask & ~(unsigned{structure_.constraints.held(i)} | all_translations)) != 0)
      return std::nullopt;
    if (body == nullptr && structure_.constraints.axes(i) != nullptr && moves != 0 && moves != all_translations)
      for (std::size_t axis = 0; axis < 3; ++axis) frame.impose(axis, start_.v[i][static_cast<int>(axis)]);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((moves >> axis & 1u) != 0)
        frame.impose(axis, (body != nullptr ? body->velocity : start_.v[i])[static_cast<int>(axis)]);
    if (frame.contradicts) return std::nullopt;
  }
  return frame;
}

std::optional<double> ConnectedBodies::energy(std::uint32_t a, std::uint32_t b) const {
  const std::optional<Frame> frame_of_both = frame(a, b);
  if (!frame_of_both) return std::nullopt;
  double mass = 0;
  Vector momentum = Vector::Zero();
  for_each_mass(a, b, [&](double m, const Vector& v) {
    mass += m;
    momentum += m * v;
  });
  if (!(mass > 0)) return std::nullopt;
  Vector velocity = momentum / mass;
  for (int axis = 0; axis < 3; ++axis)
    if (const auto& imposed = frame_of_both->imposed[static_cast<std::size_t>(axis)]) velocity[axis] = *imposed;
  double sum = 0;
  for_each_mass(a, b, [&](double m, const Vector& v) { sum += m * (v - velocity).squaredNorm() / 2; });
  std::vector<bool> seen(start_.bodies.size(), false);
  for (std::uint32_t i = 0; i < root_.size(); ++i) {
    if ((root_[i] != a && root_[i] != b) || !structure_.state.in_body(i)) continue;
    const std::uint32_t number = structure_.state.body[i];
    if (!seen[number])
      sum += start_.bodies[number].spin.dot(start_.bodies[number].inertia * start_.bodies[number].spin) / 2;
    seen[number] = true;
  }
  return sum;
}

}  // namespace gapcheck::solver
