#include "solver/tie/tie_constraints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/parallel.hpp"

namespace gapcheck::solver {
namespace {

/// Turning the arms over the step converges by the angle per step; this many iterations are more than enough.
constexpr int most_turning_rounds = 8;
constexpr double settled = 1e-13;
bool turns_with_axes(const Tie& tie) { return tie.rotation == Turning::axes || tie.rotation == Turning::drill; }

/// Rounding moves a node less than this share of its segment from its position.
constexpr double largest_drift = 1e-6;

}  // namespace

TieConstraints::TieConstraints(const model::Model& model, contact::SurfaceStore& surfaces,
                               const contact::InitialState& initial, const Structure& structure,
                               Diagnostics& diagnostics)
    : structure_(structure), ties_(tie_list(model, surfaces, initial, structure, true)) {
  keep_sound(model, diagnostics);
  interfaces_ = tie_ranges(model, ties_, true);
  active_.assign(interfaces_.size(), false);
  for (const TieRange& interface : interfaces_) states_.emplace_back().contact = interface.contact;
  for (const Tie& tie : ties_) varying_ = varying_ || tie.carries || turns_with_axes(tie);
  if (ties_.empty()) return;
  const std::size_t nodes = structure.state.x.size();
  system_ = std::make_unique<TieSystem>(ties_, nodes);
  nodes_.start(ties_, nodes);
  present_.resize(ties_.size());
  for (std::size_t t = 0; t < ties_.size(); ++t)
    equations_.push_back({&ties_[t], &present_[t].axes, Vector::Zero(), false});
  weak_ = TieFailures(model, surfaces, interfaces_, ties_, structure.state.x);
}

void TieConstraints::keep_sound(const model::Model& model, Diagnostics& diagnostics) {
  const State& state = structure_.state;
  const auto weightless = [&](NodeIndex node) {
    return !has_mass(state.mass[node.value]) && (structure_.constraints.mask(node.value) & 7u) != 7u;
  };
  const auto any_of = [](const Tie& tie, const auto& is) {
    if (is(tie.node)) return true;
    for (std::size_t i = 0; i < 4; ++i)
      if (tie.point.weights[i] != 0 && is(tie.point.nodes[i])) return true;
    return false;
  };
  std::map<ContactIndex, std::array<std::size_t, 2>> left_out;
  std::erase_if(ties_, [&](const Tie& tie) {
    const bool rigid = any_of(tie, [&](NodeIndex node) { return structure_.rigid.holds(node.value); });
    if (!rigid && !any_of(tie, weightless)) return false;
    ++left_out[tie.contact][rigid ? 0 : 1];
    untied_.emplace_back(tie.node, tie.segment_part);
    return true;
  });
  for (const auto& [c, numbers] : left_out) {
    const model::Contact& contact = model.contact(c);
    const auto warn = [&](std::size_t count, std::string_view why) {
      if (count > 0)
        diagnostics.warning(model.file(contact.place), contact.place.line,
                            fmt::format("contact {}: {} nodes stay untied, since {}", contact.id.value, count, why));
    };
    warn(numbers[0], "they or their segments move with a rigid body or weld; use an OFFSET form");
    warn(numbers[1], "they or nodes of their segments have no mass; give them one");
  }
}

bool TieConstraints::activate(const State& state) {
  bool changed = weak_.take_news() || state.failed.count != failures_;
  if (changed)
    for (std::size_t t = 0; t < ties_.size(); ++t)
      present_[t].gone = weak_.failed(t) || segment_gone(ties_[t], state.failed);
  failures_ = state.failed.count;
  for (std::size_t i = 0; i < interfaces_.size(); ++i) {
    const bool active = interfaces_[i].active(state.time);
    changed = changed || active != active_[i];
    active_[i] = active;
    for (std::size_t t = interfaces_[i].first; t < interfaces_[i].last; ++t)
      equations_[t].active = active && !present_[t].gone;
  }
  return changed;
}

/// Axes, offsets and arms at the beginning of the step.
void TieConstraints::place(const State& state) {
  parallel_for(ties_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const Tie& tie = ties_[t];
      Present& present = present_[t];
      if (!equations_[t].active) {
        present.started = false;
        continue;
      }
      present.axes = SegmentAxes(tie.point.nodes, state.x);
      if (present.started)
        present.offset.move(tie, present.axes, motion(tie, present.axes, state.v, state.w).spin, state.dt);
      else
        present.offset.start(tie, present.axes, state.x);
      present.started = true;
      const Vector arm = state.x[tie.node.value] - tie.point.of(state.x);
      if (tie.carries) equations_[t].arm = arm;
      // Anything that has moved a node without velocity, like a shooting node, has moved its target too.
      const double size = arm.norm() + (state.x[tie.point.nodes[2].value] - state.x[tie.point.nodes[0].value]).norm();
      if (!((arm - present.offset.value()).norm() <= largest_drift * size))
        present.offset.start(tie, present.axes, state.x);
    }
  });
}

/// The right sides of the equations: the positions at the end of the step, with the arms turned by the velocities with
/// ties, and the rotation of the axes in the middle of the step.
Eigen::VectorXd TieConstraints::targets(const State& state, double next) {
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(system_->size()));
  parallel_for(ties_.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (!equations_[t].active) continue;
      const Tie& tie = ties_[t];
      const Vector arm = state.x[tie.node.value] - tie.point.of(state.x);
      Vector velocity = Vector::Zero();
      if (tie.carries) {
        const Vector spin = motion(tie, present_[t].axes, nodes_.v(), nodes_.w()).spin;
        TieOffset offset = present_[t].offset;
        offset.move(tie, SegmentAxes(tie.point.nodes, state.x, nodes_.v(), next), spin, next);
        velocity = (offset.value() - arm) / next - spin.cross(arm);
      } else {
        velocity = (present_[t].offset.value() - arm) / next;
      }
      const auto row = static_cast<Eigen::Index>(system_->row(t));
      wanted.segment<3>(row) = velocity;
      if (turns_with_axes(tie)) {
        const SegmentAxes middle(tie.point.nodes, state.x, nodes_.v(), next / 2);
        wanted.segment<3>(row + 3) = segment_spin(tie.rotation, tie.point, middle, nodes_.v(), nodes_.w()) -
                                     segment_spin(tie.rotation, tie.point, present_[t].axes, nodes_.v(), nodes_.w());
      }
    }
  });
  return wanted;
}

/// Loads of all ties, and the velocities with them.
void TieConstraints::put(const Eigen::VectorXd& lambda, double mean) {
  nodes_.start_from_free();
  for (std::size_t t = 0; t < ties_.size(); ++t) {
    const Tie& tie = ties_[t];
    TieLoads& loads = present_[t].loads;
    const auto row = static_cast<Eigen::Index>(system_->row(t));
    const Vector force = lambda.segment<3>(row) / mean;
    const Vector moment = tie.rotations ? Vector(lambda.segment<3>(row + 3) / mean) : Vector(Vector::Zero());
    loads.set(tie, present_[t].axes, equations_[t].arm, force, moment);
    nodes_.push(tie.node, loads.force, loads.moment, mean);
    for (std::size_t i = 0; i < 4; ++i) nodes_.push(tie.point.nodes[i], loads.forces[i], loads.moments[i], mean);
  }
}

void TieConstraints::sum_up(const State& state, Forces& net, Forces& external) {
  for (std::size_t i = 0; i < interfaces_.size(); ++i) {
    const TieRange& interface = interfaces_[i];
    ContactState& result = states_[i];
    result.force_a = result.force_b = result.moment_a = result.moment_b = Vector::Zero();
    result.touching = 0;
    for (std::size_t t = interface.first; t < interface.last; ++t) {
      result.touching += equations_[t].active;
      const TieLoads& loads = present_[t].loads;
      if (equations_[t].active) weak_.check(t, loads.force, present_[t].axes);
      loads.add_to(ties_[t], net);
      loads.add_to(ties_[t], external);
      loads.add_to(ties_[t], state, result);
      result.energy_a -= state.dt / 2 * loads.on_node(ties_[t], state);
      result.energy_b -= state.dt / 2 * loads.on_segment(ties_[t], state);
    }
  }
}

void TieConstraints::name_dependent(double time) {
  for (const TieRange& interface : interfaces_) {
    std::size_t count = 0;
    for (std::size_t t = interface.first; t < interface.last; ++t) {
      const std::size_t last = t + 1 < ties_.size() ? system_->row(t + 1) : system_->size();
      count += static_cast<std::size_t>(
          std::count(system_->dependent().begin() + static_cast<std::ptrdiff_t>(system_->row(t)),
                     system_->dependent().begin() + static_cast<std::ptrdiff_t>(last), true));
    }
    if (count > 0)
      events_.push_back(
          {interface.contact, time,
           fmt::format("{} equations of ties follow from others or\n     contradict them and are left out.", count)});
  }
}

void TieConstraints::tell_ends(double time) {
  for (const TieRange& interface : interfaces_) {
    std::vector<std::int64_t> failed;
    for (std::size_t t = interface.first; t < interface.last; ++t) {
      Present& present = present_[t];
      if (present.told || (!present.gone && !interface.over(time))) continue;
      present.told = true;
      if (released_) released_(ties_[t].node, ties_[t].segment_part);
      if (present.gone) failed.push_back(structure_.node_id[ties_[t].node.value]);
    }
    if (!failed.empty()) events_.push_back({interface.contact, time, failed_ties(failed)});
  }
}

void TieConstraints::react(const State& state, double mean, double next, Forces& net, Forces& external) {
  for (const auto& [node, part] : std::exchange(untied_, {}))
    if (released_) released_(node, part);
  if (ties_.empty()) return;
  // Work in the last step by the forces at its start; that of the forces at its end follows in sum_up().
  for (std::size_t i = 0; i < interfaces_.size(); ++i)
    for (std::size_t t = interfaces_[i].first; t < interfaces_[i].last; ++t) {
      states_[i].energy_a -= state.dt / 2 * present_[t].loads.on_node(ties_[t], state);
      states_[i].energy_b -= state.dt / 2 * present_[t].loads.on_segment(ties_[t], state);
    }
  const bool other_ties = activate(state);
  tell_ends(state.time);
  place(state);
  const bool fresh = nodes_.hold(structure_, state.time, next) || other_ties;
  if (fresh || varying_) system_->set(equations_, nodes_.mobility(), fresh);
  if (fresh) name_dependent(state.time);
  nodes_.let_free(structure_, mean, next, net);
  Eigen::VectorXd at_rest(static_cast<Eigen::Index>(system_->size()));
  for (std::size_t t = 0; t < ties_.size(); ++t) {
    const TieMotion free = motion(ties_[t], present_[t].axes, nodes_.free_v(), nodes_.free_w());
    const auto row = static_cast<Eigen::Index>(system_->row(t));
    const Vector spin = ties_[t].carries ? free.spin : Vector(Vector::Zero());
    at_rest.segment<3>(row) = free.velocity - spin.cross(equations_[t].arm);
    if (ties_[t].rotations) at_rest.segment<3>(row + 3) = free.turn;
  }
  nodes_.start_from(state);
  Eigen::VectorXd wanted = targets(state, next);
  for (int round = 0; round < most_turning_rounds; ++round) {
    put(system_->solve(wanted - at_rest), mean);
    if (!varying_) break;
    Eigen::VectorXd better = targets(state, next);
    const double change = (better - wanted).lpNorm<Eigen::Infinity>(), size = at_rest.lpNorm<Eigen::Infinity>();
    wanted = std::move(better);
    if (!(change > settled * (size + wanted.lpNorm<Eigen::Infinity>()))) break;
  }
  sum_up(state, net, external);
}

void TieConstraints::absorbed(Absorbed& work) const {
  for (const ContactState& state : states_) work.contact_normal += state.energy_a + state.energy_b;
}

std::vector<ContactNode> TieConstraints::nodes(std::size_t position) const {
  std::vector<ContactNode> all;
  if (!active_[position]) return all;
  for (std::size_t t = interfaces_[position].first; t < interfaces_[position].last; ++t) {
    if (present_[t].gone) continue;
    ContactNode& node = all.emplace_back();
    node.kind = ContactNode::Kind::tied;
    node.node = ties_[t].node;
    node.segment = ties_[t].point.nodes;
    node.force = present_[t].loads.force;
  }
  return all;
}

void TieConstraints::links(std::size_t position, std::vector<ContactLink>& links) const {
  if (!active_[position]) return;
  for (std::size_t t = interfaces_[position].first; t < interfaces_[position].last; ++t) {
    if (present_[t].gone) continue;
    ContactLink& link = links.emplace_back();
    link.tracked = {{ties_[t].node}, {1}};
    link.reference = ties_[t].point;
    link.force = present_[t].loads.force;
  }
}

std::vector<ContactEvent> TieConstraints::take_events() { return std::exchange(events_, {}); }

}  // namespace gapcheck::solver
