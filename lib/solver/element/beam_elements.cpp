#include "solver/element/beam_elements.hpp"

#include <cmath>

namespace gapcheck::solver {

std::uint32_t BeamElements::add_properties(BeamProperties properties) {
  properties_.push_back(std::move(properties));
  return static_cast<std::uint32_t>(properties_.size() - 1);
}

double BeamElements::add(const std::array<NodeIndex, 2>& nodes, std::uint32_t properties, const Vector& third,
                         std::uint32_t origin, State& state) {
  const Vector way = state.x[nodes[1].value] - state.x[nodes[0].value];
  BeamState beam;
  beam.length = way.norm();
  if (!(beam.length > 0) || !std::isfinite(beam.length)) return 0;
  const Vector r = way / beam.length, across = third - third.dot(r) * r;
  beam.axis = across.norm() > 1e-9 * third.norm() ? Vector(across.normalized()) : r.unitOrthogonal();
  const double share = beam_mass(properties_[properties], beam.length) / 2;
  for (const NodeIndex node : nodes) {
    state.mass[node.value] += share;
    state.inertia[node.value] += share * beam_inertia(properties_[properties], beam.length);
  }
  nodes_.push_back(nodes);
  which_.push_back(properties);
  origin_.push_back(origin);
  state_.push_back(beam);
  return beam.length;
}

void BeamElements::finish(std::size_t nodes) {
  force_.assign(2 * size(), Vector::Zero());
  moment_.assign(2 * size(), Vector::Zero());
  axial_.assign(size(), 0);
  energy_.assign(size(), {});
  std::vector<NodeIndex> ends;
  ends.reserve(2 * size());
  for (const auto& pair : nodes_) ends.insert(ends.end(), pair.begin(), pair.end());
  table_ = CornerTable(nodes, ends);
}

Summary BeamElements::update_one(const State& state, std::size_t beam) {
  BeamEnds ends;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::uint32_t node = nodes_[beam][k].value;
    ends.x[k] = state.x[node];
    ends.v[k] = state.v[node];
    ends.w[k] = state.w[node];
  }
  const BeamProperties& properties = properties_[which_[beam]];
  const BeamForces forces = properties.truss ? truss_forces(properties, ends, state.dt, state_[beam])
                                             : resultant_beam_forces(properties, ends, state.dt, state_[beam]);
  Summary summary;
  summary.manual_step = forces.manual_step;
  summary.stable_step = forces.stable_step;
  summary.dissipated = forces.dissipated;
  if (!forces.good) summary.bad = static_cast<std::uint32_t>(beam);
  for (std::size_t k = 0; k < 2; ++k) {
    Vector &force = force_[2 * beam + k], &moment = moment_[2 * beam + k];
    summary.work +=
        state.dt / 2 * ((force + forces.force[k]).dot(ends.v[k]) + (moment + forces.moment[k]).dot(ends.w[k]));
    force = forces.force[k];
    moment = forces.moment[k];
  }
  axial_[beam] = forces.axial;
  summary.manual_at = summary.stable_at = static_cast<std::uint32_t>(beam);
  energy_[beam].add(summary);
  return summary;
}

double BeamElements::stored(std::size_t beam, const std::vector<Vector>& x) const {
  const auto& [a, b] = nodes_[beam];
  return stored_energy(properties(beam), state_[beam], (x[b.value] - x[a.value]).norm());
}

Summary BeamElements::update(const State& state) {
  return sum_over_blocks<Summary>(size(), [&](std::size_t begin, std::size_t end) {
    Summary sum;
    for (std::size_t i = begin; i < end; ++i) sum.add(update_one(state, i));
    return sum;
  });
}

}  // namespace gapcheck::solver
