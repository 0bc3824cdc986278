#include "solver/step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapcheck::solver {
namespace {

/// Result of one pass over the nodes.
struct NodeSums {
  double kinetic = 0, printed_kinetic = 0, work = 0;
  std::uint32_t without_mass = no_position, not_a_number = no_position;
  void add(const NodeSums& other) {
    kinetic += other.kinetic;
    printed_kinetic += other.printed_kinetic;
    work += other.work;
    without_mass = std::min(without_mass, other.without_mass);
    not_a_number = std::min(not_a_number, other.not_a_number);
  }
};

/// One node's three translations or rotations while it is accelerated.
struct Freedoms {
  double mass;
  Vector &velocity, &net, &external;
  const Vector& before;  ///< external force at the start of the last step
};

/// Brings a velocity over `mean`, the mean of the steps before and after. `bits`: constrained directions, whose
/// velocity is `imposed(axis)` and whose reaction goes to the external force. In the first cycle the velocity before is
/// the one that leads to the initial velocity midway.
template <class Imposed>
void accelerate_node(const Freedoms& f, unsigned bits, const Imposed& imposed, double mean, double last_step,
                     bool first, NodeSums& sums) {
  const Vector old = f.velocity;
  const double per_force = f.mass > 0 ? mean / f.mass : 0;
  if (bits == 0 && f.mass > 0) f.velocity += per_force * f.net;
  for (int axis = 0; bits != 0 && axis < 3; ++axis) {
    if ((bits >> axis & 1u) != 0) {
      const double wanted = imposed(axis);
      const double reaction = f.mass * (wanted - old[axis]) / mean - f.net[axis];
      f.external[axis] += reaction;
      f.net[axis] += reaction;
      f.velocity[axis] = wanted;
    } else {
      f.velocity[axis] += per_force * f.net[axis];
    }
  }
  sums.printed_kinetic += f.mass / 2 * (first ? old.squaredNorm() : old.dot(f.velocity));
  sums.kinetic += f.mass / 2 * (first ? Vector(2 * old - f.velocity) : old).dot(f.velocity);
  sums.work += last_step / 2 * (f.before + f.external).dot(old);
}

/// The same in axes of the node's own.
template <class Imposed>
void accelerate_in_axes(const Matrix& axes, const Freedoms& f, unsigned bits, const Imposed& imposed, double mean,
                        double last_step, bool first, NodeSums& sums) {
  const Matrix local = axes.transpose();
  Vector velocity = local * f.velocity, net = local * f.net, external = local * f.external;
  const Vector before = local * f.before;
  accelerate_node({f.mass, velocity, net, external, before}, bits, imposed, mean, last_step, first, sums);
  f.velocity = axes * velocity;
  f.net = axes * net;
  f.external = axes * external;
}

/// ω² dt² of elements with this stable step at the coming one, at most: never less than at 0.9 of the stable step,
/// which other forces are tuned to, nor more than what keeps them stable.
double share_of_step(double stable_step, const State& state) {
  const double ratio = std::min(state.coming / stable_step, 1 / step_slack);
  return std::isfinite(ratio) ? std::max(usual_share, 4 * ratio * ratio) : usual_share;
}

/// Moved degrees of freedom move from the start.
void start_moving(Structure& structure) {
  State& state = structure.state;
  for (std::size_t i = 0; i < state.x.size(); ++i)
    for (std::size_t freedom = 0; freedom < 6; ++freedom) {
      if ((structure.constraints.mask(i, state.time, 0) >> freedom & 1u) == 0) continue;
      Vector& velocity = (freedom < 3 ? state.v : state.w)[i];
      const auto axis = static_cast<int>(freedom % 3);
      const double imposed = structure.constraints.velocity(i, freedom, state.time, 0);
      if (const Matrix* axes = structure.constraints.axes(i); axes != nullptr)
        velocity += (imposed - velocity.dot(axes->col(axis))) * axes->col(axis);
      else
        velocity[axis] = imposed;
    }
}

/// What the settings allow.
double limit_at(const StepSettings& settings, const State& state) {
  double limit = settings.greatest_step > 0 ? settings.greatest_step : std::numeric_limits<double>::infinity();
  if (settings.limit != nullptr) limit = std::min(limit, settings.limit->at(state.time));
  if (settings.first_step > 0 && state.cycle == 0) limit = std::min(limit, settings.first_step);
  return limit;
}

/// Moves what moves from the start of a dynamic relaxation, or of the run.
void begin_phase(Structure& structure) {
  structure.constraints.begin_phase(structure.state.relaxing);
  structure.rigid.begin_phase(structure.state.relaxing);
  start_moving(structure);
  structure.rigid.start(structure.state);
}

/// From the end of a relaxation to the start of the run.
void restart(Structure& structure, const InitialMotion& motion) {
  State& state = structure.state;
  state.v = motion.v;
  state.w = motion.w;
  for (std::size_t b = 0; b < motion.bodies.size(); ++b)
    structure.rigid.set_motion(b, motion.bodies[b][0], motion.bodies[b][1], state);
  state.relaxing = false;
  state.relaxed = true;
  state.time = state.dt = 0;
  state.cycle = 0;
  begin_phase(structure);
}

/// A failure if an element has lost its area, volume or length. `ids`: of the model's elements.
template <class Elements>
SolverStatus check_elements(const Summary& sum, const Elements& elements, const std::vector<std::int64_t>& ids,
                            std::string_view what, std::string_view fault, double time) {
  if (sum.bad == no_position) return {};
  const auto [lost, cause] = std::pair(fault.substr(0, fault.find(';')), fault.substr(fault.find(';') + 1));
  return Failure{Failure::Kind::bad_element, fmt::format("{} {} {} at time {:g}; look at what {} it", what,
                                                         ids[elements.origin(sum.bad)], lost, time, cause)};
}

SolverStatus check_elements(const Structure& structure, const Summary& shells, const Summary& solids,
                            const Summary& beams, const Summary& thick_shells) {
  const double time = structure.state.time;
  SolverStatus status =
      check_elements(shells, structure.shells, structure.shell_id, "shell", "has lost its area;pulls on", time);
  if (status.ok())
    status = check_elements(solids, structure.solids, structure.solid_id, "solid", "has no positive volume;presses on",
                            time);
  if (status.ok())
    status = check_elements(thick_shells, structure.thick_shells, structure.thick_shell_id, "thick shell",
                            "has lost its volume;presses on", time);
  if (status.ok())
    status = check_elements(beams, structure.beams, structure.beam_id, "beam", "has lost its length;presses on", time);
  return status;
}

}  // namespace

Stepper::Stepper(Structure structure, StepSettings settings) : structure_(std::move(structure)), settings_(settings) {
  const std::size_t nodes = structure_.state.x.size();
  structure_.shells.finish(nodes);
  structure_.solids.finish(nodes);
  structure_.beams.finish(nodes);
  structure_.thick_shells.finish(nodes);
  structure_.constraints.finish();
  if (settings_.scaling.step > 0) {
    structure_.shells.watch_steps(settings_.scaling, structure_.state);
    structure_.solids.watch_steps(settings_.scaling, structure_.state);
    structure_.beams.watch_steps(settings_.scaling, structure_.state);
  }
  for (Forces* forces : {&external_, &before_, &net_}) forces->resize(nodes, structure_.rigid.size());
  for (std::uint32_t i = 0; i < nodes; ++i)
    if (structure_.constraints.mask(i) != 0) constrained_.push_back(i);
  if (!constrained_.empty()) reaction_of_.assign(nodes, no_position);
  for (std::uint32_t k = 0; k < constrained_.size(); ++k) reaction_of_[constrained_[k]] = k;
  reactions_.assign(constrained_.size(), {Vector::Zero(), Vector::Zero()});
  begin_phase(structure_);
}

void Stepper::begin_run(const InitialMotion& motion, double time_step_factor) {
  work_ -= energies_.kinetic;
  settings_.time_step_factor = time_step_factor;
  restart(structure_, motion);
}

/// The step that the elements allow; notes which of them is the shortest.
double Stepper::element_step(const Summaries& all) {
  double least = std::numeric_limits<double>::infinity();
  control_ = {};
  const auto take = [&](double step, StepControl::Kind kind, std::uint32_t origin) {
    if (step >= least) return;
    least = step;
    control_ = {kind, origin};
  };
  const double factor = settings_.time_step_factor;
  const auto consider = [&](const Summary& part, const auto& elements, StepControl::Kind kind) {
    if (part.manual_at != no_position) take(factor * part.manual_step, kind, elements.origin(part.manual_at));
    if (part.stable_at != no_position && settings_.bounded_step)
      take(part.stable_step / step_slack, kind, elements.origin(part.stable_at));
  };
  consider(all.shells, structure_.shells, StepControl::Kind::shell);
  consider(all.solids, structure_.solids, StepControl::Kind::solid);
  consider(all.beams, structure_.beams, StepControl::Kind::beam);
  consider(all.thick_shells, structure_.thick_shells, StepControl::Kind::thick_shell);
  return least;
}

void Stepper::note_failures() {
  State& state = structure_.state;
  const auto note = [&](const auto& elements, std::vector<bool>& flags, StepControl::Kind kind) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const std::uint32_t origin = elements.origin(i);
      if (!elements.failed(i)) continue;
      if (origin >= flags.size()) flags.resize(std::size_t{origin} + 1, false);
      if (flags[origin]) continue;
      flags[origin] = true;
      failures_.push_back({kind, origin, state.time});
    }
  };
  note(structure_.shells, state.failed.shells, StepControl::Kind::shell);
  note(structure_.solids, state.failed.solids, StepControl::Kind::solid);
  note(structure_.beams, state.failed.beams, StepControl::Kind::beam);
  state.failed.count = failures_.size();
}

/// Adds mass to elements whose step is too small; they keep their velocity, so the energy of the mass is supplied.
/// Returns the step of all elements after that.
double Stepper::scale_masses(double next) {
  State& state = structure_.state;
  AddedMass added = structure_.shells.keep_steps(state);
  added.add(structure_.solids.keep_steps(state));
  added.add(structure_.beams.keep_steps(state));
  if (added.elements == 0) return next;
  structure_.added_mass += added.mass;
  if (state.cycle > 0) work_ += added.energy;  // at the start it is a part of the initial energy
  return std::max(next, settings_.scaling.step);
}

SolverStatus Stepper::evaluate(double& next) {
  State& state = structure_.state;
  const Summaries all{structure_.shells.update(state), structure_.solids.update(state), structure_.beams.update(state),
                      structure_.thick_shells.update(state)};
  const auto& [shells, solids, beams, thick_shells] = all;
  if (shells.failed + solids.failed + beams.failed > 0) note_failures();
  if (SolverStatus checked = check_elements(structure_, shells, solids, beams, thick_shells); !checked.ok())
    return checked;
  for (const Summary& part : {shells, solids, beams, thick_shells}) {
    energies_.internal += part.work - part.hourglass_work;
    energies_.hourglass += part.hourglass_work;
    energies_.bulk_viscosity += part.viscous_work;
    work_ += part.supplied;
  }
  std::swap(before_, external_);
  const std::size_t nodes = state.x.size();
  external_.resize(nodes, structure_.rigid.size());
  next = element_step(all);
  if (settings_.scaling.step > 0) {
    next = scale_masses(next);
    // Thick shells get their mass at the start only.
    next = std::min(next, settings_.time_step_factor * thick_shells.manual_step);
    if (settings_.bounded_step) next = std::min(next, thick_shells.stable_step / step_slack);
  }
  double limit = limit_at(settings_, state);
  // If all elements have failed, the last step stays.
  if (state.failed.count > 0 && !std::isfinite(next)) limit = std::min(limit, state.dt);
  state.coming = std::min(next, limit);
  const double by_manual =
      std::min({shells.manual_step, solids.manual_step, beams.manual_step, thick_shells.manual_step});
  state.manual_step = std::max(state.coming, std::min(settings_.time_step_factor * by_manual, limit));
  state.elements_share = share_of_step(
      std::min({shells.stable_step, solids.stable_step, beams.stable_step, thick_shells.stable_step}), state);
  for (const auto& other : others_) {
    other->add(state, external_);
    limit = std::min(limit, other->stable_step());
    if (SolverStatus status = other->status(); !status.ok()) return status;
  }
  if (!(limit >= next)) {
    next = limit;
    control_ = {};
  }
  // A step that follows every vibration of its elements feeds it: it knows their shape at its start only.
  if (state.dt > 0 && next > state.dt) next = std::max(state.dt, next / step_slack);
  if (!(next > settings_.least_step) || !std::isfinite(next))
    return Failure{Failure::Kind::zero_time_step,
                   fmt::format("the time step at time {:g} is {:g}; set a greatest step where no element limits it",
                               state.time, next)};
  net_.body_force = external_.body_force;
  net_.body_moment = external_.body_moment;
  parallel_for(nodes, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      net_.force[i] = external_.force[i];
      net_.moment[i] = external_.moment[i];
      structure_.shells.gather(i, net_.force[i], net_.moment[i]);
      structure_.solids.gather(i, net_.force[i]);
      structure_.beams.gather(i, net_.force[i], net_.moment[i]);
      structure_.thick_shells.gather(i, net_.force[i]);
    }
  });
  return {};
}

SolverStatus Stepper::accelerate(double next) {
  State& state = structure_.state;
  const bool first = state.cycle == 0;
  const double mean = (state.dt + next) / 2;
  for (const auto& other : others_)
    if (other->reacts()) other->react(state, mean, next, net_, external_);
  const auto sums = sum_over_blocks<NodeSums>(state.x.size(), [&](std::size_t begin, std::size_t end) {
    NodeSums sum;
    for (std::size_t i = begin; i < end; ++i) {
      const bool rigid = structure_.rigid.holds(i);  // moved by its body; other forces still do work on it
      const unsigned mask = rigid ? 0 : structure_.constraints.mask(i, state.time, next);
      const double mass = rigid ? 0 : state.mass[i], inertia = rigid ? 0 : state.inertia[i];
      const auto imposed = [&](std::size_t offset) {
        return [&, offset](int axis) {
          return structure_.constraints.velocity(i, offset + static_cast<std::size_t>(axis), state.time, next);
        };
      };
      const std::uint32_t held = reaction_of_.empty() ? no_position : reaction_of_[i];
      if (held != no_position) reactions_[held] = {-net_.force[i], -net_.moment[i]};
      const Freedoms moves{mass, state.v[i], net_.force[i], external_.force[i], before_.force[i]};
      const Freedoms turns{inertia, state.w[i], net_.moment[i], external_.moment[i], before_.moment[i]};
      if (const Matrix* axes = rigid ? nullptr : structure_.constraints.axes(i); axes != nullptr) {
        accelerate_in_axes(*axes, moves, mask & 7u, imposed(0), mean, state.dt, first, sum);
        accelerate_in_axes(*axes, turns, mask >> 3, imposed(3), mean, state.dt, first, sum);
      } else {
        accelerate_node(moves, mask & 7u, imposed(0), mean, state.dt, first, sum);
        accelerate_node(turns, mask >> 3, imposed(3), mean, state.dt, first, sum);
      }
      if (held != no_position) {
        reactions_[held][0] += net_.force[i];
        reactions_[held][1] += net_.moment[i];
      }
      const auto node = static_cast<std::uint32_t>(i);
      if (!std::isfinite(state.v[i].sum() + state.w[i].sum())) sum.not_a_number = std::min(sum.not_a_number, node);
      const bool loose = (!rigid && mass <= 0 && (mask & 7u) != 7u && net_.force[i] != Vector::Zero());
      if (loose) sum.without_mass = std::min(sum.without_mass, node);
    }
    return sum;
  });
  const BodyEnergies bodies = structure_.rigid.accelerate(state, net_, mean, next, first);
  for (const auto& other : others_) other->follow(state);
  energies_.kinetic = sums.kinetic + bodies.kinetic;
  energies_.printed_kinetic = std::max(sums.printed_kinetic + bodies.printed_kinetic, 0.0);
  work_ += sums.work + bodies.work;
  energies_.absorbed = {};
  for (const auto& other : others_) other->absorbed(energies_.absorbed);
  energies_.external = work_ + energies_.absorbed.sum();
  if (first) {
    energies_.initial += energies_.kinetic;
    energies_.printed_initial += energies_.printed_kinetic;
  }
  if (sums.not_a_number != no_position)
    return Failure{Failure::Kind::not_a_number, fmt::format("the velocity of node {} is not a number at time {:g}",
                                                            structure_.node_id[sums.not_a_number], state.time)};
  if (sums.without_mass != no_position)
    return Failure{Failure::Kind::zero_mass,
                   fmt::format("a force acts on node {}, which has no mass; give it one or hold it",
                               structure_.node_id[sums.without_mass])};
  return {};
}

std::array<Vector, 2> Stepper::reaction(std::size_t node) const {
  const std::uint32_t held = reaction_of_.empty() ? no_position : reaction_of_[node];
  return held == no_position ? std::array<Vector, 2>{Vector::Zero(), Vector::Zero()} : reactions_[held];
}

Absorbed Stepper::held() const {
  Absorbed energy;
  for (const auto& other : others_) other->held(energy);
  return energy;
}

SolverStatus Stepper::check_energy() {
  const Energies& e = energies_;
  largest_energy_ = std::max(largest_energy_,
                             std::abs(e.kinetic) + std::abs(e.internal) + std::abs(e.hourglass) + std::abs(e.external));
  const double excess = e.total() - e.initial - e.external;
  if (settings_.energy_tolerance <= 0 || std::abs(excess) <= settings_.energy_tolerance * largest_energy_) return {};
  // Viscous control lets hourglass modes creep: what turns or is pressed for long ends in them.
  const char* what_to_do =
      std::abs(e.hourglass) > std::abs(e.internal)
          ? "hourglass energy exceeds internal energy: try hourglass control by stiffness (IHQ = 4 "
            "or 5), or a smaller time step factor"
          : "try a smaller time step factor";
  return Failure{Failure::Kind::energy_ratio,
                 fmt::format("the energies at time {:g} are out of balance by {:g} (energy ratio {:g}); {}",
                             structure_.state.time, excess, e.ratio(), what_to_do)};
}

void Stepper::move(double next) {
  State& state = structure_.state;
  parallel_for(state.x.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) state.x[i] += next * state.v[i];
  });
  structure_.rigid.move(state, next);
  state.dt = next;
  state.time += next;
  ++state.cycle;
}

SolverStatus Stepper::begin_step() {
  if (SolverStatus evaluated = evaluate(next_); !evaluated.ok()) return evaluated;
  if (SolverStatus accelerated = accelerate(next_); !accelerated.ok()) return accelerated;
  return check_energy();
}

SolverStatus Stepper::step() {
  SolverStatus begun = begin_step();
  if (begun.ok()) end_step();
  return begun;
}

}  // namespace gapcheck::solver
