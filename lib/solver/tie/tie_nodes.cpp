#include "solver/tie/tie_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace gapcheck::solver {

bool has_mass(double mass) { return mass > 0 && std::isfinite(1 / mass); }

void TieNodes::start(const std::vector<Tie>& ties, std::size_t count) {
  for (const Tie& tie : ties) {
    used_.push_back(tie.node);
    used_.insert(used_.end(), tie.point.nodes.begin(), tie.point.nodes.end());
  }
  std::sort(used_.begin(), used_.end());
  used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
  if (used_.empty()) return;
  mobility_.assign(6 * count, 0);
  for (std::vector<Vector>* vectors : {&free_v_, &free_w_, &v_, &w_}) vectors->assign(count, Vector::Zero());
}

bool TieNodes::hold(const Structure& structure, double time, double next) {
  const bool first = held_.empty();
  held_.resize(used_.size(), 0);
  bool changed = first;
  const State& state = structure.state;
  for (std::size_t i = 0; i < used_.size(); ++i) {
    const std::uint32_t n = used_[i].value;
    const std::uint8_t mask = structure.constraints.mask(n, time, next);
    if (!first && mask == held_[i]) continue;
    changed = true;
    held_[i] = mask;
    for (unsigned freedom = 0; freedom < 6; ++freedom) {
      const double mass = freedom < 3 ? state.mass[n] : state.inertia[n];
      mobility_[6 * n + freedom] = (mask >> freedom & 1u) != 0 || !has_mass(mass) ? 0 : 1 / mass;
    }
  }
  return changed;
}

void TieNodes::let_free(const Structure& structure, double mean, double next, const Forces& net) {
  const State& state = structure.state;
  for (std::size_t i = 0; i < used_.size(); ++i) {
    const std::uint32_t n = used_[i].value;
    for (unsigned freedom = 0; freedom < 6; ++freedom) {
      const int axis = static_cast<int>(freedom % 3);
      const bool rotation = freedom >= 3;
      const double before = (rotation ? state.w : state.v)[n][axis];
      const double push = (rotation ? net.moment : net.force)[n][axis] * mean * mobility_[6 * n + freedom];
      (rotation ? free_w_ : free_v_)[n][axis] = (held_[i] >> freedom & 1u) != 0
                                                    ? structure.constraints.velocity(n, freedom, state.time, next)
                                                    : before + push;
    }
  }
}

void TieNodes::start_from(const State& state) {
  for (const NodeIndex node : used_) v_[node.value] = state.v[node.value], w_[node.value] = state.w[node.value];
}

void TieNodes::start_from_free() {
  for (const NodeIndex node : used_) v_[node.value] = free_v_[node.value], w_[node.value] = free_w_[node.value];
}

void TieNodes::push(NodeIndex node, const Vector& force, const Vector& moment, double mean) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t freedom = 6 * std::size_t{node.value} + static_cast<std::size_t>(axis);
    v_[node.value][axis] += mean * mobility_[freedom] * force[axis];
    w_[node.value][axis] += mean * mobility_[freedom + 3] * moment[axis];
  }
}

}  // namespace gapcheck::solver
