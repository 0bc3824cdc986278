#include "solver/loss/expected_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "contact/surface/segment_elements.hpp"
#include "solver/contact/curve_rule.hpp"
#include "solver/loss/bodies.hpp"
#include "solver/loss/judge_impacts.hpp"
#include "solver/loss/meetings.hpp"
#include "solver/loss/remedies.hpp"
#include "solver/loss/wall_meetings.hpp"

namespace gapcheck::solver {
namespace {

/// Why the meetings of a contact are not judged node by node; empty: they are.
std::string_view why_not_looked_at(const model::Contact& card) {
  if (card.options.mortar) return "mortar contacts act between segments";
  if (acts_by_curve(card)) return "its forces follow a curve";
  if (card.kind->can(model::Ability::interference)) return "its overlap is meant, and its stiffness grows";
  if (card.airbag_thickness > 0) return "its thickness follows a curve";
  return {};
}

/// Bodies that contacts act on from the start on.
std::set<std::uint32_t> busy_bodies(const Run& run, const ConnectedBodies& bodies) {
  std::set<std::uint32_t> busy;
  for (const ContactView& view : run.contacts())
    for (const ContactNode& node : view.nodes()) {
      if (node.kind == ContactNode::Kind::tied) continue;
      busy.insert(bodies.of(node.node));
      for (const NodeIndex corner : node.segment)
        if (corner.value < run.stepper().state().x.size()) busy.insert(bodies.of(corner));
    }
  return busy;
}

/// Collects what will meet, and judges it.
class ContactExpectation {
 public:
  ContactExpectation(Run& run, const StartMotion& start, const Flight& flight)
      : run_(run), model_(run.model()), start_(start), flight_(flight) {
    result_.end = result_.until = run.end_time();
    result_.step = run.stepper().next_step();
  }

  ExpectedContacts find() {
    const State& state = run_.stepper().state();
    note_what_is_left_out();
    find_impacts();
    const ConnectedBodies bodies(model_, run_.stepper().structure(), run_.initial(), start_, flight_);
    judge_impacts({bodies, flight_, state, result_.step, busy_bodies(run_, bodies)}, impacts_);
    add_rows();
    result_.walls = find_wall_meetings(model_, state.x, flight_, result_.until, result_.not_looked_at);
    return std::move(result_);
  }

 private:
  void leave_out(std::string text) { result_.not_looked_at.push_back(std::move(text)); }

  void note_what_is_left_out() {
    for (const model::Contact& card : model_.contacts) {
      const ContactMethod method = choose_method(card).method;
      if (method == ContactMethod::tie || method == ContactMethod::transducer) continue;
      const std::string_view why = method == ContactMethod::constraint ? "it acts by constraints"
                                   : method == ContactMethod::none     ? "it is not calculated"
                                                                       : why_not_looked_at(card);
      if (!why.empty()) leave_out(fmt::format("contact {}: {}", card.id.value, why));
    }
    const model::Loads& loads = model_.loads;
    if (!loads.concentrated.empty() || !loads.pressures.empty() || !loads.bodies.empty() || !loads.body_parts.empty() ||
        !loads.part_dampings.empty() || loads.damping)
      leave_out("loads and damping, which act on the way and meanwhile");
    if (flight_.unknown() > 0)
      leave_out(fmt::format("{} nodes whose prescribed motion is an acceleration or a rotation, or does not last",
                            flight_.unknown()));
  }

  void find_impacts() {
    MeetingCounters counters;
    std::vector<NodePass> passes;
    for (const NodePass& pass : node_passes(run_.contact_forces()))
      if (why_not_looked_at(model_.contact(pass.contact)).empty()) passes.push_back(pass);
    std::vector<std::vector<Meeting>> meetings;
    for (const NodePass& pass : passes)
      meetings.push_back(find_meetings(pass.pass->pairs(), flight_, result_.until, counters));
    std::map<ContactIndex, std::uint64_t> asleep;
    for (std::size_t p = 0; p < passes.size(); ++p)
      for (const Meeting& meeting : meetings[p]) {
        // Another contact may have shortened the search since.
        if (meeting.contact.time > result_.until) continue;
        if (passes[p].interface->acts_at(meeting.contact.time) && passes[p].interface->acts_at(0))
          add_impact(passes[p], meeting);
        else
          ++asleep[passes[p].contact];
      }
    for (const auto& [contact, nodes] : asleep)
      leave_out(
          fmt::format("contact {}: {} nodes that meet something while it does not act, or when it may have begun "
                      "with them inside",
                      model_.contact(contact).id.value, nodes));
    if (counters.undecided > 0)
      leave_out(
          fmt::format("{} pairs of a node and a segment whose time of contact was not found", counters.undecided));
    result_.still = counters.still;
    result_.candidates = counters.candidates;
    result_.closest_points = counters.steps;
  }

  void add_impact(const NodePass& pass, const Meeting& meeting) {
    const TrackedPairs& pairs = pass.pass->pairs();
    const contact::PairScene& scene = pairs.scene();
    Impact& impact = impacts_.emplace_back();
    impact.pass = pass;
    impact.meeting = meeting;
    impact.node = scene.nodes.node[meeting.slot.value];
    impact.corners = scene.segments.nodes[meeting.segment.value];
    impact.part = scene.nodes.part[meeting.slot.value];
    impact.other_part = contact::part_of(model_.mesh, scene.segments, meeting.segment.value);
    impact.spring = pass.pass->rule().spring(meeting.slot, meeting.segment);
    impact.contact_distance = scene.nodes.half[meeting.slot.value] + scene.segments.half[meeting.segment.value];
    impact.release = pass.pass->rule().release_depth(meeting.slot, meeting.segment);
    // An oriented segment does not see what is farther behind it.
    if (scene.oriented(meeting.segment) && !scene.type.by_segments())
      impact.release = std::min(impact.release, impact.contact_distance + scene.behind(meeting.segment));
  }

  void add_rows() {
    using Key = std::tuple<ContactIndex, PartIndex, PartIndex>;
    std::map<Key, std::vector<std::size_t>> rows;
    for (std::size_t i = 0; i < impacts_.size(); ++i)
      rows[{impacts_[i].pass.contact, impacts_[i].part, impacts_[i].other_part}].push_back(i);
    for (const auto& [key, members] : rows) result_.contacts.push_back(row_of(members));
    // What is lost or held for sure does not count here, but how little is left.
    const auto badness = [](const ExpectedContact& row) {
      const double left = std::numeric_limits<double>::infinity();
      return std::min(row.margin ? *row.margin : row.alone.value_or(left),
                      row.in_step && *row.in_step > 0 ? 1 / *row.in_step : left);
    };
    std::ranges::stable_sort(result_.contacts, [&](const ExpectedContact& a, const ExpectedContact& b) {
      return std::tuple(badness(a), a.time) < std::tuple(badness(b), b.time);
    });
  }

  [[nodiscard]] ExpectedContact row_of(const std::vector<std::size_t>& members) const {
    ExpectedContact row;
    const Impact& any = impacts_[members.front()];
    const auto id_of = [&](PartIndex part) { return part == none<PartIndex> ? 0 : model_.part(part).id.value; };
    row.contact = any.pass.contact.value;
    row.part = id_of(any.part);
    row.other_part = id_of(any.other_part);
    row.time = std::numeric_limits<double>::infinity();
    row.never_released = true;
    for (const std::size_t i : members) add_to_row(impacts_[i], row);
    judge_row(members, row);
    find_remedies(impacts_, members, result_.step, row);
    return row;
  }

  void add_to_row(const Impact& impact, ExpectedContact& row) const {
    ++row.nodes;
    if (impact.time() < row.time) {
      row.time = impact.time();
      row.node = model_.mesh.nodes.id[impact.node.value];
    }
    row.speed = std::max(row.speed, impact.speed());
    row.never_released = row.never_released && std::isinf(impact.release);
    if (!(impact.contact_distance > 0)) return;
    const double share = impact.speed() * result_.step / (0.8 * impact.contact_distance);
    row.in_step = std::max(row.in_step.value_or(share), share);
    row.crossing += share > 1;
  }

  /// The least margins of all nodes; what is not known of one of them is not known of the row.
  void judge_row(const std::vector<std::size_t>& members, ExpectedContact& row) const {
    if (row.never_released) return;
    bool exact = true, alone = true, bounded = true;
    const auto take = [](std::optional<double>& least, const std::optional<double>& one) {
      if (one) least = std::min(least.value_or(*one), *one);
    };
    for (const std::size_t i : members) {
      const Impact& impact = impacts_[i];
      if (impact.reason.empty() && !impact.margin) continue;  // others have stopped it before
      if (row.reason.empty()) row.reason = impact.reason;
      if (std::isinf(impact.release)) continue;
      exact = exact && impact.margin;
      alone = alone && (impact.alone || impact.margin);
      bounded = bounded && impact.low;
      take(row.margin, impact.margin);
      take(row.alone, impact.alone ? impact.alone : impact.margin);
      take(row.low, impact.low);
      take(row.high, impact.high);
    }
    if (!exact) row.margin.reset();
    if (!alone || exact) row.alone.reset();
    if (!bounded) row.low.reset();
  }

  Run& run_;
  const model::Model& model_;
  const StartMotion& start_;
  const Flight& flight_;
  ExpectedContacts result_;
  std::vector<Impact> impacts_;
};

}  // namespace

bool may_move(const model::Model& model) {
  return !model.initial_velocities.empty() || !model.node_velocities.empty() || !model.prescribed_motions.empty();
}

std::optional<ExpectedContacts> expect_contacts(Run& run, const StartMotion& start) {
  const double end = run.end_time();
  if (!may_move(run.model()) || !std::isfinite(end)) return std::nullopt;
  const Flight flight(run.stepper().structure(), start, end);
  if (!flight.any()) return std::nullopt;
  return ContactExpectation(run, start, flight).find();
}

}  // namespace gapcheck::solver
