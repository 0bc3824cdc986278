#include "solver/tie/tie.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <tuple>

#include "base/quad.hpp"
#include "contact/definition/active_time.hpp"
#include "geometry/closest_point.hpp"
#include "solver/contact/contact_method.hpp"

namespace gapcheck::solver {
namespace {

bool tied(const model::Contact& contact) {
  const ContactMethod method = choose_method(contact).method;
  return method == ContactMethod::tie || method == ContactMethod::tiebreak;
}

/// Tiebreaks of a single surface with a strength.
bool may_fail_on_both_faces(const model::Contact& contact) {
  return contact.kind->breaks() && contact::classify(contact).treatment == contact::Treatment::single_surface &&
         choose_method(contact).method == ContactMethod::tiebreak && std::abs(contact.tiebreak_option) != 1;
}

/// Rotations on which forces can do work.
bool turns(const Structure& structure, NodeIndex node) {
  return structure.rigid.holds(node.value) || structure.state.inertia[node.value] > 0;
}

bool nodes_turn(const Structure& structure, const ContactPoint& point) {
  for (std::size_t i = 0; i < 4; ++i)
    if (point.weights[i] != 0 && !turns(structure, point.nodes[i])) return false;
  return true;
}

ContactPoint point_of(const model::SegmentNodes& n, const Vector& query, const std::vector<Vector>& x) {
  const geometry::Facet facet{{x[n[0].value], x[n[1].value], x[n[2].value], x[n[3].value]}, n[2] == n[3]};
  const geometry::ClosestPoint closest = geometry::closest_point(facet, query);
  return {n, quad_weights(closest.s, closest.t)};
}

/// Tiebreaks that carry moments: OPTION -1 to -3, and those that work with shells at an offset (8, 10, 11), where the
/// shells' rotation opens the gap between their faces.
bool carries_moments(const model::Contact& contact) {
  const std::int64_t option = contact.tiebreak_option;
  return contact.kind->automatic_tiebreak() && (option < 0 || option == 8 || option == 10 || option == 11);
}

}  // namespace

Tie tie_at(const model::Contact& contact, const contact::ContactType& type, bool constraint, NodeIndex node,
           const ContactPoint& point, const std::vector<Vector>& x, const Structure& structure) {
  Tie tie;
  tie.node = node;
  tie.point = point;
  const bool sound = SegmentAxes(tie.point.nodes, x).sound, nodal = nodes_turn(structure, tie.point);
  const Turning turning = nodal ? Turning::nodes : sound ? Turning::axes : Turning::none;
  tie.carries = type.offset == contact::TieOffset::beam || type.offset == contact::TieOffset::constrained ||
                carries_moments(contact);
  if (tie.carries)
    tie.offset = turning;
  else if (!constraint && sound)
    tie.offset = Turning::axes;
  tie.carries = tie.carries && turning != Turning::none;
  tie.rotations =
      type.code == contact::ContactCode::tied_shell_edge && turning != Turning::none && turns(structure, tie.node);
  if (tie.rotations) tie.rotation = turning;
  if (tie.rotation == Turning::nodes && type.can(contact::Ability::torsion) && sound) tie.rotation = Turning::drill;
  return tie;
}

namespace {

Tie tie_of(const model::Contact& contact, const contact::JudgedNode& judged, const contact::ContactSurfaces& surfaces,
           const std::vector<Vector>& x, const Structure& structure) {
  const contact::Segments& segments = (surfaces.two_sided() ? surfaces.b : surfaces.a).selection.segments;
  const bool constraint = contact::ties_by_constraint(surfaces.type) && !judged.penalty;
  const ContactPoint point = point_of(segments.nodes[judged.segment.value], x[judged.node.value], x);
  Tie tie = tie_at(contact, surfaces.type, constraint, judged.node, point, x, structure);
  tie.contact = judged.contact;
  tie.segment = judged.segment;
  tie.segment_part = judged.segment_part;
  tie.element_kind = segments.element_kind[judged.segment.value];
  tie.element = segments.element[judged.segment.value];
  return tie;
}

}  // namespace

bool segment_gone(const Tie& tie, const FailedElements& failed) {
  const bool shell = tie.element_kind == model::ElementKind::shell;
  if (!shell && tie.element_kind != model::ElementKind::solid) return false;
  const std::vector<bool>& gone = shell ? failed.shells : failed.solids;
  return tie.element < gone.size() && gone[tie.element];
}

std::string failed_ties(const std::vector<std::int64_t>& nodes) {
  constexpr std::size_t most_ids = 10;
  std::string ids;
  for (std::size_t i = 0; i < std::min(most_ids, nodes.size()); ++i) ids += fmt::format(" {}", nodes[i]);
  return fmt::format("The ties of {} nodes have failed:{}{}", nodes.size(), ids,
                     nodes.size() > most_ids ? " and others" : "");
}

Vector segment_spin(Turning turning, const ContactPoint& point, const SegmentAxes& axes, const std::vector<Vector>& v,
                    const std::vector<Vector>& w) {
  switch (turning) {
    case Turning::axes:
      return axes.spin(point.nodes, v);
    case Turning::nodes:
      return point.of(w);
    case Turning::drill: {
      const Vector of_nodes = point.of(w);
      return of_nodes + axes.drill() * (axes.spin(point.nodes, v) - of_nodes);
    }
    case Turning::none:
      break;
  }
  return Vector::Zero();
}

TieMotion motion(const Tie& tie, const SegmentAxes& axes, const std::vector<Vector>& v, const std::vector<Vector>& w) {
  TieMotion motion;
  motion.velocity = v[tie.node.value] - tie.point.of(v);
  motion.spin = segment_spin(tie.offset, tie.point, axes, v, w);
  if (tie.rotations) motion.turn = w[tie.node.value] - segment_spin(tie.rotation, tie.point, axes, v, w);
  return motion;
}

void TieOffset::start(const Tie& tie, const SegmentAxes& axes, const std::vector<Vector>& x) {
  start(axes, x[tie.node.value] - tie.point.of(x));
}

void TieOffset::start(const SegmentAxes& axes, const Vector& value) {
  value_ = value;
  local_ = axes.axes.transpose() * value_;
}

void TieOffset::move(const Tie& tie, const SegmentAxes& axes, const Vector& spin, double dt) {
  if (tie.offset == Turning::axes && axes.sound) value_ = axes.axes * local_;
  if (tie.offset == Turning::nodes) value_ = spin_rotation(dt * spin) * value_;
}

void TieOffset::shift(const SegmentAxes& axes, const Vector& by) {
  value_ += by;
  local_ = axes.axes.transpose() * value_;
}

void TieLoads::set(const Tie& tie, const SegmentAxes& axes, const Vector& arm, const Vector& on_node,
                   const Vector& on_rotation) {
  force = on_node;
  moment = on_rotation;
  const auto couple = [&](Turning turning, const Vector& of_segment) {
    Vector on_nodes = Vector::Zero(), on_axes = Vector::Zero();
    if (turning == Turning::axes) on_axes = of_segment;
    if (turning == Turning::drill) on_axes = axes.drill() * of_segment;
    if (turning == Turning::nodes || turning == Turning::drill) on_nodes = of_segment - on_axes;
    for (std::size_t i = 0; i < 4; ++i) {
      moments[i] += tie.point.weights[i] * on_nodes;
      forces[i] += axes.turn[i].transpose() * on_axes;
    }
  };
  for (std::size_t i = 0; i < 4; ++i) {
    forces[i] = -tie.point.weights[i] * force;
    moments[i] = Vector::Zero();
  }
  if (tie.carries) couple(tie.offset, -arm.cross(force));
  if (tie.rotations) couple(tie.rotation, -moment);
}

void TieLoads::add_to(const Tie& tie, Forces& sums) const {
  sums.force[tie.node.value] += force;
  sums.moment[tie.node.value] += moment;
  for (std::size_t i = 0; i < 4; ++i) {
    sums.force[tie.point.nodes[i].value] += forces[i];
    sums.moment[tie.point.nodes[i].value] += moments[i];
  }
}

double TieLoads::on_node(const Tie& tie, const State& state) const {
  return force.dot(state.v[tie.node.value]) + moment.dot(state.w[tie.node.value]);
}

double TieLoads::on_segment(const Tie& tie, const State& state) const {
  double power = 0;
  for (std::size_t i = 0; i < 4; ++i)
    power += forces[i].dot(state.v[tie.point.nodes[i].value]) + moments[i].dot(state.w[tie.point.nodes[i].value]);
  return power;
}

void TieLoads::add_to(const Tie& tie, const State& state, ContactState& result) const {
  result.force_a += force;
  result.moment_a += state.x[tie.node.value].cross(force) + moment;
  for (std::size_t i = 0; i < 4; ++i) {
    result.force_b += forces[i];
    result.moment_b += state.x[tie.point.nodes[i].value].cross(forces[i]) + moments[i];
  }
}

SolverStatus check_tied_faces(const model::Model& model, const contact::InitialState& initial) {
  using Faces = std::tuple<ContactIndex, PartIndex, PartIndex>;
  std::map<Faces, NodeIndex> first;  // a node of the first part that is tied to the second
  for (const contact::JudgedNode& judged : initial.judged) {
    const model::Contact& contact = model.contact(judged.contact);
    if (!judged.tied() || !may_fail_on_both_faces(contact)) continue;
    const auto& [faces, node] =
        *first.emplace(Faces(judged.contact, judged.part, judged.segment_part), judged.node).first;
    const auto back = first.find(Faces(judged.contact, judged.segment_part, judged.part));
    if (back == first.end()) continue;
    const auto id = [&](NodeIndex n) { return model.mesh.nodes.id[n.value]; };
    const auto part = [&](PartIndex p) { return p == none<PartIndex> ? 0 : model.part(p).id.value; };
    const std::string which =
        judged.part == judged.segment_part
            ? fmt::format("node {} of part {} is tied to its own part", id(node), part(judged.part))
            : fmt::format("node {} of part {} is tied to part {}, and node {} of that one to part {}", id(back->second),
                          part(judged.segment_part), part(judged.part), id(node), part(judged.segment_part));
    return Failure{Failure::Kind::not_calculated,
                   fmt::format("contact {} (*{}): {}; how nodes of both faces share a strength is not published. Use "
                               "AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK, which ties the nodes of side A alone",
                               contact.id.value, contact.written, which),
                   contact.place};
  }
  return {};
}

std::vector<TieRange> tie_ranges(const model::Model& model, const std::vector<Tie>& ties, bool by_constraint) {
  std::vector<TieRange> ranges;
  std::size_t next = 0;
  for (const ContactIndex c : positions<ContactIndex>(model.contacts.size())) {
    const model::Contact& contact = model.contact(c);
    const std::size_t first = next;
    while (next < ties.size() && ties[next].contact == c) ++next;
    const bool own = tied(contact) && contact::ties_by_constraint(contact::classify(contact)) == by_constraint;
    if (!own && next == first) continue;
    const contact::ActiveTime time = contact::active_time(contact);
    ranges.push_back({c, first, next, time.start, time.end});
  }
  return ranges;
}

std::vector<Tie> tie_list(const model::Model& model, contact::SurfaceStore& surfaces,
                          const contact::InitialState& initial, const Structure& structure, bool by_constraint) {
  std::vector<Tie> ties;
  for (const contact::JudgedNode& judged : initial.judged) {
    const model::Contact& contact = model.contact(judged.contact);
    if (!judged.tied() || !tied(contact)) continue;
    const contact::ContactSurfaces& sides = surfaces.at(judged.contact);
    if ((contact::ties_by_constraint(sides.type) && !judged.penalty) != by_constraint) continue;
    ties.push_back(tie_of(contact, judged, sides, initial.x, structure));
  }
  return ties;
}

}  // namespace gapcheck::solver
