#include "solver/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/stiffness/contact_timestep.hpp"
#include "contact/surface/erosion.hpp"
#include "contact/tie/ties.hpp"
#include "solver/build/build_forces.hpp"
#include "solver/check_deck.hpp"
#include "solver/condition/conditions.hpp"
#include "solver/constraint/constraint_contact.hpp"
#include "solver/contact/contact_method.hpp"
#include "solver/interpolation/find_followers.hpp"
#include "solver/interpolation/follower_forces.hpp"
#include "solver/mortar/mortar_stiffness.hpp"
#include "solver/tie/tie_constraints.hpp"
#include "solver/tie/tie_forces.hpp"

namespace gapcheck::solver {
namespace {

/// The end of the run as given by caller or deck.
SolverResult<double> end_of_run(const model::Model& model, const RunSettings& settings) {
  const double time = settings.until > 0 ? settings.until : model.controls.endtim;
  if (time > 0 && std::isfinite(time)) return time;
  if (settings.cycles > 0) return std::numeric_limits<double>::infinity();
  return Failure{Failure::Kind::no_end, "the deck gives no end time; set ENDTIM of *CONTROL_TERMINATION, or --until"};
}

/// By node: nothing holds it, so the shooting-node logic may move it.
std::vector<bool> movable_nodes(const Structure& structure) {
  constexpr unsigned translations = 7;
  std::vector<bool> movable(structure.state.x.size());
  for (std::size_t i = 0; i < movable.size(); ++i)
    movable[i] = !structure.rigid.holds(i) && (structure.constraints.mask(i) & translations) != translations;
  return movable;
}

/// Constraint ties and constraint contacts know the degrees of freedom of the global axes only.
SolverStatus check_supports(const model::Model& model, const Structure& structure) {
  const NodeIndex node = structure.constraints.first_with_axes();
  if (node == none<NodeIndex>) return {};
  const auto refused = [&](std::string_view what, model::Place place) {
    return Failure{
        Failure::Kind::not_calculated,
        fmt::format("{} and conditions in local axes, as those of node {}, are not calculated in one run; give "
                    "the conditions in the global axes",
                    what, structure.node_id[node.value]),
        place};
  };
  for (const model::Contact& contact : model.contacts) {
    if (choose_method(contact).method == ContactMethod::constraint)
      return refused(fmt::format("contact {} (*{}), which acts by constraints,", contact.id.value, contact.written),
                     contact.place);
    if (contact::ties_by_constraint(contact::classify(contact)))
      return refused(fmt::format("contact {} (*{}), which ties by constraints,", contact.id.value, contact.written),
                     contact.place);
  }
  return {};
}

/// Constraint ties act after rigid walls, and may move on what a wall has stopped.
void name_tied_nodes_at_walls(const model::Model& model, const contact::InitialState& initial,
                              Diagnostics& diagnostics) {
  if (model.rigid_walls.empty()) return;
  const auto nodes = std::count_if(initial.judged.begin(), initial.judged.end(), [&](const contact::JudgedNode& node) {
    return node.tied() && !node.penalty && contact::ties_by_constraint(contact::classify(model.contact(node.contact)));
  });
  if (nodes > 0)
    diagnostics.warning(
        "", 0,
        fmt::format("rigid walls do not stop the {} nodes that constraints tie; tie what meets a wall by "
                    "a type with _OFFSET or _BEAM_OFFSET",
                    nodes));
}

/// Names the contacts whose springs the run's step does not bear: nothing in LS-DYNA or here shortens the step for
/// them.
void name_unstable_springs(const model::Model& model, contact::SurfaceStore& surfaces, Diagnostics& diagnostics) {
  // Against nodes as light the limit is that of a vibration of both; what exceeds it by less has not been seen to grow.
  constexpr double clearly = 1.1;
  const std::vector<ContactIndex> all = positions<ContactIndex>(model.contacts.size()).list();
  const contact::PredictedTimesteps steps = contact::predict_timesteps(model, surfaces, all);
  for (const contact::UnstableSide& side : steps.unstable) {
    const double limit = side.limit.timestep;
    if (!(steps.run > (side.alone ? 1 : clearly) * limit)) continue;
    const SurfaceTimestep& surface = steps.timesteps.surface_timesteps[side.surface];
    const model::Contact& contact = model.contacts[surface.contact];
    diagnostics.warning(
        model.file(contact.place), contact.place.line,
        fmt::format("*{}: the springs of contact {}, side {}, are stable below a step of {:.4g} (node {}), but the "
                    "elements allow {:.4g}; set TSSFAC of *CONTROL_TIMESTEP to {:.2g}, or scale {} by {:.2g}",
                    contact.written, contact.id.value, surface.side, limit, model.mesh.nodes.id[side.limit.node.value],
                    steps.run, model.controls.tssfac * limit / steps.run, surface.side == 'A' ? "SFSA" : "SFSB",
                    std::pow(limit / steps.run, 2)));
  }
}

/// The curve that limits the step, LCTM; nullptr: there is none.
SolverResult<std::shared_ptr<const TimeCurve>> step_limit(const model::Model& model) {
  const model::Controls& controls = model.controls;
  if (controls.lctm == 0) return std::shared_ptr<const TimeCurve>();
  const auto fail = [&](Failure::Kind kind, std::string_view why) {
    return Failure{kind, fmt::format("*CONTROL_TIMESTEP: curve {} (LCTM) {}", controls.lctm, why),
                   controls.timestep_place};
  };
  const auto curve = model.curves.find(controls.lctm);
  if (curve == model.curves.end() || curve->second.points.empty())
    return fail(Failure::Kind::unknown_reference, "is not defined by a *DEFINE_CURVE; define it or set LCTM to 0");
  std::vector<TimeCurve::Point> points = curve->second.points;
  double last = -std::numeric_limits<double>::infinity();
  for (auto& [time, step] : points) {
    if (!(time >= last) || !std::isfinite(time))
      return fail(Failure::Kind::contradiction, "has times that do not rise");
    if (!(step > 0)) return fail(Failure::Kind::contradiction, "has a step that is not above 0");
    last = time;
    time *= curve->second.abscissa_time;
  }
  return std::make_shared<const TimeCurve>(std::move(points));
}

/// The springs of SOFT = 2 follow the step of the elements. Without elements they would have no stiffness.
SolverStatus check_stiffness_by_step(const model::Model& model) {
  for (const model::Contact& contact : model.contacts)
    if (contact::classify(contact).pairing == contact::Pairing::segments && !(contact.dtstif > 0))
      return Failure{
          Failure::Kind::contradiction,
          fmt::format("contact {} (*{}) takes its stiffness from the time step (SOFT = 2), which nothing but "
                      "rigid bodies has; set SOFT = 0, DTSTIF on card C or DTINIT of *CONTROL_TIMESTEP",
                      contact.id.value, contact.written),
          contact.place};
  return {};
}

/// Convergence is judged by the motion of deformable parts.
SolverStatus check_masses(const Structure& structure, const RelaxationSettings& settings) {
  if (std::isfinite(settings.end)) return {};
  const State& state = structure.state;
  for (std::size_t i = 0; i < state.x.size(); ++i)
    if (!structure.rigid.holds(i) && state.mass[i] > 0) return {};
  return Failure{Failure::Kind::contradiction,
                 "the dynamic relaxation ends when deformable parts come to rest, and there are none; give it an end "
                 "by DRTERM of *CONTROL_DYNAMIC_RELAXATION"};
}

/// The least step of mortar contacts between rigid bodies; infinity: there is none.
double step_of_mortar(const model::Model& model, contact::SurfaceStore& surfaces, Structure& structure) {
  double least = std::numeric_limits<double>::infinity();
  structure.rigid.start(structure.state);
  const ContactMasses masses(model);
  for (const ContactIndex c : positions<ContactIndex>(model.contacts.size())) {
    const model::Contact& contact = model.contact(c);
    if (contact::classify(contact).pairing != contact::Pairing::mortar) continue;
    const MortarSurface surface(model, masses, contact, surfaces.at(c), structure.state.x);
    least = std::min(least, MortarStiffness(surface).step_of_bodies(structure.state));
  }
  return least;
}

/// Rigid parts alone allow any step: the least of DTINIT, LCTM at the start, and what the contact springs allow. 0:
/// none.
double step_without_elements(const model::Model& model, contact::SurfaceStore& surfaces, Structure& structure) {
  double least = 0;
  const auto take = [&](double step) {
    if (step > 0 && (least == 0 || step < least)) least = step;
  };
  const model::Controls& controls = model.controls;
  take(controls.dtinit);
  if (const auto curve = model.curves.find(controls.lctm); controls.lctm != 0 && curve != model.curves.end())
    take(curve->second.at(0));
  const std::vector<ContactIndex> all = positions<ContactIndex>(model.contacts.size()).list();
  take(controls.tssfac * contact::predict_timesteps(model, surfaces, all).timesteps.contact_timestep);
  if (const double step = step_of_mortar(model, surfaces, structure); std::isfinite(step)) take(controls.tssfac * step);
  return least;
}

}  // namespace

template <class Contacts>
void Run::add_contacts(std::unique_ptr<Contacts> contacts) {
  if (!contacts) return;
  sources_.push_back(contacts.get());
  stepper_->add(std::move(contacts));
}

SolverResult<Run> Run::prepare(const model::Model& model, contact::SurfaceStore& surfaces, const RunSettings& settings,
                               Diagnostics& diagnostics) {
  Run run;
  run.model_ = &model;
  run.settings_ = settings;
  if (settings.cycles == 0 && model.controls.endcyc > 0)
    run.settings_.cycles = static_cast<std::uint64_t>(model.controls.endcyc);
  const auto end = end_of_run(model, run.settings_);
  if (!end) return end.error();
  run.end_time_ = end.value();
  if (const SolverStatus checked = check_deck(model, surfaces, diagnostics); !checked.ok()) return checked.error();
  contact::InitialCounters counters;
  run.initial_ = std::make_unique<contact::InitialState>(
      contact::initialise_contacts(model, surfaces, contact::InitialOptions{}, counters));
  for (const std::string& note : run.initial_->notes) diagnostics.warning("", 0, note);
  if (const SolverStatus faces = check_tied_faces(model, *run.initial_); !faces.ok()) return faces.error();
  BuildSettings build = settings.build;
  if (build.x == nullptr) build.x = &run.initial_->x;
  auto structure = build_structure(model, build, diagnostics);
  if (!structure) return structure.error();
  StepSettings step = settings.step;
  step.time_step_factor = model.controls.tssfac;
  step.first_step = model.controls.dtinit;
  if (model.controls.ms1st == 0) step.scaling = MassScaling(model.controls);
  auto limit = step_limit(model);
  if (!limit) return limit.error();
  step.limit = std::move(limit).value();
  Structure& built = structure.value();
  if (built.shells.size() + built.solids.size() + built.thick_shells.size() == 0 && !built.beams.limit_step() &&
      !(step.greatest_step > 0)) {
    step.greatest_step = step_without_elements(model, surfaces, built);
    if (!(step.greatest_step > 0))
      if (const SolverStatus stiff = check_stiffness_by_step(model); !stiff.ok()) return stiff.error();
  }
  std::vector<std::unique_ptr<Force>> forces;
  if (const SolverStatus applied = apply_conditions(model, built, forces, diagnostics); !applied.ok())
    return applied.error();
  if (settings.relax && relaxes(model)) {
    auto relaxation = relaxation_settings(model);
    if (!relaxation) return relaxation.error();
    run.relaxation_.emplace(relaxation.value());
    step.time_step_factor = relaxation.value().time_step_factor;
    run.motion_ = hold_back(built);
    if (const SolverStatus judged = check_masses(built, relaxation.value()); !judged.ok()) return judged.error();
  }
  if (const SolverStatus known = check_supports(model, built); !known.ok()) return known.error();
  if (const SolverStatus added = add_walls_and_springs(model, built, forces, diagnostics); !added.ok())
    return added.error();
  auto followers = find_followers(model, surfaces, *run.initial_, built, diagnostics);
  if (!followers) return followers.error();
  // A side effect of eroding contacts in the solver.
  if (std::any_of(model.contacts.begin(), model.contacts.end(),
                  [](const model::Contact& c) { return contact::is_eroding(contact::classify(c)); }))
    built.solids.let_inverted_fail();
  if (model.controls.erode == 1 && model.controls.dtmin > 0)
    built.solids.let_small_steps_fail(model.controls.dtmin, model.controls.tssfac);
  name_tied_nodes_at_walls(model, *run.initial_, diagnostics);
  if (step.limit == nullptr && settings.springs == SpringFormula::documented)
    name_unstable_springs(model, surfaces, diagnostics);
  auto constraints = ConstraintContact::create(model, surfaces, *run.initial_, built, movable_nodes(built));
  if (auto* failure = std::get_if<Failure>(&constraints)) return std::move(*failure);
  auto contacts =
      std::make_unique<ContactForces>(model, surfaces, *run.initial_, movable_nodes(built), settings.springs);
  contacts->log_shot_nodes(settings.shot);
  run.contacts_ = contacts.get();
  ContactForces* const after = contacts.get();
  const auto release = [after, kept = std::get<std::unique_ptr<ConstraintContact>>(constraints).get()](NodeIndex node,
                                                                                                       PartIndex part) {
    after->release(node, part);
    if (kept != nullptr) kept->release(node, part);
  };
  run.transducers_ = std::make_unique<Transducers>(model, surfaces);
  run.stepper_ = std::make_unique<Stepper>(std::move(built), step);
  const Structure& stepped = run.stepper_->structure();
  // First: what reacts after it reacts to the damped motion.
  if (run.relaxation_) {
    auto damping = std::make_unique<RelaxationDamping>(stepped, run.relaxation_->settings().factor);
    run.damping_ = damping.get();
    run.stepper_->add(std::move(damping));
  }
  run.add_contacts(std::move(contacts));
  auto springs = std::make_unique<TieForces>(model, surfaces, *run.initial_, stepped);
  springs->on_failure(release);
  springs->on_touch([after](ContactIndex c) { return after->touches(c); },
                    [after](NodeIndex node, PartIndex part) { after->hold(node, part); });
  run.add_contacts(std::move(springs));
  run.add_contacts(std::move(std::get<std::unique_ptr<ConstraintContact>>(constraints)));
  for (auto& force : forces) {
    if (const auto* walls = dynamic_cast<const RigidWalls*>(force.get())) run.conditions_.walls = walls;
    if (const auto* loads = dynamic_cast<const ConcentratedLoads*>(force.get())) run.conditions_.loads = loads;
    if (const auto* pressures = dynamic_cast<const Pressures*>(force.get())) run.conditions_.pressures = pressures;
    if (const auto* discrete = dynamic_cast<const Springs*>(force.get())) run.conditions_.springs = discrete;
    if (const auto* airbags = dynamic_cast<const Airbags*>(force.get())) run.conditions_.airbags = airbags;
    run.stepper_->add(std::move(force));
  }
  // Last: they hold regardless of all other forces.
  if (!followers.value().empty())
    run.stepper_->add(std::make_unique<FollowerForces>(std::move(followers).value(), model, stepped));
  auto ties = std::make_unique<TieConstraints>(model, surfaces, *run.initial_, stepped, diagnostics);
  ties->on_failure(release);
  run.add_contacts(std::move(ties));
  return run;
}

std::vector<ContactView> Run::contacts() const {
  std::vector<ContactView> views;
  for (const ContactSource* source : sources_)
    for (std::size_t i = 0; i < source->states().size(); ++i) views.push_back({source, i});
  std::stable_sort(views.begin(), views.end(),
                   [](const ContactView& a, const ContactView& b) { return a.state().contact < b.state().contact; });
  return views;
}

std::optional<RunEnd> Run::end_reached() const {
  const State& state = stepper_->state();
  if (state.time >= end_time_) return RunEnd::time;
  if (settings_.cycles > 0 && state.cycle >= settings_.cycles) return RunEnd::cycles;
  const model::Controls& controls = model_->controls;
  if (controls.endeng > 0 && std::abs(stepper_->energies().ratio() - 1) > controls.endeng / 100) return RunEnd::energy;
  if (controls.dtmin > 0 && stepper_->next_step() < controls.dtmin * first_step_) return RunEnd::step;
  if (settings_.stop && settings_.stop()) return settings_.stop_means;
  return std::nullopt;
}

SolverStatus Run::check_length(double end) const {
  constexpr double most_cycles = 1e12;  // years, of the smallest model
  const double left = end - stepper_->state().time, step = stepper_->next_step();
  if (settings_.cycles > 0 || left < most_cycles * step) return {};
  return Failure{Failure::Kind::zero_time_step,
                 fmt::format("with the time step {:g} the run would not come to its end at {:g}; look at the smallest "
                             "element, its material and TSSFAC",
                             step, end)};
}

InitialMotion Run::hold_back(Structure& structure) {
  State& state = structure.state;
  InitialMotion motion{state.v, state.w, {}};
  for (std::size_t b = 0; b < structure.rigid.size(); ++b) {
    motion.bodies.push_back({structure.rigid[b].velocity(), structure.rigid[b].angular_velocity()});
    structure.rigid.set_motion(b, Vector::Zero(), Vector::Zero(), state);
  }
  std::fill(state.v.begin(), state.v.end(), Vector::Zero());
  std::fill(state.w.begin(), state.w.end(), Vector::Zero());
  state.relaxing = true;
  return motion;
}

void Run::take_events() {
  for (ContactSource* source : sources_)
    for (ContactEvent& event : source->take_events()) events_.push_back(std::move(event));
}

std::optional<RunEnd> Run::relax() {
  const State& state = stepper_->state();
  while (true) {
    status_ = stepper_->begin_step();
    take_events();
    if (status_.ok() && std::isfinite(relaxation_->settings().end)) status_ = check_length(relaxation_->settings().end);
    if (!status_.ok()) return RunEnd::failed;
    if (settings_.stop && settings_.stop()) return settings_.stop_means;
    if (settings_.cycles > 0 && state.cycle >= settings_.cycles) return RunEnd::cycles;
    if (relaxation_->ends(stepper_->structure())) break;
    stepper_->end_step();
  }
  relaxed_ = Relaxed{state.cycle, state.time, relaxation_->ratio(), relaxation_->converged(),
                     unfinished_curve(*model_, state.time)};
  damping_->stop(stepper_->energies().kinetic);
  stepper_->begin_run(motion_, model_->controls.tssfac);
  return std::nullopt;
}

RunEnd Run::go(Observer& observer) {
  start_ = std::chrono::steady_clock::now();
  if (relaxation_)
    if (const std::optional<RunEnd> end = relax()) {
      if (SolverStatus observed = observer.observe(*this, end); !observed.ok()) status_ = std::move(observed);
      return status_.ok() ? *end : RunEnd::failed;
    }
  while (true) {
    status_ = stepper_->begin_step();
    if (stepper_->state().cycle > 0) events_.clear();  // the first cycle keeps those of a relaxation
    take_events();
    if (stepper_->state().cycle == 0) first_step_ = stepper_->next_step();
    if (status_.ok()) status_ = check_length(end_time_);
    const std::optional<RunEnd> end = status_.ok() ? end_reached() : RunEnd::failed;
    if (SolverStatus observed = observer.observe(*this, end); !observed.ok()) {
      status_ = std::move(observed);
      return RunEnd::failed;
    }
    if (end) return *end;
    stepper_->end_step();
  }
}

double Run::seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

}  // namespace gapcheck::solver
