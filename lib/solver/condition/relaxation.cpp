#include "solver/condition/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/condition/wall_impulse.hpp"
#include "solver/state/summary.hpp"

namespace gapcheck::solver {
namespace {

constexpr std::string_view relaxation_keyword = "CONTROL_DYNAMIC_RELAXATION";

Failure refused_relaxation(Failure::Kind kind, const std::string& why, model::Place place) {
  return Failure{kind, fmt::format("*{}: {}", relaxation_keyword, why), place};
}

SolverStatus check_values(const model::Controls& controls) {
  const auto fail = [&](const std::string& why) {
    return refused_relaxation(Failure::Kind::contradiction, why, controls.relaxation_place);
  };
  if (controls.nrcyck < 1) return fail(fmt::format("NRCYCK = {} must be 1 or more cycles", controls.nrcyck));
  if (!(controls.drtol > 0) || !(controls.drtol < 1))
    return fail(fmt::format("DRTOL = {:g} is no ratio of energies; set a number between 0 and 1", controls.drtol));
  if (!(controls.drterm >= 0))
    return fail(fmt::format("DRTERM = {:g} is below 0; set a time above 0", controls.drterm));
  const bool slows = controls.drfctr > 0 && controls.drfctr < 1;
  if (!slows && !(controls.drfctr == 1 && controls.drterm > 0))
    return fail(
        fmt::format("DRFCTR = {:g} takes no energy from the motion; set a number between 0 and 1, or 1 with an "
                    "end in DRTERM",
                    controls.drfctr));
  if (!(controls.tssfdr >= 0)) return fail(fmt::format("TSSFDR = {:g} is below 0; set 0.9 or less", controls.tssfdr));
  return {};
}

SolverStatus check_moving(const model::Model& model) {
  for (const model::RigidWall& wall : model.rigid_walls)
    if (wall.moving)
      return Failure{
          Failure::Kind::not_calculated,
          fmt::format("*{}: wall {} moves, which is not calculated together with a dynamic relaxation; use a "
                      "wall at rest or a rigid body",
                      wall.keyword, wall.id),
          wall.place};
  for (const model::Material& material : model.materials) {
    if (!material.discrete_beam) continue;
    const auto& cable = material.discrete_beam->cable;
    if (cable.force != 0 || cable.shortening != 0 || cable.start != 0 || cable.ramp != 0)
      return Failure{Failure::Kind::not_calculated,
                     fmt::format("*{}: the preload of cable material {} is not calculated together with a dynamic "
                                 "relaxation; set F0 and FRACL0 to 0",
                                 material.keyword, material.id),
                     material.place};
  }
  return {};
}

/// Mass, momentum and kinetic energy of nodes.
struct MovingMass {
  double mass = 0, energy = 0;
  Vector momentum = Vector::Zero();
  void add(const MovingMass& other) {
    mass += other.mass;
    energy += other.energy;
    momentum += other.momentum;
  }
};

struct DampedWork {
  double value = 0;
  void add(const DampedWork& other) { value += other.value; }
};

/// Without the components in imposed directions; `bits`: three of them.
Vector unimposed(Vector v, unsigned bits) {
  for (int axis = 0; axis < 3; ++axis)
    if ((bits >> axis & 1u) != 0) v[axis] = 0;
  return v;
}

}  // namespace

bool relaxes(const model::Model& model) {
  const std::int64_t flag = model.controls.idrflg;
  if (flag != 0) return flag == 1;
  return std::any_of(model.curves.begin(), model.curves.end(),
                     [](const auto& entry) { return entry.second.relaxation == 1 || entry.second.relaxation == 2; });
}

SolverResult<RelaxationSettings> relaxation_settings(const model::Model& model) {
  const model::Controls& controls = model.controls;
  for (const SolverStatus& status : {check_values(controls), check_moving(model)})
    if (!status.ok()) return status.error();
  RelaxationSettings settings;
  settings.check_every = static_cast<std::uint64_t>(controls.nrcyck);
  settings.tolerance = controls.drtol;
  settings.factor = controls.drfctr;
  if (controls.drterm > 0) settings.end = controls.drterm;
  settings.time_step_factor = controls.tssfdr > 0 ? controls.tssfdr : controls.tssfac;
  return settings;
}

std::int64_t unfinished_curve(const model::Model& model, double time) {
  std::int64_t least = 0;
  for (const auto& [id, curve] : model.curves) {
    if (curve.relaxation != 1) continue;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const bool changes = curve.points[i][1] != curve.points[i - 1][1];
      if (changes && curve.points[i][0] * curve.abscissa_time > time && (least == 0 || id < least)) least = id;
    }
  }
  return least;
}

double distortional_energy(const Structure& structure) {
  const State& state = structure.state;
  const auto all = sum_over_blocks<MovingMass>(state.x.size(), [&](std::size_t begin, std::size_t end) {
    MovingMass sum;
    for (std::size_t i = begin; i < end; ++i) {
      if (structure.rigid.holds(i)) continue;
      sum.mass += state.mass[i];
      sum.momentum += state.mass[i] * state.v[i];
      sum.energy += state.mass[i] / 2 * state.v[i].squaredNorm() + state.inertia[i] / 2 * state.w[i].squaredNorm();
    }
    return sum;
  });
  return all.mass > 0 ? std::max(all.energy - all.momentum.squaredNorm() / (2 * all.mass), 0.0) : 0;
}

bool RelaxationCheck::ends(const Structure& structure) {
  energy_ = distortional_energy(structure);
  peak_ = std::max(peak_, energy_);
  const State& state = structure.state;
  converged_ = state.cycle > 0 && state.cycle % settings_.check_every == 0 && ratio() < settings_.tolerance;
  return converged_ || state.time >= settings_.end;
}

void RelaxationDamping::react(const State& state, double mean, double next, Forces& net, Forces& external) {
  if (!state.relaxing) return;
  if (last_.force.empty()) last_.resize(state.x.size(), state.bodies.size());
  const double lost = (1 - factor_) / mean, half = state.dt / 2;
  work_ -= sum_over_blocks<DampedWork>(state.x.size(), [&](std::size_t begin, std::size_t end) {
             DampedWork sum;
             for (std::size_t i = begin; i < end; ++i) {
               if (structure_.rigid.holds(i)) continue;
               const unsigned mask = structure_.constraints.mask(i, state.time, next);
               const Matrix* axes = structure_.constraints.axes(i);
               const FreeDirections moves{mask & 7u, axes}, turns{mask >> 3, axes};
               const Vector force = -lost * moves(state.mass[i] * state.v[i] + mean * net.force[i]);
               const Vector moment = -lost * turns(state.inertia[i] * state.w[i] + mean * net.moment[i]);
               sum.value +=
                   half * ((last_.force[i] + force).dot(state.v[i]) + (last_.moment[i] + moment).dot(state.w[i]));
               last_.force[i] = force;
               last_.moment[i] = moment;
               net.force[i] += force;
               net.moment[i] += moment;
               external.force[i] += force;
               external.moment[i] += moment;
             }
             return sum;
           }).value;
  damp_bodies(state, mean, next, net, external);
}

void RelaxationDamping::damp_bodies(const State& state, double mean, double next, Forces& net, Forces& external) {
  const double lost = (1 - factor_) / mean, half = state.dt / 2;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const BodyState& body = state.bodies[b];
    const BodyLoad load = structure_.rigid.load_on(b, state, net, next);
    const unsigned imposed = load.imposed.freedoms;
    const Vector force = -lost * unimposed(body.mass * body.velocity + mean * load.force, imposed & 7u);
    const Vector moment = -lost * unimposed(body.angular_momentum + mean * load.torque, imposed >> 3);
    work_ -= half * ((last_.body_force[b] + force).dot(body.velocity) + (last_.body_moment[b] + moment).dot(body.spin));
    last_.body_force[b] = force;
    last_.body_moment[b] = moment;
    net.body_force[b] += force;
    net.body_moment[b] += moment;
    external.body_force[b] += force;
    external.body_moment[b] += moment;
  }
}

}  // namespace gapcheck::solver
