#include "solver/element/solid_elements.hpp"

#include <cmath>

#include "model/entity/faces.hpp"
#include "solver/element/brick_batch.hpp"

namespace gapcheck::solver {
namespace {

struct SolidKind {
  bool tetrahedron = false;
  SolidRule rule = SolidRule::one_point;
};

double volume_of_mass(const SolidKind& kind, const std::array<Vector, 8>& x) {
  if (kind.tetrahedron) return tetrahedron_volume(x);
  return has_eight_points(kind.rule) ? brick_volume(x) : one_point_volume(x);
}

/// What must be above zero: `volume`, and what the forces are calculated with.
double least_volume(const SolidProperties& properties, const SolidKind& kind, const std::array<Vector, 8>& x,
                    double volume) {
  if (has_eight_points(kind.rule)) {
    const BrickMap map = brick_map(kind.rule, brick_modes(x));
    return map.good ? volume : std::min(map.least, 0.0);
  }
  if (!(volume > 0) || kind.tetrahedron) return volume;
  return brick_volume(properties, x);
}

/// What belongs to the undeformed solid. Call it again when its mass has changed.
void set_references(const SolidProperties& properties, const SolidKind& kind, const std::array<Vector, 8>& x,
                    SolidState& solid) {
  const bool rubber = properties.material.kind == MaterialKind::rubber;
  if (properties.material.finite) solid.finite.assign(!kind.tetrahedron && has_eight_points(kind.rule) ? 8 : 1, {});
  if (properties.material.hydro) {
    solid.fluid.energy = properties.material.hydro->state.initial_energy;
    solid.fluid.reference_volume = kind.tetrahedron              ? tetrahedron_volume(x)
                                   : has_eight_points(kind.rule) ? brick_map(kind.rule, brick_modes(x)).total
                                                                 : brick_volume(properties, x);
  }
  if (has_eight_points(kind.rule)) {
    if (rubber) solid.undeformed_brick = std::make_shared<const BrickMap>(brick_map(kind.rule, brick_modes(x)));
    return;
  }
  if (!kind.tetrahedron && (properties.hourglass.kind == HourglassKind::stiffness ||
                            properties.hourglass.kind == HourglassKind::assumed_strain))
    solid.reference = std::make_shared<HourglassReference>(hourglass_reference(properties, x, solid.mass));
  if (rubber)
    solid.undeformed = std::make_shared<Matrix>((kind.tetrahedron ? tetrahedron_axes(x) : brick_axes(x)).inverse());
}

SolidForces forces_by_kind(const SolidProperties& properties, const SolidKind& kind, const SolidCorners& corners,
                           double dt, SolidState& state, std::span<PointState> points) {
  if (kind.tetrahedron) return tetrahedron_forces(properties, corners, dt, state, points[0]);
  if (!has_eight_points(kind.rule)) return brick_forces(properties, corners, dt, state, points[0]);
  return eight_point_forces(properties, kind.rule, corners, dt, state, points.first<8>());
}

SolidForces at_rest(const SolidProperties& properties, const SolidKind& kind, const std::array<Vector, 8>& x,
                    SolidState state) {
  SolidCorners corners;
  corners.x = x;
  corners.v.fill(Vector::Zero());
  std::array<PointState, 8> points;
  return forces_by_kind(properties, kind, corners, 0, state, points);
}

PointState mean_of(std::span<const PointState> all) {
  PointState mean = all[0];
  if (all.size() == 1) return mean;
  const auto share = [&](const auto& of) {
    double sum = 0;
    for (const PointState& point : all) sum += of(point);
    return sum / static_cast<double>(all.size());
  };
  for (std::size_t k = 0; k < mean.stress.size(); ++k) {
    mean.stress[k] = share([&](const PointState& point) { return point.stress[k]; });
    mean.back_stress[k] = share([&](const PointState& point) { return point.back_stress[k]; });
  }
  mean.plastic_strain = share([](const PointState& point) { return point.plastic_strain; });
  mean.plastic_work = share([](const PointState& point) { return point.plastic_work; });
  return mean;
}

SolidCorners corners_of(const State& state, const std::array<NodeIndex, 8>& nodes) {
  SolidCorners corners;
  for (std::size_t k = 0; k < 8; ++k) {
    corners.x[k] = state.x[nodes[k].value];
    corners.v[k] = state.v[nodes[k].value];
  }
  return corners;
}

/// Volumes in the middle of the step; those that have failed or turned inside out take no part.
void average_volumes(const State& state, std::span<const std::array<NodeIndex, 8>> nodes, std::span<const char> failed,
                     std::vector<NodalAverage::Share>& shares, NodalAverage& average) {
  parallel_for(shares.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t solid = average.owners()[i];
      const SolidCorners corners = corners_of(state, nodes[solid]);
      shares[i] = failed[solid] != 0 ? NodalAverage::Share{} : tetrahedron_share(corners, state.dt);
    }
  });
  average.average(shares);
}

/// Replaces the forces on the corners; adds the work of the old and the new ones over the step. `velocity`: of a
/// corner.
template <class Velocity>
void exchange(const SolidForces& now, const Velocity& velocity, double dt, Vector* forces, double& work) {
  for (std::size_t k = 0; k < 8; ++k) {
    work += dt / 2 * (forces[k] + now.force[k]).dot(velocity(k));
    forces[k] = now.force[k];
  }
}

/// One of its points has failed, its time is over, it is inside out, or its step is too small.
bool has_failed(const SolidProperties& properties, std::span<const PointState> points, const SolidEnds& ends,
                double time, const SolidForces& forces) {
  if (std::any_of(points.begin(), points.end(), [](const PointState& point) { return point.failed; })) return true;
  if (past_time(properties.material.erosion, time)) return true;
  if (!forces.good) return ends.inverted || properties.inverted_fails;
  return std::min(ends.factor * forces.manual_step, forces.stable_step / step_slack) < ends.least;
}

/// It has failed, or the limits of a spotweld are exceeded.
bool tears(const SolidProperties& properties, std::span<const PointState> points, const SolidEnds& ends, double time,
           const SolidCorners& corners, const SolidForces& forces, WeldHistory& history) {
  if (has_failed(properties, points, ends, time, forces)) return true;
  return forces.good && properties.weld.exist() &&
         weld_fails(properties.weld, brick_resultants(corners.x, forces.force), time, least_plastic_strain(points),
                    history);
}

CornerTable corner_table(std::size_t nodes, std::span<const std::array<NodeIndex, 8>> solids) {
  std::vector<NodeIndex> corners;
  corners.reserve(8 * solids.size());
  for (const std::array<NodeIndex, 8>& solid : solids)
    for (std::size_t k = 0; k < 8; ++k)
      corners.push_back(k > 3 && model::is_tetrahedron(solid) ? none<NodeIndex> : solid[k]);
  return {nodes, corners};
}

/// A solid that fails has no stress, no force and no step.
void remove(std::span<PointState> points, SolidState& state, SolidForces& forces) {
  for (PointState& point : points) point.stress = {};
  state.mean_stress = {};
  forces = {};
  forces.force.fill(Vector::Zero());
}

/// What the sums take over from the forces.
void note_work(const SolidForces& forces, std::uint32_t solid, Summary& summary) {
  summary.hourglass_work = forces.hourglass_work;
  summary.dissipated = forces.dissipated;
  summary.viscous_work = forces.viscous_work;
  summary.manual_at = summary.stable_at = solid;
}

/// The share of each corner in a solid's mass.
std::array<double, 8> mass_shares(const SolidKind& kind, const std::array<NodeIndex, 8>& nodes) {
  return kind.tetrahedron ? std::array<double, 8>{0.25, 0.25, 0.25, 0.25} : corner_shares(kind.rule, nodes);
}

/// Rubber and foam vibrate with large strains. A step that follows these up and down, in phase with the vibration,
/// feeds it; one that only falls cannot.
void set_steps(const Material& material, const SolidForces& forces, SolidState& solid, Summary& summary) {
  summary.manual_step = forces.manual_step;
  summary.stable_step = forces.stable_step;
  if (material.kind != MaterialKind::rubber) return;
  summary.manual_step = solid.least_manual_step = std::min(solid.least_manual_step, forces.manual_step);
  summary.stable_step = solid.least_stable_step = std::min(solid.least_stable_step, forces.stable_step);
}

/// After its mass has grown by a factor.
void let_grow(SolidState& solid, double factor) {
  solid.mass *= factor;
  solid.least_manual_step *= std::sqrt(factor);
  solid.least_stable_step *= std::sqrt(factor);
  if (solid.reference == nullptr) return;
  HourglassReference reference = *solid.reference;
  reference.squared_frequency /= factor;
  solid.reference = std::make_shared<const HourglassReference>(reference);
}

}  // namespace

std::uint32_t SolidElements::add_properties(SolidProperties properties) {
  batched_.push_back(BrickBatch::takes(properties) ? 1 : 0);
  properties_.push_back(std::move(properties));
  return static_cast<std::uint32_t>(properties_.size() - 1);
}

double SolidElements::add(const std::array<NodeIndex, 8>& nodes, std::uint32_t properties, std::uint32_t origin,
                          State& state, const MassScaling& scaling, double* added) {
  const SolidProperties& all = properties_[properties];
  const SolidShape shape = solid_shape(nodes);
  const SolidKind kind{shape == SolidShape::tetrahedron, all.rules.of(shape)};
  std::array<Vector, 8> x;
  for (std::size_t k = 0; k < 8; ++k) x[k] = state.x[nodes[k].value];
  const double volume = volume_of_mass(kind, x);
  if (const double least = least_volume(all, kind, x, volume); !(least > 0)) return least;
  SolidState solid;
  solid.mass = all.material.density * volume;
  set_references(all, kind, x, solid);
  if (scaling.step > 0 || all.weld.step > 0) {
    const double own = solid.mass;
    const SolidForces steps = at_rest(all, kind, x, solid);
    const double longer = std::max(all.weld.step / steps.manual_step, 1.0);  // first DT of its material
    solid.mass *= longer * longer * scaling.factor(longer * steps.manual_step, longer * steps.stable_step);
    if (added != nullptr) *added += solid.mass - own;
    set_references(all, kind, x, solid);
  }
  const std::array<double, 8> shares = mass_shares(kind, nodes);
  for (std::size_t k = 0; k < 8; ++k) state.mass[nodes[k].value] += solid.mass * shares[k];
  nodes_.push_back(nodes);
  which_.push_back(properties);
  origin_.push_back(origin);
  rule_.push_back(kind.rule);
  first_point_.push_back(first_point_.back() + (has_eight_points(kind.rule) ? 8 : 1));
  state_.push_back(std::move(solid));
  return volume;
}

void SolidElements::begin_with(std::size_t solid, std::span<const PointState> points, const std::vector<Vector>& x) {
  points_.resize(first_point_.back());
  energy_.resize(size());
  std::copy(points.begin(), points.end(), points_.begin() + static_cast<std::ptrdiff_t>(first_point_[solid]));
  energy_[solid].initial = stored(solid, x);
}

void SolidElements::finish(std::size_t nodes) {
  points_.resize(first_point_.back());
  force_.assign(8 * size(), Vector::Zero());
  energy_.resize(size());
  failed_.assign(size(), 0);
  for (std::uint32_t i = 0; i < size(); ++i)
    if (const auto& n = nodes_[i]; rule_[i] == SolidRule::nodal_pressure)
      average_.add({n[0], n[1], n[2], n[3]}, which_[i], i);
  average_.finish(size());
  shares_.resize(average_.owners().size());
  table_ = corner_table(nodes, nodes_);
}

Summary SolidElements::update_one(const State& state, std::size_t solid) {
  if (failed_[solid] != 0) return {};
  SolidCorners corners = corners_of(state, nodes_[solid]);
  std::array<double, 4> strains;
  if (const auto position = static_cast<std::uint32_t>(solid); average_.has(position)) {
    strains = average_.strains(position);
    corners.volume_strains = &strains;
  }
  Summary summary;
  const std::uint32_t section = section_of(solid);
  SolidForces forces = section != no_position && sections_[section].active(state)
                           ? preloaded_forces(state, solid, corners, summary.supplied)
                           : forces_of(solid, corners, state.dt);
  const bool torn = tears(properties(solid), points(solid), ends_, state.time, corners, forces, state_[solid].weld);
  judge(solid, torn, forces, summary);
  summary.work = summary.supplied;
  exchange(
      forces, [&](std::size_t k) -> const Vector& { return corners.v[k]; }, state.dt, &force_[8 * solid], summary.work);
  return conclude(solid, forces, summary);
}

std::size_t SolidElements::end_of_batch(std::size_t first, std::size_t last) const {
  if (batched_[which_[first]] == 0) return first;
  const auto taken = [&](std::size_t solid) {
    return which_[solid] == which_[first] && rule_[solid] == SolidRule::one_point && failed_[solid] == 0 &&
           section_of(solid) == no_position && !points_[first_point_[solid]].failed &&
           !model::is_tetrahedron(nodes_[solid]);
  };
  std::size_t end = first;
  while (end < std::min(last, first + BrickBatch::capacity) && taken(end)) ++end;
  return end;
}

std::size_t SolidElements::update_some(const State& state, std::size_t first, std::size_t end, Summary& sum) {
  const std::size_t last = end_of_batch(first, end);
  if (last == first) {
    sum.add(update_one(state, first));
    return first + 1;
  }
  const SolidProperties& own = properties(first);
  BrickBatch batch;
  std::array<double, BrickBatch::capacity> plastic_work;
  for (std::size_t solid = first; solid < last; ++solid)
    batch.add(nodes_[solid], state, state_[solid], points_[first_point_[solid]]);
  batch.begin(own, state.dt);
  for (std::size_t solid = first; solid < last; ++solid)
    plastic_work[solid - first] =
        batch.integrate(solid - first, own, state.dt, state_[solid], points_[first_point_[solid]]);
  batch.end(own);
  for (std::size_t solid = first; solid < last; ++solid) {
    const std::size_t i = solid - first;
    SolidForces forces = batch.forces(i, state.dt, plastic_work[i]);
    Summary summary;
    judge(solid, has_failed(own, points(solid), ends_, state.time, forces), forces, summary);
    exchange(
        forces, [&](std::size_t k) { return batch.velocity(i, k); }, state.dt, &force_[8 * solid], summary.work);
    sum.add(conclude(solid, forces, summary));
  }
  return last;
}

void SolidElements::judge(std::size_t solid, bool fails_now, SolidForces& forces, Summary& summary) {
  if (fails_now) {
    failed_[solid] = 1;
    remove({&points_[first_point_[solid]], points(solid).size()}, state_[solid], forces);
    summary.failed = 1;
  } else if (forces.good) {
    set_steps(properties(solid).material, forces, state_[solid], summary);
  } else {
    summary.bad = static_cast<std::uint32_t>(solid);
  }
}

Summary SolidElements::conclude(std::size_t solid, const SolidForces& forces, Summary summary) {
  watched_.note(solid, summary.manual_step, summary.stable_step);
  note_work(forces, static_cast<std::uint32_t>(solid), summary);
  energy_[solid].add(summary);
  return summary;
}

SolidForces SolidElements::forces_of(std::size_t solid, const SolidCorners& corners, double dt) {
  const SolidKind kind{model::is_tetrahedron(nodes_[solid]), rule_[solid]};
  return forces_by_kind(properties_[which_[solid]], kind, corners, dt, state_[solid],
                        {&points_[first_point_[solid]], first_point_[solid + 1] - first_point_[solid]});
}

PointState SolidElements::point(std::size_t solid) const { return mean_of(points(solid)); }

double SolidElements::stored(std::size_t solid, const std::vector<Vector>& x) const {
  std::array<Vector, 8> places;
  for (std::size_t k = 0; k < 8; ++k) places[k] = x[nodes_[solid][k].value];
  return stored_at(solid, places);
}

double SolidElements::stored_at(std::size_t solid, const std::array<Vector, 8>& places) const {
  if (has_eight_points(rule_[solid]))
    return eight_point_energy(properties(solid), state_[solid], places, points(solid).first<8>());
  const double volume =
      model::is_tetrahedron(nodes_[solid]) ? tetrahedron_volume(places) : brick_volume(properties(solid), places);
  return stored_energy(properties(solid), state_[solid], volume, points_[first_point_[solid]]);
}

void SolidElements::watch_steps(const MassScaling& scaling, const State& /*state*/) {
  watched_.start(scaling, size());
  for (std::size_t i = 0; i < size(); ++i) watched_.mass[i] = state_[i].mass;
}

AddedMass SolidElements::keep_steps(State& state) {
  AddedMass added;
  watched_.grow_where_needed([&](std::size_t solid, double factor) {
    const double more = (factor - 1) * state_[solid].mass;
    const std::array<double, 8> shares =
        mass_shares({model::is_tetrahedron(nodes_[solid]), rule_[solid]}, nodes_[solid]);
    for (std::size_t k = 0; k < 8; ++k)
      if (shares[k] > 0) added.give(state, nodes_[solid][k].value, more * shares[k], 0);
    let_grow(state_[solid], factor);
    ++added.elements;
  });
  return added;
}

Summary SolidElements::update(const State& state) {
  if (ends_.share > 0 && ends_.least == 0) ends_.least = ends_.share * state.dt;
  if (!average_.empty()) average_volumes(state, nodes_, failed_, shares_, average_);
  for (SectionStress& section : sections_) section.imposed.stress = section.curve.at(state.time);
  return sum_over_blocks<Summary>(size(), [&](std::size_t begin, std::size_t end) {
    Summary sum;
    for (std::size_t i = begin; i < end;) i = update_some(state, i, end, sum);
    return sum;
  });
}

}  // namespace gapcheck::solver
