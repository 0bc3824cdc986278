#include "solver/contact/node_settler.hpp"

#include "base/quad.hpp"
#include "contact/definition/outcome.hpp"
#include "contact/surface/segment_elements.hpp"

namespace gapcheck::solver {

using contact::NodeAction;

namespace {

/// As PairVelocities::of_segment(), without a copy of the corners' velocities: they are read again soon after.
Vector point_velocity(const model::SegmentNodes& n, const std::array<double, 4>& weights, const State& state) {
  const std::vector<Vector>& v = state.v;
  return (weights[0] * v[n[0].value] + weights[1] * v[n[1].value]) +
         (weights[2] * v[n[2].value] + weights[3] * v[n[3].value]);
}

}  // namespace

NodeSettler::NodeSettler(const ContactSetting& setting, ContactIndex contact, TrackedPairs& pairs, NodeRule& rule)
    : mesh_(setting.model.mesh),
      movable_(setting.movable),
      pairs_(pairs),
      scene_(pairs.scene()),
      rule_(rule),
      friction_(setting.model, setting.model.contact(contact)) {}

void NodeSettler::settle_node(std::size_t place, NodeMeeting& meeting, const State& state, PassBlock& block,
                              PushList& pushes) {
  const SlotIndex slot = pairs_.slot_at(place);
  // A node that was at rest and touches nothing stays so.
  if (!meeting.contact && pairs_.known(slot) == nullptr) return rule_.bring_back(slot, nullptr);
  TrackedNode& tracked = pairs_.touch(slot);
  const bool was_active = tracked.active;
  const double stored = tracked.stored();
  const Vector& speed = state.v[scene_.nodes.node[slot.value].value];
  if (was_active) {
    const model::SegmentNodes& corners = scene_.segments.nodes[tracked.link.segment.value];
    block.work.add(tracked.link, speed, point_velocity(corners, tracked.link.weights, state), state.dt);
  }
  rule_.bring_back(slot, meeting.contact ? &*meeting.contact : nullptr);
  const contact::NodeEncounter encounter = encounter_of(slot, meeting, tracked, state);
  tracked.penetration = encounter.penetration;
  const NodeAction action = rule_.decide_action(tracked.memory, encounter);
  tracked.active = action == NodeAction::force;
  if (tracked.active) {
    const SegmentIndex segment = meeting.contact->segment;
    const model::SegmentNodes& corners = scene_.segments.nodes[segment.value];
    const Vector friction = was_active ? tracked.link.friction : Vector::Zero();
    set_link(*meeting.contact, tracked.link);
    const Vector moving = point_velocity(corners, tracked.link.weights, state);
    const Vector velocity = speed - moving;
    tracked.link.set_forces(law_of(slot, tracked, velocity), tracked.penetration - tracked.memory.forgiven, velocity,
                            friction, state.dt);
    block.work.add(tracked.link, speed, moving, state.dt);
    block.touching += tracked.link.push > 0;
    pushes.add({tracked.link.force(), tracked.link.weights, scene_.nodes.node[slot.value].value, segment.value},
               corners);
  } else {
    tracked.link = {};
    if (encounter.penetrates) tracked.link.segment = meeting.contact->segment;
  }
  if (action == NodeAction::move) {
    block.moves.push_back({slot, contact::shooting_move * encounter.penetration * meeting.contact->direction()});
    pairs_.set_sleep(place, 0);
  }
  if (tracked.released()) block.lost += stored;
  block.released += tracked.released();
}

contact::NodeEncounter NodeSettler::encounter_of(SlotIndex slot, const NodeMeeting& meeting, TrackedNode& tracked,
                                                 const State& state) const {
  contact::NodeEncounter encounter;
  encounter.in_zone = meeting.in_zone;
  if (!meeting.contact) return encounter;
  const SegmentIndex segment = meeting.contact->segment;
  encounter.penetrates = true;
  encounter.penetration =
      scene_.nodes.half[slot.value] + scene_.segments.half[segment.value] - meeting.contact->distance;
  // The spring of SOFT = 2 depends on how the two lie when they meet.
  if (tracked.pair.segment != segment || tracked.memory.state == contact::NodeContact::State::apart)
    tracked.pair = {segment, rule_.release_depth(slot, segment), rule_.spring(slot, segment)};
  // A depth that follows the segment's shape or a thickness over time is that of this cycle.
  else if (scene_.contact.penchk == 2 || scene_.contact.airbag_thickness > 0)
    tracked.pair.release_depth = rule_.release_depth(slot, segment);
  encounter.release_depth = tracked.pair.release_depth;
  encounter.movable = movable_[scene_.nodes.node[slot.value].value];
  encounter.followed = tracked.memory.state == contact::NodeContact::State::apart && was_followed(slot, segment, state);
  return encounter;
}

bool NodeSettler::was_followed(SlotIndex slot, SegmentIndex segment, const State& state) const {
  if (fresh_) return false;
  // Velocities are those of the step that led here.
  const PairVelocities speeds = pairs_.velocities(slot, segment, state);
  geometry::Facet facet = scene_.facet(segment);
  for (std::size_t corner = 0; corner < facet.x.size(); ++corner) facet.x[corner] -= state.dt * speeds.corners[corner];
  return contact::was_followed(scene_, slot, segment, facet, scene_.position(slot) - state.dt * speeds.node);
}

void NodeSettler::set_link(const SegmentContact& contact, SegmentLink& link) const {
  link = {};
  link.segment = contact.segment;
  link.on_face = contact.on_face;
  link.s = contact.s;
  link.t = contact.t;
  // A beam axis has the first two corners and s alone.
  if (scene_.line(link.segment))
    link.weights = {(1 - contact.s) / 2, (1 + contact.s) / 2, 0, 0};
  else
    link.weights = quad_weights(contact.s, contact.t);
  link.normal = contact.direction();
}

LinkSpring NodeSettler::law_of(SlotIndex slot, const TrackedNode& tracked, const Vector& velocity) const {
  const ContactSprings::Spring& spring = tracked.pair.spring;
  LinkSpring law{spring.stiffness, ContactSprings::damping(spring, scene_.contact.vdc), friction_.any(), {}, 0};
  if (law.rubs) {
    const SegmentIndex segment = tracked.link.segment;
    law.friction =
        friction_.between(scene_.nodes.part[slot.value], contact::part_of(mesh_, scene_.segments, segment.value));
    law.area = pairs_.segment_area(segment);
  }
  rule_.bend(slot, tracked.penetration, -velocity.dot(tracked.link.normal), law);
  return law;
}

}  // namespace gapcheck::solver
