#include "solver/element/beam_elements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapcheck::solver {
namespace {

BeamForces as_beam_forces(const DiscreteForces& discrete) {
  BeamForces forces;
  forces.force = discrete.force;
  forces.moment = discrete.moment;
  forces.axial = discrete.axial;
  forces.dissipated = discrete.dissipated;
  forces.manual_step = forces.stable_step = discrete.step;
  forces.failed = discrete.failed;
  forces.good = discrete.good;
  return forces;
}

/// Before its first step. `third`: towards the third node.
BeamState undeformed_beam(const Vector& way, const Vector& third) {
  BeamState beam;
  beam.length = way.norm();
  const Vector r = way / beam.length, across = third - third.dot(r) * r;
  beam.axis = across.norm() > 1e-9 * third.norm() ? Vector(across.normalized()) : r.unitOrthogonal();
  return beam;
}

/// Of both nodes per mass.
std::array<double, 2> inertias(const BeamProperties& properties, double length, const BeamArms& arms,
                               std::size_t beam) {
  const double own = beam_inertia(properties, length);
  return arms.has(beam) ? std::array{own + arms.inertia(beam, 0), own + arms.inertia(beam, 1)} : std::array{own, own};
}

/// `inertia`: per mass, by node.
void give_mass(const std::array<NodeIndex, 2>& nodes, double mass, const std::array<double, 2>& inertia, State& state) {
  for (std::size_t k = 0; k < 2; ++k) {
    state.mass[nodes[k].value] += mass;
    state.inertia[nodes[k].value] += mass * inertia[k];
  }
}

BeamEnds ends_of(const State& state, const std::array<NodeIndex, 2>& nodes) {
  BeamEnds ends;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::uint32_t node = nodes[k].value;
    ends.x[k] = state.x[node];
    ends.v[k] = state.v[node];
    ends.w[k] = state.w[node];
  }
  return ends;
}

/// Those of a beam that has failed: none.
BeamForces without_forces() {
  BeamForces forces;
  forces.good = true;
  forces.manual_step = forces.stable_step = std::numeric_limits<double>::infinity();
  return forces;
}

/// `force`, `moment`: those on both ends before the step. `supplied`: what the preload puts into the beam in it.
BeamForces preloaded_forces(const AxialPreload& preload, const BeamProperties& properties, const State& state,
                            const BeamEnds& ends, std::span<const Vector> force, std::span<const Vector> moment,
                            BeamState& beam, std::span<BeamPoint> points, double& supplied) {
  const double length = (ends.x[1] - ends.x[0]).norm(),
               before = (ends.x[1] - ends.x[0] - state.dt * (ends.v[1] - ends.v[0])).norm();
  const double stored = stored_energy(properties, points, before);
  const ImposedStress imposed{preload.force.at(state.time) / properties.section.area, preload.bending};
  const BeamForces forces = integrated_beam_forces(properties, ends, state.dt, &imposed, beam, points);
  supplied = stored_energy(properties, points, length) - stored;
  for (std::size_t k = 0; k < 2; ++k)
    supplied -=
        state.dt / 2 * ((force[k] + forces.force[k]).dot(ends.v[k]) + (moment[k] + forces.moment[k]).dot(ends.w[k]));
  return forces;
}

bool may_fail(const BeamProperties& properties) {
  if (const DiscreteBeam* discrete = properties.discrete.get()) return discrete->can_fail();
  return properties.integrated() && (properties.material.failure_strain > 0 || properties.weld.exist());
}

}  // namespace

std::uint32_t BeamElements::add_properties(BeamProperties properties) {
  properties_.push_back(std::move(properties));
  return static_cast<std::uint32_t>(properties_.size() - 1);
}

double BeamElements::add(const std::array<NodeIndex, 2>& nodes, std::uint32_t properties, const Vector& third,
                         std::uint32_t origin, State& state, const MassScaling& scaling, double* added_mass,
                         const BeamJoint& joint) {
  const Vector nodes_apart = state.x[nodes[1].value] - state.x[nodes[0].value];
  BeamState beam = undeformed_beam(nodes_apart + joint.offset[1] - joint.offset[0], third);
  if (!(beam.length > 0) || !std::isfinite(beam.length)) return 0;
  beam.released = joint.released;
  append(nodes, properties, origin, beam);
  if (joint.offset != BeamJoint().offset || joint.shift != BeamJoint().shift) {
    const Vector r = (nodes_apart + joint.offset[1] - joint.offset[0]) / beam.length;
    const Vector shift = joint.shift[0] * beam.axis + joint.shift[1] * r.cross(beam.axis);
    arms_.set_last({joint.offset[0] + shift, joint.offset[1] + shift},
                   beam_inertia(properties_[properties], beam.length));
  }
  const double factor = mass_factor(state, scaling), mass = beam_mass(properties_[properties], beam.length);
  step_factor_.push_back(std::sqrt(factor));
  if (added_mass != nullptr) *added_mass += (factor - 1) * mass;
  give_mass(nodes, factor * mass / 2, inertias(properties_[properties], beam.length, arms_, size() - 1), state);
  return beam.length;
}

void BeamElements::append(const std::array<NodeIndex, 2>& nodes, std::uint32_t properties, std::uint32_t origin,
                          BeamState beam) {
  nodes_.push_back(nodes);
  which_.push_back(properties);
  origin_.push_back(origin);
  state_.push_back(std::move(beam));
  first_point_.push_back(first_point_.back() + properties_[properties].fibers.size());
  points_.resize(first_point_.back());
  preload_of_.push_back(no_position);
  discrete_of_.push_back(no_position);
  arms_.add();
}

double BeamElements::add_discrete(const std::array<NodeIndex, 2>& nodes, std::uint32_t properties, const Matrix* axes,
                                  const Vector& third, std::uint32_t origin, State& state, const MassScaling& scaling,
                                  double* added_mass) {
  const DiscreteBeam& beam = *properties_[properties].discrete;
  const Vector way = state.x[nodes[1].value] - state.x[nodes[0].value];
  DiscreteState discrete;
  discrete.axes = discrete_axes(beam, axes, way, third);
  begin_discrete(beam, way, discrete);
  if (!(discrete.mass > 0) || !std::isfinite(discrete.mass)) return 0;
  BeamState common;
  common.length = way.norm();
  common.axis = discrete.axes.col(1);
  append(nodes, properties, origin, common);
  discrete_of_.back() = static_cast<std::uint32_t>(discrete_.size());
  discrete_.push_back(discrete);
  const double factor = mass_factor(state, scaling);
  step_factor_.push_back(std::sqrt(factor));
  if (added_mass != nullptr) *added_mass += (factor - 1) * discrete.mass;
  const double inertia = discrete.inertia / discrete.mass;
  give_mass(nodes, factor * discrete.mass / 2, {inertia, inertia}, state);
  return discrete.mass;
}

/// Of the beam that was added last: first DT of its material, then the scaling of all elements.
double BeamElements::mass_factor(const State& state, const MassScaling& scaling) {
  const BeamProperties& properties = properties_[which_.back()];
  const double least = properties.weld.step;
  if (!properties.material.has_stress() || (!(least > 0) && !(scaling.step > 0))) return 1;
  State still{};
  double supplied = 0;
  BeamForces steps = forces(still, size() - 1, arms_.turn(size() - 1, ends_of(state, nodes_.back()), 0), supplied);
  steps.stable_step *= arms_.step(size() - 1);
  const double own = least > steps.manual_step ? least / steps.manual_step : 1;
  return own * own * scaling.factor(own * steps.manual_step, own * steps.stable_step);
}

std::uint32_t BeamElements::add_preload(AxialPreload preload) {
  preloads_.push_back(std::move(preload));
  return static_cast<std::uint32_t>(preloads_.size() - 1);
}

bool BeamElements::limit_step() const {
  return std::ranges::any_of(which_, [&](std::uint32_t which) { return properties_[which].material.has_stress(); });
}

bool BeamElements::can_fail() const {
  return std::any_of(which_.begin(), which_.end(), [&](std::uint32_t which) { return may_fail(properties_[which]); });
}

void BeamElements::finish(std::size_t nodes) {
  force_.assign(2 * size(), Vector::Zero());
  moment_.assign(2 * size(), Vector::Zero());
  axial_.assign(size(), 0);
  energy_.assign(size(), {});
  failed_.assign(size(), 0);
  std::vector<NodeIndex> corners;
  corners.reserve(2 * size());
  for (const auto& pair : nodes_) corners.insert(corners.end(), pair.begin(), pair.end());
  table_ = CornerTable(nodes, corners);
}

Vector BeamElements::way(std::size_t beam, const std::vector<Vector>& x) const {
  const Vector apart = x[nodes_[beam][1].value] - x[nodes_[beam][0].value];
  return on_arms(beam) ? Vector(apart + arms_.way(beam)) : apart;
}

/// Forces on the steps of the unscaled mass. `supplied`: what a preload puts into the beam in the step.
BeamForces BeamElements::forces(const State& state, std::size_t beam, const BeamEnds& ends, double& supplied) {
  const BeamProperties& properties = properties_[which_[beam]];
  if (properties.discrete) return discrete_forces_of(state, beam, ends, supplied);
  if (properties.integrated()) return integrated_forces(state, beam, ends, supplied);
  return properties.truss ? truss_forces(properties, ends, state.dt, state_[beam])
                          : resultant_beam_forces(properties, ends, state.dt, state_[beam]);
}

BeamForces BeamElements::discrete_forces_of(const State& state, std::size_t beam, const BeamEnds& ends,
                                            double& supplied) {
  const DiscreteBeam& discrete = *properties_[which_[beam]].discrete;
  DiscreteState& history = discrete_[discrete_of_[beam]];
  const DiscreteForces all = discrete.cable ? cable_forces(*discrete.cable, ends, state.time, state.dt, history)
                                            : discrete_forces(discrete, ends, state.dt, history);
  state_[beam].axis = history.axes.col(1);
  supplied = all.supplied;
  return as_beam_forces(all);
}

Matrix BeamElements::axes(std::size_t beam, const std::vector<Vector>& x) const {
  const DiscreteState* history = discrete(beam);
  if (history != nullptr && !properties(beam).discrete->cable) return history->axes;
  Matrix axes;
  axes.col(0) = way(beam, x).normalized();
  axes.col(1) = state_[beam].axis;
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

BeamForces BeamElements::integrated_forces(const State& state, std::size_t beam, const BeamEnds& ends,
                                           double& supplied) {
  const BeamProperties& properties = properties_[which_[beam]];
  const std::span<BeamPoint> points(points_.data() + first_point_[beam], points_.data() + first_point_[beam + 1]);
  const AxialPreload* preload = preloaded(beam) ? &preloads_[preload_of_[beam]] : nullptr;
  if (preload == nullptr || !preload->active(state))
    return integrated_beam_forces(properties, ends, state.dt, nullptr, state_[beam], points);
  const std::span<const Vector> force(&force_[2 * beam], 2), moment(&moment_[2 * beam], 2);
  return preloaded_forces(*preload, properties, state, ends, force, moment, state_[beam], points, supplied);
}

bool BeamElements::fails(const State& state, std::size_t beam, const BeamForces& forces) {
  const BeamProperties& properties = properties_[which_[beam]];
  if (forces.good && forces.failed) return true;
  if (!properties.integrated() || !forces.good) return false;
  const std::span<const BeamPoint> points = this->points(beam);
  if (std::all_of(points.begin(), points.end(), [](const BeamPoint& point) { return point.failed; })) return true;
  return weld_fails(properties.weld, forces.resultants, state.time, least_plastic_strain(points), state_[beam].weld);
}

Summary BeamElements::update_one(const State& state, std::size_t beam) {
  if (failed_[beam] != 0) return {};
  const BeamEnds ends = ends_of(state, nodes_[beam]);
  Summary summary;
  BeamForces forces = this->forces(state, beam, arms_.turn(beam, ends, state.dt), summary.supplied);
  if (fails(state, beam, forces)) {
    failed_[beam] = 1;
    forces = without_forces();
    summary.failed = 1;
  }
  for (std::size_t k = 0; k < 2; ++k) forces.moment[k] = arms_.at_node(beam, k, forces.force[k], forces.moment[k]);
  forces.stable_step *= arms_.step(beam);
  summary.manual_step = forces.manual_step * step_factor_[beam];
  summary.stable_step = forces.stable_step * step_factor_[beam];
  watched_.note(beam, summary.manual_step, summary.stable_step);
  summary.dissipated = forces.dissipated;
  if (!forces.good) summary.bad = static_cast<std::uint32_t>(beam);
  summary.work = summary.supplied;
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
  const double length = way(beam, x).norm();
  if (const DiscreteState* history = discrete(beam))
    return failed_.empty() || failed_[beam] == 0 ? stored_energy(*properties(beam).discrete, *history, length) : 0;
  if (properties(beam).integrated()) return stored_energy(properties(beam), points(beam), length);
  return stored_energy(properties(beam), state_[beam], length);
}

void BeamElements::watch_steps(const MassScaling& scaling, const State& /*state*/) {
  watched_.start(scaling, size());
  for (std::size_t i = 0; i < size(); ++i)
    watched_.mass[i] = beam_mass(properties(i), state_[i].length) * step_factor_[i] * step_factor_[i];
}

AddedMass BeamElements::keep_steps(State& state) {
  AddedMass added;
  watched_.grow_where_needed([&](std::size_t beam, double factor) {
    const double share = (factor - 1) * watched_.mass[beam] / 2;
    const auto inertia = inertias(properties(beam), state_[beam].length, arms_, beam);
    for (std::size_t k = 0; k < 2; ++k) added.give(state, nodes_[beam][k].value, share, share * inertia[k]);
    step_factor_[beam] *= std::sqrt(factor);
    ++added.elements;
  });
  return added;
}

Summary BeamElements::update(const State& state) {
  return sum_over_blocks<Summary>(size(), [&](std::size_t begin, std::size_t end) {
    Summary sum;
    for (std::size_t i = begin; i < end; ++i) sum.add(update_one(state, i));
    return sum;
  });
}

}  // namespace gapcheck::solver
