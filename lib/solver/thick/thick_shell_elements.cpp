#include "solver/thick/thick_shell_elements.hpp"

#include <utility>

namespace gapcheck::solver {

std::uint32_t ThickShellElements::add_properties(ShellProperties properties) {
  properties_.push_back(std::move(properties));
  return static_cast<std::uint32_t>(properties_.size() - 1);
}

std::array<Vector, 8> ThickShellElements::places(std::size_t shell, const std::vector<Vector>& x) const {
  std::array<Vector, 8> places;
  for (std::size_t k = 0; k < 8; ++k) places[k] = x[nodes_[shell][k].value];
  return places;
}

double ThickShellElements::add(const std::array<NodeIndex, 8>& nodes, std::uint32_t properties, std::uint32_t origin,
                               State& state, const MassScaling& scaling, double* added) {
  const ShellProperties& all = properties_[properties];
  SolidCorners corners;
  for (std::size_t k = 0; k < 8; ++k) corners.x[k] = state.x[nodes[k].value];
  corners.v.fill(Vector::Zero());
  const double volume = one_point_volume(corners.x);
  if (!(volume > 0)) return volume;
  ThickShellState shell = begin_thick_shell(all, corners.x);
  ThickShellState still = shell;
  std::vector<PointState> points(all.layers.size());
  const ThickShellForces steps = thick_shell_forces(all, corners, 0, still, points);
  if (!steps.good) return 0;
  if (scaling.step > 0) {
    const double own = shell.mass;
    shell.mass_factor = scaling.factor(steps.manual_step, steps.stable_step);
    shell.mass *= shell.mass_factor;
    if (added != nullptr) *added += shell.mass - own;
  }
  for (const NodeIndex node : nodes) state.mass[node.value] += shell.mass / 8;
  nodes_.push_back(nodes);
  which_.push_back(properties);
  origin_.push_back(origin);
  state_.push_back(shell);
  first_point_.push_back(first_point_.back() + all.layers.size());
  return volume;
}

void ThickShellElements::finish(std::size_t nodes) {
  points_.resize(first_point_.back());
  force_.assign(8 * size(), Vector::Zero());
  energy_.resize(size());
  std::vector<NodeIndex> corners;
  corners.reserve(8 * size());
  for (const auto& all : nodes_) corners.insert(corners.end(), all.begin(), all.end());
  table_ = CornerTable(nodes, corners);
}

Summary ThickShellElements::update_one(const State& state, std::size_t shell) {
  SolidCorners corners;
  for (std::size_t k = 0; k < 8; ++k) {
    const std::uint32_t node = nodes_[shell][k].value;
    corners.x[k] = state.x[node];
    corners.v[k] = state.v[node];
  }
  const std::span<PointState> points(points_.data() + first_point_[shell], points_.data() + first_point_[shell + 1]);
  const ThickShellForces forces = thick_shell_forces(properties(shell), corners, state.dt, state_[shell], points);
  Summary summary;
  if (forces.good) {
    summary.manual_step = forces.manual_step;
    summary.stable_step = forces.stable_step;
  } else {
    summary.bad = static_cast<std::uint32_t>(shell);
  }
  summary.hourglass_work = forces.hourglass_work;
  summary.dissipated = forces.dissipated;
  for (std::size_t k = 0; k < 8; ++k) {
    Vector& force = force_[8 * shell + k];
    summary.work += state.dt / 2 * (force + forces.force[k]).dot(corners.v[k]);
    force = forces.force[k];
  }
  summary.manual_at = summary.stable_at = static_cast<std::uint32_t>(shell);
  energy_[shell].add(summary);
  return summary;
}

double ThickShellElements::stored(std::size_t shell, const std::vector<Vector>& x) const {
  return stored_energy(properties(shell), state_[shell], places(shell, x), points(shell));
}

Matrix ThickShellElements::axes(std::size_t shell, const std::vector<Vector>& x) const {
  return quad_axes(mid_surface(places(shell, x)), properties(shell).axes);
}

Summary ThickShellElements::update(const State& state) {
  return sum_over_blocks<Summary>(size(), [&](std::size_t begin, std::size_t end) {
    Summary sum;
    for (std::size_t i = begin; i < end; ++i) sum.add(update_one(state, i));
    return sum;
  });
}

}  // namespace gapcheck::solver
