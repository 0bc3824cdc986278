#include "solver/element/shell_elements.hpp"

#include "base/quad.hpp"
#include "solver/element/quad_batch.hpp"

namespace gapcheck::solver {
namespace {

std::array<Vector, 4> places_of(const std::array<NodeIndex, 4>& nodes, const std::vector<Vector>& x) {
  return {x[nodes[0].value], x[nodes[1].value], x[nodes[2].value], x[nodes[3].value]};
}

ShellCorners corners_of(const std::array<NodeIndex, 4>& nodes, const State& state) {
  ShellCorners corners;
  for (std::size_t k = 0; k < 4; ++k) {
    corners.x[k] = state.x[nodes[k].value];
    corners.v[k] = state.v[nodes[k].value];
    corners.w[k] = state.w[nodes[k].value];
  }
  return corners;
}

/// Of the corners of a shell.
std::span<Vector, 4> four_of(std::vector<Vector>& list, std::size_t shell) {
  return std::span<Vector, 4>(&list[4 * shell], 4);
}

/// Replaces the forces and moments of a shell; returns the work of the old and the new ones over the step.
double exchange(const ShellForces& now, const ShellCorners& corners, double dt, std::span<Vector, 4> forces,
                std::span<Vector, 4> moments) {
  double work = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    work += dt / 2 * ((forces[k] + now.force[k]).dot(corners.v[k]) + (moments[k] + now.moment[k]).dot(corners.w[k]));
    forces[k] = now.force[k];
    moments[k] = now.moment[k];
  }
  return work;
}

}  // namespace

std::uint32_t ShellElements::add_properties(ShellProperties properties) {
  batched_.push_back(QuadBatch::takes(properties) ? 1 : 0);
  properties_.push_back(std::move(properties));
  return static_cast<std::uint32_t>(properties_.size() - 1);
}

std::uint32_t ShellElements::with_reference(std::uint32_t properties, double reference) {
  if (properties_[properties].reference == reference) return properties;
  const auto [entry, is_new] = referenced_.try_emplace({properties, reference}, 0);
  if (is_new) {
    ShellProperties own = properties_[properties];
    own.reference = reference;
    entry->second = add_properties(std::move(own));
  }
  return entry->second;
}

ShellForces ShellElements::at_rest(std::size_t shell, const std::vector<Vector>& x) const {
  ShellCorners corners{places_of(nodes_[shell], x), {}, {}};
  corners.v.fill(Vector::Zero());
  corners.w.fill(Vector::Zero());
  const ShellProperties& properties = properties_[which_[shell]];
  ShellState state = state_[shell];
  std::vector<PointState> points(points_in_plane(shell) * properties.layers.size());
  return forces(shell, corners, 0, state, points);
}

ShellForces ShellElements::forces(std::size_t shell, const ShellCorners& corners, double dt, ShellState& state,
                                  std::span<PointState> points) const {
  const ShellProperties& own = properties(shell);
  const auto quad = own.projection == ShellProjection::none ? quad_forces : warped_quad_forces;
  const auto bent = own.discrete_kirchhoff ? kirchhoff_forces : triangle_forces;
  const auto kernel = full(shell) ? full_forces : triangle(shell) ? bent : quad;
  return kernel(own, corners, dt, state, points);
}

double ShellElements::add(const std::array<NodeIndex, 4>& nodes, std::uint32_t properties, double thickness,
                          std::uint32_t origin, State& state, const MassScaling& scaling) {
  nodes_.push_back(nodes);
  which_.push_back(properties);
  origin_.push_back(origin);
  ShellState shell;
  shell.thickness = thickness;
  const std::vector<Vector>& x = state.x;
  const std::size_t corners = triangle(size() - 1) ? 3 : 4;
  if (corners == 4 && !full(size() - 1))
    shell.stiffness = hourglass_stiffness(properties_[properties], places_of(nodes, x), thickness);
  state_.push_back(shell);
  // With corners 3 and 4 equal this is the triangle's area too.
  const double area = quad_normal(nodes, x).norm() / 2;
  double factor = 1;
  if (scaling.step > 0) {
    const ShellForces steps = at_rest(size() - 1, x);
    factor = scaling.factor(steps.manual_step, steps.stable_step);
    step_factor_.push_back(std::sqrt(factor));
  }
  const double mass = properties_[properties].material.density * area * thickness;
  const double share = factor * mass / static_cast<double>(corners);
  for (std::size_t i = 0; i < corners; ++i) {
    state.mass[nodes[i].value] += share;
    state.inertia[nodes[i].value] += share * properties_[properties].inertia(area, thickness);
  }
  first_point_.push_back(first_point_.back() + points_in_plane(size() - 1) * properties_[properties].layers.size());
  return (factor - 1) * mass;
}

Matrix ShellElements::axes(std::size_t shell, const std::vector<Vector>& x) const {
  const std::array<Vector, 4> places = places_of(nodes_[shell], x);
  const ShellAxes kind = properties(shell).axes;
  return full(shell) ? full_axes(places, kind) : triangle(shell) ? triangle_axes(places) : quad_axes(places, kind);
}

void ShellElements::begin_with(std::size_t shell, std::span<const PointState> points, const std::vector<Vector>& x) {
  points_.resize(first_point_.back());
  energy_.resize(size());
  std::copy(points.begin(), points.end(), points_.begin() + static_cast<std::ptrdiff_t>(first_point_[shell]));
  energy_[shell].initial = stored(shell, x);
}

void ShellElements::finish(std::size_t nodes) {
  points_.resize(first_point_.back());
  for (std::size_t i = 0; i < size(); ++i)
    for (std::size_t p = first_point_[i]; p < first_point_[i + 1]; ++p) points_[p].axis = state_[i].axis;
  force_.assign(4 * size(), Vector::Zero());
  moment_.assign(4 * size(), Vector::Zero());
  energy_.resize(size());
  failed_.assign(size(), 0);
  std::vector<NodeIndex> corners;
  corners.reserve(4 * size());
  for (std::size_t i = 0; i < size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      corners.push_back(k == 3 && triangle(i) && !full(i) ? none<NodeIndex> : nodes_[i][k]);
  table_ = CornerTable(nodes, corners);
}

Summary ShellElements::update_one(const State& state, std::size_t shell) {
  if (failed_[shell] != 0) return {};
  const ShellCorners corners = corners_of(nodes_[shell], state);
  const std::span<PointState> points(points_.data() + first_point_[shell], points_.data() + first_point_[shell + 1]);
  ShellForces forces = this->forces(shell, corners, state.dt, state_[shell], points);
  Summary summary;
  fails_now(state, shell, forces, summary);
  summary.work = exchange(forces, corners, state.dt, four_of(force_, shell), four_of(moment_, shell));
  return conclude(shell, forces, summary);
}

std::size_t ShellElements::end_of_batch(std::size_t first, std::size_t last) const {
  const auto taken = [&](std::size_t shell) {
    return which_[shell] == which_[first] && failed_[shell] == 0 && !triangle(shell);
  };
  if (batched_[which_[first]] == 0) return first;
  std::size_t end = first;
  while (end < std::min(last, first + QuadBatch::capacity) && taken(end)) ++end;
  return end;
}

void ShellElements::update_batch(const State& state, std::size_t first, std::size_t last, Summary& sum) {
  const ShellProperties& own = properties(first);
  QuadBatch batch;
  std::array<double, QuadBatch::capacity> plastic_work;
  for (std::size_t shell = first; shell < last; ++shell) batch.add(nodes_[shell], state, state_[shell]);
  batch.begin(own, state.dt);
  for (std::size_t shell = first; shell < last; ++shell) {
    const std::span<PointState> points(points_.data() + first_point_[shell], points_.data() + first_point_[shell + 1]);
    plastic_work[shell - first] = batch.integrate(shell - first, own, state.dt, state_[shell], points);
  }
  batch.end(own);
  for (std::size_t shell = first; shell < last; ++shell) {
    const std::size_t i = shell - first;
    ShellForces rest = batch.rest_of(i, own, plastic_work[i]);
    Summary summary;
    const std::span<Vector, 4> force = four_of(force_, shell), moment = four_of(moment_, shell);
    summary.work = fails_now(state, shell, rest, summary)
                       ? exchange(rest, corners_of(nodes_[shell], state), state.dt, force, moment)
                       : batch.exchange(i, state.dt, force, moment);
    sum.add(conclude(shell, rest, summary));
  }
}

bool ShellElements::fails_now(const State& state, std::size_t shell, ShellForces& forces, Summary& summary) {
  const FoldedShell rule = properties(shell).folded;
  const bool folded = rule != FoldedShell::allowed && is_folded(places_of(nodes_[shell], state.x));
  const bool fails =
      solver::fails(properties(shell), points(shell), state.time) || (folded && rule == FoldedShell::fails);
  if (fails) {
    failed_[shell] = 1;
    forces = ShellForces::none();
    summary.failed = 1;
  }
  if (folded && rule == FoldedShell::ends_run) forces.good = false;
  return fails;
}

Summary ShellElements::conclude(std::size_t shell, const ShellForces& forces, Summary summary) {
  const double factor = step_factor_.empty() ? 1 : step_factor_[shell];
  summary.manual_step = forces.manual_step * factor;
  summary.stable_step = forces.stable_step * factor;
  watched_.note(shell, summary.manual_step, summary.stable_step);
  summary.hourglass_work = forces.hourglass_work;
  summary.dissipated = forces.dissipated;
  summary.viscous_work = forces.viscous_work;
  if (!forces.good) summary.bad = static_cast<std::uint32_t>(shell);
  summary.manual_at = summary.stable_at = static_cast<std::uint32_t>(shell);
  energy_[shell].add(summary);
  return summary;
}

double ShellElements::stored(std::size_t shell, const std::vector<Vector>& x) const {
  if (full(shell))
    return full_stored_energy(properties(shell), state_[shell], places_of(nodes_[shell], x), points(shell));
  const double area = quad_normal(nodes_[shell], x).norm() / 2;
  if (kirchhoff(shell)) return kirchhoff_stored_energy(properties(shell), state_[shell], area, points(shell));
  return stored_energy(properties(shell), state_[shell], area, points(shell));
}

void ShellElements::watch_steps(const MassScaling& scaling, const State& state) {
  watched_.start(scaling, size());
  step_factor_.resize(size(), 1);
  for (std::size_t i = 0; i < size(); ++i)
    watched_.mass[i] = properties(i).material.density * quad_normal(nodes_[i], state.x).norm() / 2 *
                       state_[i].thickness * step_factor_[i] * step_factor_[i];
}

AddedMass ShellElements::keep_steps(State& state) {
  AddedMass added;
  watched_.grow_where_needed([&](std::size_t shell, double factor) {
    const std::size_t corners = triangle(shell) ? 3 : 4;
    const double share = (factor - 1) * watched_.mass[shell] / static_cast<double>(corners);
    const double turning = rotational_inertia(quad_normal(nodes_[shell], state.x).norm() / 2, state_[shell].thickness);
    for (std::size_t k = 0; k < corners; ++k) added.give(state, nodes_[shell][k].value, share, share * turning);
    step_factor_[shell] *= std::sqrt(factor);
    ++added.elements;
  });
  return added;
}

Summary ShellElements::update(const State& state) {
  return sum_over_blocks<Summary>(size(), [&](std::size_t begin, std::size_t end) {
    Summary sum;
    for (std::size_t i = begin; i < end;) {
      const std::size_t last = end_of_batch(i, end);
      if (last > i)
        update_batch(state, i, last, sum);
      else
        sum.add(update_one(state, i));
      i = std::max(last, i + 1);
    }
    return sum;
  });
}

}  // namespace gapcheck::solver
