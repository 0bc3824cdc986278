#include "solver/element/solid_elements.hpp"

#include "model/entity/faces.hpp"

namespace gapcheck::solver {

std::uint32_t SolidElements::add_properties(SolidProperties properties) {
  properties_.push_back(std::move(properties));
  return static_cast<std::uint32_t>(properties_.size() - 1);
}

double SolidElements::add(const std::array<NodeIndex, 8>& nodes, std::uint32_t properties, std::uint32_t origin,
                          State& state, const MassScaling& scaling, double* added) {
  std::array<Vector, 8> x;
  for (std::size_t k = 0; k < 8; ++k) x[k] = state.x[nodes[k].value];
  const bool four = model::is_tetrahedron(nodes);
  const double volume = four ? tetrahedron_volume(x) : brick_volume(x);
  if (!(volume > 0)) return volume;
  nodes_.push_back(nodes);
  which_.push_back(properties);
  origin_.push_back(origin);
  SolidState solid;
  solid.mass = properties_[properties].material.density * volume;
  const bool stiff = !four && properties_[properties].hourglass.kind == HourglassKind::stiffness;
  const auto set_reference = [&] {
    if (stiff)
      solid.reference =
          std::make_shared<HourglassReference>(hourglass_reference(properties_[properties], x, solid.mass));
  };
  set_reference();
  if (scaling.step > 0) {
    SolidCorners at_rest;
    at_rest.x = x;
    at_rest.v.fill(Vector::Zero());
    SolidState state_at_rest = solid;
    PointState point;
    const SolidForces steps =
        (four ? tetrahedron_forces : brick_forces)(properties_[properties], at_rest, 0, state_at_rest, point);
    const double own = solid.mass;
    solid.mass *= scaling.factor(steps.manual_step, steps.stable_step);
    if (added != nullptr) *added += solid.mass - own;
    set_reference();
  }
  const std::size_t corners = four ? 4 : 8;
  for (std::size_t k = 0; k < corners; ++k) state.mass[nodes[k].value] += solid.mass / static_cast<double>(corners);
  state_.push_back(solid);
  return volume;
}

void SolidElements::finish(std::size_t nodes) {
  points_.assign(size(), {});
  force_.assign(8 * size(), Vector::Zero());
  energy_.assign(size(), {});
  failed_.assign(size(), 0);
  std::vector<NodeIndex> corners;
  corners.reserve(8 * size());
  for (std::size_t i = 0; i < size(); ++i)
    for (std::size_t k = 0; k < 8; ++k)
      corners.push_back(k > 3 && model::is_tetrahedron(nodes_[i]) ? none<NodeIndex> : nodes_[i][k]);
  table_ = CornerTable(nodes, corners);
}

Summary SolidElements::update_one(const State& state, std::size_t solid) {
  if (failed_[solid] != 0) return {};
  SolidCorners corners;
  for (std::size_t k = 0; k < 8; ++k) {
    const std::uint32_t node = nodes_[solid][k].value;
    corners.x[k] = state.x[node];
    corners.v[k] = state.v[node];
  }
  const SolidProperties& properties = properties_[which_[solid]];
  const auto kernel = model::is_tetrahedron(nodes_[solid]) ? tetrahedron_forces : brick_forces;
  SolidForces forces = kernel(properties, corners, state.dt, state_[solid], points_[solid]);
  Summary summary;
  if (points_[solid].failed || (inverted_fail_ && !forces.good)) {
    failed_[solid] = 1;
    points_[solid].stress = {};
    forces = {};
    forces.force.fill(Vector::Zero());
    summary.failed = 1;
  } else if (forces.good) {
    summary.manual_step = forces.manual_step;
    summary.stable_step = forces.stable_step;
  } else {
    summary.bad = static_cast<std::uint32_t>(solid);
  }
  summary.hourglass_work = forces.hourglass_work;
  summary.dissipated = forces.dissipated;
  for (std::size_t k = 0; k < 8; ++k) {
    Vector& force = force_[8 * solid + k];
    summary.work += state.dt / 2 * (force + forces.force[k]).dot(corners.v[k]);
    force = forces.force[k];
  }
  summary.manual_at = summary.stable_at = static_cast<std::uint32_t>(solid);
  energy_[solid].add(summary);
  return summary;
}

double SolidElements::stored(std::size_t solid, const std::vector<Vector>& x) const {
  std::array<Vector, 8> places;
  for (std::size_t k = 0; k < 8; ++k) places[k] = x[nodes_[solid][k].value];
  const double volume = model::is_tetrahedron(nodes_[solid]) ? tetrahedron_volume(places) : brick_volume(places);
  return stored_energy(properties(solid), state_[solid], volume, points_[solid]);
}

Summary SolidElements::update(const State& state) {
  return sum_over_blocks<Summary>(size(), [&](std::size_t begin, std::size_t end) {
    Summary sum;
    for (std::size_t i = begin; i < end; ++i) sum.add(update_one(state, i));
    return sum;
  });
}

}  // namespace gapcheck::solver
