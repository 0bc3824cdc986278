#include "solver/tie/tie_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "base/parallel.hpp"
#include "base/quad.hpp"
#include "contact/stiffness/element_sizes.hpp"
#include "contact/stiffness/stiffness.hpp"
#include "solver/contact/contact_method.hpp"
#include "solver/interface/contact_spring.hpp"
#include "solver/tie/tie_stability.hpp"

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
    : model_(model), store_(surfaces), initial_(initial), structure_(&structure) {
  const std::vector<Tie> ties = tie_list(model, surfaces, initial, structure, false);
  for (const Tie& tie : ties) {
    Spring& spring = springs_.emplace_back();
    spring.tie = tie;
    spring.percent = std::max(0.0, model.contact(tie.contact).vdc);
  }
  interfaces_ = tie_ranges(model, ties, false);
  for (const TieRange& interface : interfaces_) states_.emplace_back().contact = interface.contact;
}

/// Strengths of a tiebreak's ties as forces: stresses count with the area of the node, or of the segment if the node is
/// given without segments.
void TieForces::find_strength(const TieRange& interface, const contact::SideScene& side, const std::vector<Vector>& x) {
  const model::Contact& contact = model_.contact(interface.contact);
  if (choose_method(contact).method != ContactMethod::tiebreak) return;
  const contact::Segments& own = side.tracked().selection.segments;
  std::unordered_map<std::uint32_t, double> areas;
  for (const model::SegmentNodes& corners : own.nodes) {
    const std::size_t count = contact::corner_count(corners);
    for (std::size_t i = 0; i < count; ++i)
      areas[corners[i].value] += contact::shell_area(corners, x) / static_cast<double>(count);
  }
  const bool forces = contact.kind->code == model::ContactCode::tiebreak_nodes;
  constexpr std::int64_t linear_damage = 6;
  for (std::size_t i = interface.first; i < interface.last; ++i) {
    Spring& spring = springs_[i];
    const Tie& tie = spring.tie;
    const auto found = areas.find(tie.node.value);
    const double area = forces ? 1 : found != areas.end() ? found->second : contact::shell_area(tie.point.nodes, x);
    const model::TiebreakStrength& card = contact.tiebreak;
    const double opening = contact.tiebreak_option == linear_damage ? card.param : 0;
    spring.strength = {card.normal * area, card.shear * area, card.normal_power, card.shear_power, opening, 1};
    // Old types use the order of the segment's nodes, automatic ones the side on which the node lies.
    const SegmentAxes axes(tie.point.nodes, x);
    const double height = axes.axes.col(2).dot(x[tie.node.value] - tie.point.of(x));
    constexpr double on_the_surface = 1e-6;  // of the segment's size: facets that touch
    if (contact.kind->automatic_tiebreak() &&
        height < -on_the_surface * std::sqrt(contact::shell_area(tie.point.nodes, x)))
      spring.strength.side = -1;
  }
}

void TieForces::tell_ends(const TieRange& interface, double time) {
  std::vector<std::int64_t> failed;
  for (std::size_t i = interface.first; i < interface.last; ++i) {
    Spring& spring = springs_[i];
    if (spring.told || (!spring.damage.broken && !interface.over(time))) continue;
    spring.told = true;
    if (released_) released_(spring.tie.node, spring.tie.segment_part);
    if (spring.damage.broken) failed.push_back(model_.mesh.nodes.id[spring.tie.node.value]);
  }
  if (!failed.empty()) events_.push_back({interface.contact, time, failed_ties(failed)});
}

void TieForces::build(const State& state) {
  built_ = true;
  const ContactMasses masses(model_);
  StiffnessCache tables;
  TieStability stability(*structure_);
  double ratio = 0;
  for (const TieRange& interface : interfaces_) {
    const model::Contact& contact = model_.contact(interface.contact);
    const contact::ContactSurfaces& surfaces = store_.at(interface.contact);
    const contact::SideScene side(model_, interface.contact, surfaces, false, initial_.x);
    ContactSprings springs(model_, side, masses, contact.sfs, contact.sfm, tables);
    const double timestep = contact.dtstif > 0 ? contact.dtstif : state.manual_step;
    springs.set_timestep(timestep);
    find_strength(interface, side, state.x);
    const std::vector<NodeIndex>& nodes = side.scene().nodes.node;
    for (std::size_t i = interface.first; i < interface.last; ++i) {
      Spring& spring = springs_[i];
      const Tie& tie = spring.tie;
      const auto slot = std::lower_bound(nodes.begin(), nodes.end(), tie.node) - nodes.begin();
      const ContactSprings::Spring found = springs(to_index<SlotIndex>(static_cast<std::size_t>(slot)), tie.segment);
      spring.stiffness = std::isfinite(found.stiffness) ? std::max(0.0, found.stiffness) : 0;
      if (spring.stiffness == 0)  // no modulus is known on either side
        spring.stiffness = contact.sofscl * contact::soft_1_stiffness(found.node_mass, found.segment_mass, timestep);
      if (tie.rotations) spring.rotational = spring.stiffness * squared_radius(tie, *structure_);
      spring.damping = ContactSprings::damping(found, spring.percent);
      ratio = std::max(ratio, spring.percent / 100);
      const SegmentAxes axes(tie.point.nodes, state.x);
      stability.add(tie, axes, state.x[tie.node.value] - tie.point.of(state.x), spring.stiffness, spring.rotational);
    }
  }
  const bool limited = state.coming > 0 && std::isfinite(state.coming);
  const double room = 4 / (shortest_step * shortest_step) - state.elements_share;
  const std::vector<double> shares = stability.shares(limited ? room / damped(ratio) / (state.coming * state.coming)
                                                              : std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    springs_[i].stiffness *= shares[2 * i];
    springs_[i].rotational *= shares[2 * i + 1];
    springs_[i].damping *= std::sqrt(shares[2 * i]);
  }
  squared_frequency_ = damped(ratio) * stability.squared_frequency(shares);
  structure_ = nullptr;
}

/// The node's rotation relative to the segment grows, and turns with the segment.
void TieForces::turn(Spring& spring, const State& state) {
  const Tie& tie = spring.tie;
  const SegmentAxes middle(tie.point.nodes, state.x, state.v, -state.dt / 2);
  const Vector turn = motion(tie, middle, state.v, state.w).turn;
  const Vector of_segment = state.w[tie.node.value] - turn;
  spring.turned = spin_rotation(state.dt * of_segment) * spring.turned + state.dt * turn;
}

void TieForces::calculate(Spring& spring, const State& state, bool active) {
  const Tie& tie = spring.tie;
  const double half = state.dt / 2;
  spring.on_node = -half * spring.loads.on_node(tie, state);
  spring.on_segment = -half * spring.loads.on_segment(tie, state);
  spring.damped = 0;
  spring.lost = 0;
  if (!active || spring.damage.broken) {
    spring.loads = {};
    spring.active = false;
    spring.lost = std::exchange(spring.stored, 0);
    return;
  }
  const SegmentAxes axes(tie.point.nodes, state.x);
  const TieMotion moving = motion(tie, axes, state.v, state.w);
  if (!spring.active) {
    spring.active = true;
    spring.offset.start(tie, axes, state.x);
    spring.turned = Vector::Zero();
  } else {
    spring.offset.move(tie, axes, moving.spin, state.dt);
    if (tie.rotations) turn(spring, state);
  }
  const Vector arm = state.x[tie.node.value] - tie.point.of(state.x);
  const Vector velocity = moving.velocity - moving.spin.cross(spring.offset.value());
  const Vector stretch = arm - spring.offset.value();
  Vector force = -spring.stiffness * stretch, damping = -spring.damping * velocity;
  if (spring.strength.limited()) {
    const Vector normal = axes.sound ? Vector(axes.axes.col(2)) : Vector(Vector::Zero());
    // Compression does no damage.
    const Vector pressed = std::min(0.0, spring.strength.side * stretch.dot(normal)) * spring.strength.side * normal;
    const double share = spring.damage.share(spring.strength, force, normal, (stretch - pressed).norm());
    // Compression stays in full until the tie is gone.
    const double push = spring.damage.broken ? 0 : std::max(0.0, spring.strength.side * force.dot(normal));
    const Vector whole = spring.strength.side * push * normal;
    force = share * (force - whole) + whole;
    damping *= share;
  }
  spring.stored = (spring.stiffness * stretch.squaredNorm() + spring.rotational * spring.turned.squaredNorm()) / 2;
  spring.loads.set(tie, axes, arm, force + damping, -spring.rotational * spring.turned);
  if (spring.damage.broken) spring.active = false;
  spring.damped = -state.dt * damping.dot(velocity);
  spring.on_node -= half * spring.loads.on_node(tie, state);
  spring.on_segment -= half * spring.loads.on_segment(tie, state);
}

void TieForces::add(State& state, Forces& forces) {
  if (springs_.empty()) return;
  if (!built_) build(state);
  coming_ = state.coming;
  elements_share_ = state.elements_share;
  if (state.failed.count != failures_)
    for (Spring& spring : springs_)
      spring.damage.broken = spring.damage.broken || segment_gone(spring.tie, state.failed);
  failures_ = state.failed.count;
  for (std::size_t i = 0; i < interfaces_.size(); ++i) {
    const TieRange& interface = interfaces_[i];
    const bool active = interface.active(state.time);
    parallel_for(interface.last - interface.first, 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) calculate(springs_[interface.first + s], state, active);
    });
    tell_ends(interface, state.time);
    ContactState& result = states_[i];
    result.force_a = result.force_b = result.moment_a = result.moment_b = Vector::Zero();
    result.touching = 0;
    for (std::size_t s = interface.first; s < interface.last; ++s) {
      const Spring& spring = springs_[s];
      result.touching += spring.active;
      spring.loads.add_to(spring.tie, forces);
      spring.loads.add_to(spring.tie, state, result);
      result.energy_a += spring.on_node;
      result.energy_b += spring.on_segment;
      result.damping += spring.damped;
      result.lost += spring.lost;
    }
  }
}

std::optional<double> TieForces::stored(std::size_t position) const {
  const TieRange& interface = interfaces_[position];
  double sum = 0;
  for (std::size_t i = interface.first; i < interface.last; ++i) {
    if (springs_[i].strength.limited()) return std::nullopt;
    sum += springs_[i].stored;
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
    work.contact_normal += state.energy_a + state.energy_b - state.damping;
  }
}

std::vector<ContactNode> TieForces::nodes(std::size_t position) const {
  std::vector<ContactNode> all;
  for (std::size_t s = interfaces_[position].first; s < interfaces_[position].last; ++s) {
    if (!springs_[s].active && !springs_[s].damage.broken) continue;
    ContactNode& node = all.emplace_back();
    node.kind = springs_[s].damage.broken ? ContactNode::Kind::broken : ContactNode::Kind::tied;
    node.node = springs_[s].tie.node;
    node.segment = springs_[s].tie.point.nodes;
    node.force = springs_[s].loads.force;
  }
  return all;
}

void TieForces::links(std::size_t position, std::vector<ContactLink>& links) const {
  for (std::size_t s = interfaces_[position].first; s < interfaces_[position].last; ++s) {
    if (!springs_[s].active) continue;
    ContactLink& link = links.emplace_back();
    link.tracked = {{springs_[s].tie.node}, {1}};
    link.reference = springs_[s].tie.point;
    link.force = springs_[s].loads.force;
  }
}

std::vector<ContactEvent> TieForces::take_events() { return std::exchange(events_, {}); }

}  // namespace gapcheck::solver
