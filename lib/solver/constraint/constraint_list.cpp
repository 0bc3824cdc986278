#include "solver/constraint/constraint_list.hpp"

#include <algorithm>
#include <tuple>

namespace gapcheck::solver {

bool ConstraintOrigin::before(const ConstraintOrigin& a, const ConstraintOrigin& b) {
  return std::tie(a.interface, a.pass, a.slot) < std::tie(b.interface, b.pass, b.slot);
}

void ConstraintList::clear() {
  constraints_.clear();
  origins_.clear();
}

void ConstraintList::add(const SurfaceConstraint& constraint, const ConstraintOrigin& origin) {
  constraints_.push_back(constraint);
  origins_.push_back(origin);
}

void ConstraintList::remove_idle() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    if (!(constraints_[i].push > 0)) continue;
    constraints_[kept] = constraints_[i];
    origins_[kept++] = origins_[i];
  }
  constraints_.resize(kept);
  origins_.resize(kept);
}

std::vector<ConstraintOrigin> ConstraintList::sorted_origins() const {
  std::vector<ConstraintOrigin> sorted = origins_;
  std::sort(sorted.begin(), sorted.end(), ConstraintOrigin::before);
  return sorted;
}

void ConstraintList::add_work(const State& state, std::span<ContactState> states) const {
  const double half = state.dt / 2;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const SurfaceConstraint& c = constraints_[i];
    ContactState& result = states[origins_[i].interface];
    const Vector force = c.force(), foot = c.segment.of(state.v), &node = state.v[c.node.value];
    const bool exchanged = origins_[i].pass == 1;
    (exchanged ? result.energy_b : result.energy_a) -= half * force.dot(node);
    (exchanged ? result.energy_a : result.energy_b) += half * force.dot(foot);
    result.friction -= half * c.shear.dot(node - foot);
  }
}

void ConstraintList::add_forces(const std::vector<Vector>& x, Forces& net, Forces& external,
                                std::span<ContactState> states) const {
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    const SurfaceConstraint& c = constraints_[i];
    const Vector force = c.force();
    for (Forces* forces : {&net, &external}) {
      forces->force[c.node.value] += force;
      for (std::size_t k = 0; k < 4; ++k)
        if (c.segment.weights[k] != 0) forces->force[c.segment.nodes[k].value] -= c.segment.weights[k] * force;
    }
    ContactState& result = states[origins_[i].interface];
    const bool exchanged = origins_[i].pass == 1;
    ++result.touching;
    (exchanged ? result.force_b : result.force_a) += force;
    (exchanged ? result.force_a : result.force_b) -= force;
    (exchanged ? result.moment_b : result.moment_a) += x[c.node.value].cross(force);
    (exchanged ? result.moment_a : result.moment_b) -= c.segment.of(x).cross(force);
  }
}

void ConstraintList::add_nodes(std::size_t interface, std::vector<ContactNode>& nodes) const {
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    if (origins_[i].interface != interface) continue;
    const SurfaceConstraint& c = constraints_[i];
    ContactNode& node = nodes.emplace_back();
    node.node = c.node;
    node.segment = c.segment.nodes;
    node.force = c.force();
    node.pressure = origins_[i].area > 0 ? c.push / origins_[i].area : 0;
  }
}

void ConstraintList::add_links(std::size_t interface, std::vector<ContactLink>& links) const {
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    if (origins_[i].interface != interface) continue;
    ContactLink& link = links.emplace_back();
    link.tracked = {{constraints_[i].node}, {1}};
    link.reference = constraints_[i].segment;
    link.exchanged = origins_[i].pass == 1;
    link.force = constraints_[i].force();
  }
}

}  // namespace gapcheck::solver
