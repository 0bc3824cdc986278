#include "solver/output/run_states.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "solver/output/plot.hpp"

namespace gapcheck::solver {
namespace {

/// Acceleration of the next step.
Vector acceleration(const Vector& force, double mass) {
  return mass > 0 ? Vector(force / mass) : Vector(Vector::Zero());
}

void set_control(const Run& run, results::GlobalState& global) {
  const model::Mesh& mesh = run.model().mesh;
  const StepControl& control = run.stepper().control();
  const auto name = [&](const char* what, const auto& elements) {
    global.controlled_by = what;
    global.element = elements.id[control.element];
    global.part = run.model().part(elements.part[control.element]).id.value;
  };
  switch (control.kind) {
    case StepControl::Kind::shell:
      return name("shell", mesh.shells);
    case StepControl::Kind::solid:
      return name("solid", mesh.solids);
    case StepControl::Kind::beam:
      return name("beam", mesh.beams);
    case StepControl::Kind::thick_shell:
      return name("thick shell", mesh.thick_shells);
    case StepControl::Kind::other:
      global.controlled_by = "force";
  }
}

/// Mass scaling of all elements, in the run or at its start.
void set_added_mass(const Run& run, results::GlobalState& global) {
  global.mass_scaling = run.model().controls.dt2ms != 0;
  if (!global.mass_scaling) return;
  const State& state = run.stepper().state();
  double mass = 0;
  for (std::size_t i = 0; i < state.mass.size(); ++i)
    if (!state.in_body(i)) mass += state.mass[i];
  for (const BodyState& body : state.bodies) mass += body.mass;
  global.added_mass = run.stepper().structure().added_mass;
  if (mass > global.added_mass) global.added_percent = 100 * global.added_mass / (mass - global.added_mass);
}

/// Velocity of the centre of mass.
Vector global_velocity(const State& state) {
  double mass = 0;
  Vector momentum = Vector::Zero();
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    mass += state.mass[i];
    momentum += state.mass[i] * state.v[i];
  }
  return mass > 0 ? Vector(momentum / mass) : Vector(Vector::Zero());
}

/// One contact of two sources.
void add(const ContactState& part, ContactState& sum) {
  sum.force_a += part.force_a;
  sum.force_b += part.force_b;
  sum.moment_a += part.moment_a;
  sum.moment_b += part.moment_b;
  sum.energy_a += part.energy_a;
  sum.energy_b += part.energy_b;
  sum.friction += part.friction;
}

}  // namespace

results::GlobalState global_state(const Run& run) {
  const Stepper& stepper = run.stepper();
  const Energies& e = stepper.energies();
  results::GlobalState global;
  global.cycle = stepper.state().cycle + 1;
  global.time = stepper.state().time;
  global.time_step = stepper.next_step();
  global.kinetic = e.printed_kinetic;
  global.internal = e.printed_internal();
  global.hourglass = e.hourglass;
  global.springs = e.absorbed.springs;
  global.damping = e.absorbed.damping;
  global.sliding = e.absorbed.sliding();
  global.external = e.external;
  global.total = e.printed_total();
  global.ratio = global.ratio_without_eroded = e.printed_ratio();
  if (stepper.state().failed.count > 0) {
    for (const PartEnergy& part : part_energies(run.model(), stepper.structure())) {
      global.eroded_internal += part.eroded.printed_internal();
      global.eroded_hourglass += part.eroded.hourglass;
    }
    const double supplied = e.printed_initial + e.external;
    if (supplied != 0)
      global.ratio_without_eroded = (e.printed_total() - global.eroded_internal - global.eroded_hourglass) / supplied;
  }
  if (const RigidWalls* walls = run.conditions().walls; walls != nullptr)
    for (const WallState& wall : walls->states())
      global.walls.push_back({static_cast<std::int64_t>(wall.wall) + 1, wall.energy});
  global.velocity = global_velocity(stepper.state());
  set_control(run, global);
  set_added_mass(run, global);
  return global;
}

std::vector<results::PartState> part_states(const Run& run, const PartMasses& masses) {
  const std::vector<PartEnergy> energies = part_energies(run.model(), run.stepper().structure());
  const std::vector<PartMotion> motion = masses.motion(run.stepper().state());
  std::vector<results::PartState> parts;
  for (std::uint32_t i = 0; i < motion.size(); ++i) {
    results::PartState part;
    part.part = run.model().parts[i].id.value;
    part.internal = energies[i].present.printed_internal();
    part.hourglass = energies[i].present.hourglass;
    part.eroded_internal = energies[i].eroded.printed_internal();
    part.eroded_hourglass = energies[i].eroded.hourglass;
    part.kinetic = motion[i].kinetic;
    part.momentum = motion[i].momentum;
    if (run.model().rigid(PartIndex{i}) && motion[i].mass > 0) part.velocity = motion[i].momentum / motion[i].mass;
    parts.push_back(part);
  }
  return parts;
}

std::vector<results::NodeState> node_states(const Run& run, const NodeTurns* turns) {
  const Structure& structure = run.stepper().structure();
  const State& state = structure.state;
  const Forces& net = run.stepper().net();
  std::vector<results::NodeState> nodes;
  for (const model::HistoryNode& entry : run.model().output.history_nodes) {
    const std::uint32_t i = entry.node.value;
    const auto body = structure.rigid.body_of(i);
    results::NodeState node;
    node.node = run.model().mesh.nodes.id[i];
    node.position = state.x[i];
    node.displacement = state.x[i] - run.initial().x[i];
    node.velocity = state.v[i];
    node.acceleration =
        body ? structure.rigid.acceleration_at(*body, state.x[i]) : acceleration(net.force[i], state.mass[i]);
    if (turns != nullptr) node.rotation = turns->rotation(nodes.size());
    node.angular_velocity = state.w[i];
    node.angular_acceleration =
        body ? structure.rigid.response(*body).spin_rate : acceleration(net.moment[i], state.inertia[i]);
    nodes.push_back(node);
  }
  return nodes;
}

std::vector<results::InterfaceState> interface_states(const Run& run, bool transducers) {
  std::vector<const ContactState*> states;
  for (const ContactView& view : run.contacts()) states.push_back(&view.state());
  const std::vector<ContactState> measured = transducers ? run.transducers() : std::vector<ContactState>();
  for (const ContactState& state : measured) states.push_back(&state);
  std::stable_sort(states.begin(), states.end(),
                   [](const ContactState* a, const ContactState* b) { return a->contact < b->contact; });
  std::vector<results::InterfaceState> list;
  list.reserve(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    ContactState state = *states[i];
    for (; i + 1 < states.size() && states[i + 1]->contact == state.contact; ++i) add(*states[i + 1], state);
    results::InterfaceState contact;
    contact.contact = run.model().contact(state.contact).id.value;
    contact.single_surface = state.single_surface;
    contact.force = {state.force_a, state.force_b};
    contact.moment = {state.moment_a, state.moment_b};
    contact.energy = {state.energy_a, state.energy_b};
    contact.friction = state.friction;
    list.push_back(contact);
  }
  return list;
}

std::optional<std::vector<results::NodeForce>> node_forces(const Run& run, ContactIndex contact,
                                                           const NodeAreas& areas) {
  const model::Contact& card = run.model().contact(contact);
  const auto& cards = run.model().contacts;
  const bool all =
      std::none_of(cards.begin(), cards.end(), [](const model::Contact& c) { return c.print_a || c.print_b; });
  const std::vector<ContactView> views = run.contacts();
  const bool calculated =
      std::any_of(views.begin(), views.end(), [&](const ContactView& view) { return view.state().contact == contact; });
  if (!calculated || !(all || card.print_a || card.print_b)) return std::nullopt;
  std::map<std::pair<NodeIndex, std::size_t>, Vector> forces;
  const auto add = [&](const ContactPoint& point, const Vector& force, bool side_b) {
    if (!all && !(side_b ? card.print_b : card.print_a)) return;
    for (std::size_t i = 0; i < 4; ++i)
      if (point.weights[i] != 0)
        forces.try_emplace({point.nodes[i], side_b ? 1u : 0u}, Vector::Zero()).first->second +=
            point.weights[i] * force;
  };
  for (const ContactView& view : views) {
    if (view.state().contact != contact) continue;
    std::vector<ContactLink> links;
    view.source->links(view.position, links);
    const bool single = view.state().single_surface;
    for (const ContactLink& link : links) {
      add(link.tracked, link.force, link.exchanged && !single);
      add(link.reference, -link.force, !link.exchanged && !single);
    }
  }
  const State& state = run.stepper().state();
  std::vector<results::NodeForce> list;
  for (const auto& [place, force] : forces) {
    const auto& [node, side] = place;
    list.push_back({run.model().mesh.nodes.id[node.value], side, force, state.x[node.value],
                    areas.pressure(contact, side, node, force, state.x)});
  }
  return list;
}

}  // namespace gapcheck::solver
