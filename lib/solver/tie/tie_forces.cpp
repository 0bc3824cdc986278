#include "solver/tie/tie_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.hpp"
#include "base/quad.hpp"
#include "contact/definition/friction.hpp"
#include "contact/stiffness/stiffness.hpp"
#include "solver/interface/contact_spring.hpp"
#include "solver/tie/tie_stick.hpp"

namespace gapcheck::solver {
namespace {

/// How far springs may shorten the elements' step before they are softened.
constexpr double shortest_step = 0.5;

/// Factor of a spring's squared frequency that makes it as bad for the step as it is with this share of the critical
/// damping.
double damped(double ratio) {
  const double root = std::sqrt(1 + ratio * ratio) + ratio;  // 1 / (√(1 + r²) - r), which cancels
  return root * root;
}

/// Squared radius of gyration of the node's rotation, or of the segment's nodes if the node is on a rigid body; of
/// shells' nodes if both are.
double squared_radius(const Tie& tie, const Structure& structure) {
  const State& state = structure.state;
  const auto of_node = [&](NodeIndex node) {
    const std::uint32_t n = node.value;
    return structure.rigid.holds(n) || !(state.mass[n] > 0) ? 0 : state.inertia[n] / state.mass[n];
  };
  if (const double own = of_node(tie.node); own > 0) return own;
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += tie.point.weights[i] * of_node(tie.point.nodes[i]);
  if (sum > 0) return sum;
  constexpr double share_of_area = 8;  // of the rotational inertia of shells
  return quad_normal(tie.point.nodes, state.x).norm() / 2 / share_of_area;
}

}  // namespace

TieForces::TieForces(const model::Model& model, contact::SurfaceStore& surfaces, const contact::InitialState& initial,
                     const Structure& structure)
    : model_(model), store_(surfaces), initial_(initial), structure_(structure), stability_(structure) {
  const std::vector<Tie> ties = tie_list(model, surfaces, initial, structure, false);
  for (const TieRange& range : tie_ranges(model, ties, false)) {
    Interface& interface = interfaces_.emplace_back();
    interface.range = range;
    for (std::size_t i = range.first; i < range.last; ++i) {
      TieSpring& spring = interface.springs.emplace_back();
      spring.tie = ties[i];
      spring.percent = std::max(0.0, model.contact(range.contact).vdc);
    }
    states_.emplace_back().contact = range.contact;
  }
}

void TieForces::tell_ends(Interface& interface, double time) {
  std::vector<std::int64_t> failed;
  for (TieSpring& spring : interface.springs) {
    if (spring.told || (!spring.damage.broken && !interface.range.over(time))) continue;
    spring.told = true;
    if (released_) released_(spring.tie.node, spring.tie.segment_part);
    if (!spring.strength.limited()) interface.has_stuck.erase(spring.tie.node.value);
    if (spring.damage.broken) failed.push_back(model_.mesh.nodes.id[spring.tie.node.value]);
  }
  if (!failed.empty()) events_.push_back({interface.range.contact, time, failed_ties(failed)});
}

void TieForces::build_springs(Interface& interface, const ContactMasses& masses, StiffnessCache& tables,
                              const State& state) {
  const ContactIndex c = interface.range.contact;
  const model::Contact& contact = model_.contact(c);
  const contact::ContactSurfaces& surfaces = store_.at(c);
  const contact::SideScene side(model_, c, surfaces, false, initial_.x);
  ContactSprings springs(model_, side, masses, contact.sfs, contact.sfm, tables);
  const double timestep = contact.dtstif > 0 ? contact.dtstif : state.manual_step;
  springs.set_timestep(timestep);
  auto strengths = std::make_unique<TieStrengths>(model_, c, side.tracked().selection.segments, state.x);
  const std::vector<NodeIndex>& nodes = side.scene().nodes.node;
  for (TieSpring& spring : interface.springs) {
    const Tie& tie = spring.tie;
    spring.strength = strengths->of(tie, state.x);
    const auto slot = std::lower_bound(nodes.begin(), nodes.end(), tie.node) - nodes.begin();
    const ContactSprings::Spring found = springs(to_index<SlotIndex>(static_cast<std::size_t>(slot)), tie.segment);
    spring.stiffness = std::isfinite(found.stiffness) ? std::max(0.0, found.stiffness) : 0;
    if (spring.stiffness == 0)  // no modulus is known on either side
      spring.stiffness = contact.sofscl * contact::soft_1_stiffness(found.node_mass, found.segment_mass, timestep);
    if (const double given = strengths->stiffness(spring.strength); given > 0) spring.stiffness = given;
    if (tie.rotations) spring.rotational = spring.stiffness * squared_radius(tie, structure_);
    spring.damping = ContactSprings::damping(found, spring.percent);
    ratio_ = std::max(ratio_, spring.percent / 100);
    const SegmentAxes axes(tie.point.nodes, state.x);
    stability_.add(tie, axes, state.x[tie.node.value] - tie.point.of(state.x),
                   spring.stiffness * std::max(1.0, spring.strength.stiffness_ratio), spring.rotational);
  }
  if (!ties_stick(contact) || contact::ties_by_constraint(surfaces.type)) return;
  interface.strengths = std::move(strengths);
  for (const TieSpring& spring : interface.springs) interface.has_stuck.insert(spring.tie.node.value);
}

void TieForces::build(const State& state) {
  built_ = true;
  const ContactMasses masses(model_);
  StiffnessCache tables;
  for (Interface& interface : interfaces_) {
    build_springs(interface, masses, tables, state);
    let_slide(interface);
  }
  const bool limited = state.coming > 0 && std::isfinite(state.coming);
  const double room = 4 / (shortest_step * shortest_step) - state.elements_share;
  shares_ = stability_.shares(limited ? room / damped(ratio_) / (state.coming * state.coming)
                                      : std::numeric_limits<double>::infinity());
  std::size_t next = 0;
  for (Interface& interface : interfaces_)
    for (TieSpring& spring : interface.springs) {
      spring.stiffness *= shares_[next];
      spring.damping *= std::sqrt(shares_[next]);
      spring.rotational *= shares_[next + 1];
      next += 2;
    }
  squared_frequency_ = damped(ratio_) * stability_.squared_frequency(shares_);
}

/// Nodes of OPTION 4, whose ties have friction across the normal.
void TieForces::let_slide(Interface& interface) {
  const model::Contact& contact = model_.contact(interface.range.contact);
  if (!ties_slide(contact)) return;
  const contact::ContactSurfaces& surfaces = store_.at(interface.range.contact);
  const contact::ContactSide& reference = surfaces.two_sided() ? surfaces.b : surfaces.a;
  sliding_.push_back(std::make_unique<contact::SlidingSurface>(reference.selection.segments));
  const contact::Friction friction(model_, contact);
  for (TieSpring& spring : interface.springs) {
    const bool plain = contact.tiebreak.param == 1;
    spring.slide = TieSlide(*sliding_.back(), friction.between(none<PartIndex>, spring.tie.segment_part),
                            plain ? contact.tiebreak.shear * spring.strength.area : 0);
  }
}

/// Nodes of OPTION 1 and 3 that contact has stopped in this cycle. The step follows their springs, which are as stiff
/// as those of the contact.
void TieForces::let_stick(Interface& interface, const State& state) {
  if (!interface.strengths || !touches_ || !interface.range.active(state.time)) return;
  const ContactIndex c = interface.range.contact;
  const model::Contact& contact = model_.contact(c);
  bool any = false;
  for (const Touch& touch : touches_(c)) {
    if (!interface.has_stuck.insert(touch.node.value).second) continue;
    Tie tie = tie_at(contact, store_.at(c).type, false, touch.node, touch.point, state.x, structure_);
    tie.contact = c;
    tie.segment_part = touch.segment_part;
    tie.element_kind = touch.element_kind;
    tie.element = touch.element;
    TieSpring spring = stuck_spring(contact, tie, touch, *interface.strengths, state);
    ratio_ = std::max(ratio_, spring.percent / 100);
    const SegmentAxes axes(tie.point.nodes, state.x);
    stability_.add(tie, axes, state.x[tie.node.value] - tie.point.of(state.x), spring.stiffness, 0);
    shares_.insert(shares_.end(), {1.0, 1.0});
    if (held_) held_(tie.node, tie.segment_part);
    interface.springs.push_back(std::move(spring));
    any = true;
  }
  if (any) squared_frequency_ = damped(ratio_) * stability_.squared_frequency(shares_);
}

void TieForces::add(State& state, Forces& forces) {
  if (interfaces_.empty()) return;
  if (!built_) build(state);
  coming_ = state.coming;
  elements_share_ = state.elements_share;
  if (state.failed.count != failures_)
    for (Interface& interface : interfaces_)
      for (TieSpring& spring : interface.springs)
        if (segment_gone(spring.tie, state.failed)) spring.damage.end();
  failures_ = state.failed.count;
  for (std::size_t i = 0; i < interfaces_.size(); ++i) {
    Interface& interface = interfaces_[i];
    const bool active = interface.range.active(state.time);
    parallel_for(interface.springs.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) advance(interface.springs[s], state, active);
    });
    tell_ends(interface, state.time);
    ContactState& result = states_[i];
    result.force_a = result.force_b = result.moment_a = result.moment_b = Vector::Zero();
    result.touching = 0;
    for (const TieSpring& spring : interface.springs) {
      result.touching += spring.active;
      spring.loads.add_to(spring.tie, forces);
      spring.loads.add_to(spring.tie, state, result);
      result.energy_a += spring.on_node;
      result.energy_b += spring.on_segment;
      result.damping += spring.damped;
      result.friction += spring.rubbed;
      result.lost += spring.lost;
    }
    let_stick(interface, state);
  }
}

std::optional<double> TieForces::stored(std::size_t position) const {
  double sum = 0;
  for (const TieSpring& spring : interfaces_[position].springs) {
    if (spring.strength.limited() || spring.slide.slides()) return std::nullopt;
    sum += spring.stored;
  }
  return sum;
}

double TieForces::stable_step() const {
  const double of_elements = std::isfinite(coming_) && coming_ > 0 ? elements_share_ / (coming_ * coming_) : 0;
  const double squared = of_elements + squared_frequency_;
  const bool cut = squared_frequency_ > (4 - elements_share_) / elements_share_ * of_elements;
  return cut ? 2 * (of_elements > 0 ? 1 : std::sqrt(elements_share_) / 2) / std::sqrt(squared)
             : std::numeric_limits<double>::infinity();
}

void TieForces::absorbed(Absorbed& work) const {
  for (const ContactState& state : states_) {
    work.contact_damping += state.damping;
    work.contact_friction += state.friction;
    work.contact_normal += state.energy_a + state.energy_b - state.damping - state.friction;
  }
}

std::vector<ContactNode> TieForces::nodes(std::size_t position) const {
  std::vector<ContactNode> all;
  for (const TieSpring& spring : interfaces_[position].springs) {
    if (!spring.active && !spring.damage.broken) continue;
    ContactNode& node = all.emplace_back();
    node.kind = spring.damage.broken ? ContactNode::Kind::broken : ContactNode::Kind::tied;
    node.node = spring.tie.node;
    node.segment = spring.tie.point.nodes;
    node.force = spring.loads.force;
  }
  return all;
}

void TieForces::links(std::size_t position, std::vector<ContactLink>& links) const {
  for (const TieSpring& spring : interfaces_[position].springs) {
    if (!spring.active) continue;
    ContactLink& link = links.emplace_back();
    link.tracked = {{spring.tie.node}, {1}};
    link.reference = spring.tie.point;
    link.force = spring.loads.force;
  }
}

std::vector<ContactEvent> TieForces::take_events() { return std::exchange(events_, {}); }

}  // namespace gapcheck::solver
