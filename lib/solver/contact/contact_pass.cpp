#include "solver/contact/contact_pass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "contact/pair/orientation.hpp"
#include "contact/definition/outcome.hpp"
#include "contact/pair/record_pair.hpp"
#include "contact/pair/release.hpp"
#include "contact/surface/segment_elements.hpp"
#include "solver/contact/corner_weights.hpp"

namespace gapcheck::solver {

using contact::Candidate;
using contact::Hit;
using contact::NodeAction;
using contact::NodeContact;
using contact::PairResult;
using geometry::FollowedPairs;

namespace {

/// Places that are looked at in one go.
constexpr std::size_t places_per_block = 256;
constexpr std::size_t not_followed = FollowedPairs::capacity;
static_assert(places_per_block % FollowedPairs::capacity == 0);

double area_of(const geometry::Facet& f) { return (f.x[2] - f.x[0]).cross(f.x[3] - f.x[1]).norm() / 2; }

}  // namespace

/// What one thread works with.
struct ContactPass::Scratch {
  // Pairs of one node.
  std::vector<Hit> hits, measured;
  std::vector<PairResult> results;  ///< of the hits
  // Pairs of several nodes.
  FollowedPairs followed, single;
  std::array<std::size_t, FollowedPairs::capacity> lanes{};
  void clear() {
    hits.clear();
    measured.clear();
    results.clear();
  }
};

/// How a tracked node lies to the segments of the other side.
struct ContactPass::Meeting {
  std::optional<Contact> contact;  ///< in the segment's band
  bool in_zone = false;            ///< some segment is nearer than the contact distance
};

void ContactPass::Block::clear() {
  sleep = 0;
  nodes = pairs = followed = asleep = released = touching = 0;
  work = {};
  moves.clear();
}

ContactPass::ContactPass(const ContactSetting& setting, std::uint32_t contact, const contact::ContactSurfaces& surfaces,
                         bool exchanged, const std::vector<Vector>& x)
    : setting_(setting),
      surfaces_(surfaces),
      side_(setting.model, contact, surfaces, exchanged, x),
      scene_(side_.scene()),
      exclusions_(setting.model, setting.model.contacts[contact].id),
      rules_(scene_, side_.tracked(), exclusions_, setting.ties),
      friction_(setting.model, setting.model.contacts[contact]),
      springs_(setting.model, side_, setting.masses, exchanged ? scene_.contact.sfm : scene_.contact.sfs,
               exchanged || !surfaces.two_sided() ? scene_.contact.sfs : scene_.contact.sfm),
      exchanged_(exchanged),
      tracked_(scene_.nodes.size()),
      leads_(scene_.mode == geometry::Mode::filtered && !(scene_.contact.airbag_thickness > 0)) {
  side_.scene().flipped = contact::flipped_segments(scene_, setting.search);
  double largest_half = 0;
  for (const double half : scene_.nodes.half) largest_half = std::max(largest_half, half);
  for (std::uint32_t s = 0; s < scene_.segments.size(); ++s)
    greatest_reach_ = std::max(greatest_reach_, scene_.reach(s, largest_half));
}

double ContactPass::segment_area(std::uint32_t segment) const { return area_of(scene_.facet(segment)); }

void ContactPass::remember(const Penetration& record, const NodeContact& memory) {
  const auto pair = contact::find_pair(surfaces_, setting_.model.mesh, record);
  if (pair && pair->node_on_b == exchanged_) tracked_[pair->slot].memory = memory;
}

void ContactPass::search(double margin, ContactCounters& counters) {
  contact::SweepCounters sweep;
  candidates_.search(scene_, rules_, setting_.search, margin, sweep);
  counters.candidates += candidates_.size();
  std::vector<bool> found(tracked_.size(), false);
  for (const std::uint32_t slot : candidates_.slots()) {
    found[slot] = true;
    tracked_[slot].sleep = tracked_[slot].lead = 0;
    tracked_[slot].partner.segment = 0;
  }
  for (Block& block : blocks_) block.sleep = 0;
  lost_.clear();
  for (std::uint32_t slot = 0; slot < tracked_.size(); ++slot)
    if (!found[slot] && (tracked_[slot].active || tracked_[slot].memory.state != NodeContact::State::apart))
      lost_.push_back(slot);
}

std::uint32_t ContactPass::slot_at(std::size_t place) const {
  const std::span<const std::uint32_t> near = candidates_.slots();
  return place < near.size() ? near[place] : lost_[place - near.size()];
}

ContactPass::Meeting ContactPass::meet(std::uint32_t slot, std::span<Candidate> candidates, double used,
                                       Scratch& scratch, Tracked& tracked, Block& block) const {
  scratch.clear();
  double wake = std::numeric_limits<double>::infinity();
  std::uint64_t pairs = 0;
  for (Candidate& candidate : candidates) {
    if (!(candidate.wake > used)) {
      const std::uint32_t s = candidate.segment;
      const PairResult pair = contact::decide_pair(scene_, slot, s);
      ++pairs;
      candidate.wake = used + std::abs(pair.distance) - reach(slot, s);
      const double distance = std::sqrt(pair.closest.squared_distance);
      candidate.towards = distance > 0 ? Vector((pair.closest.point - scene_.position(slot)) / distance) : Vector::Zero();
      if (pair.penetrates) {
        scratch.hits.push_back({slot, s, pair.distance, pair.in_band});
        scratch.results.push_back(pair);
      } else if (scene_.oriented(s)) {
        scratch.measured.push_back({slot, s, pair.distance, pair.in_band});
      }
    }
    wake = std::min(wake, candidate.wake);
  }
  block.pairs += pairs;
  block.nodes += pairs > 0;
  Meeting meeting;
  meeting.in_zone = !scratch.hits.empty();
  tracked.sleep = meeting.in_zone ? 0 : wake;
  tracked.lead = 0;
  if (!meeting.in_zone) return meeting;
  const std::optional<Hit> hit = contact::choose_hit(scene_, scratch.hits, scratch.measured);
  if (!hit || !hit->in_band) return meeting;
  const auto same = [&](const Hit& other) { return other.segment == hit->segment; };
  const auto at = std::find_if(scratch.hits.begin(), scratch.hits.end(), same) - scratch.hits.begin();
  meeting.contact = contact_of(slot, hit->segment, scratch.results[static_cast<std::size_t>(at)]);
  improve(slot, tracked, *meeting.contact, scratch.single);
  if (leads_ && meeting.contact->on_face)
    tracked.lead = lead(nearest_other(slot, meeting.contact->segment, candidates, used), *meeting.contact, used);
  return meeting;
}

ContactPass::Contact ContactPass::contact_of(std::uint32_t slot, std::uint32_t segment, const PairResult& pair) const {
  const bool flipped = !scene_.flipped.empty() && scene_.flipped[segment];
  Contact contact;
  contact.segment = segment;
  contact.s = pair.closest.s;
  contact.t = pair.closest.t;
  contact.way = scene_.position(slot) - pair.closest.point;
  contact.normal = flipped ? Vector(-pair.closest.normal) : pair.closest.normal;
  contact.distance = pair.distance;
  contact.on_face = pair.closest.feature == Feature::face && !scene_.line(segment);
  return contact;
}

contact::NodeEncounter ContactPass::encounter(std::uint32_t slot, const Meeting& meeting, Tracked& tracked) const {
  contact::NodeEncounter encounter;
  encounter.in_zone = meeting.in_zone;
  if (!meeting.contact) return encounter;
  const std::uint32_t segment = meeting.contact->segment;
  encounter.penetrates = true;
  encounter.penetration = scene_.nodes.half[slot] + scene_.segments.half[segment] - meeting.contact->distance;
  if (tracked.partner.segment != segment + 1)
    tracked.partner = {segment + 1, release_depth(slot, segment), spring(slot, segment)};
  // The depth that follows the segment's shape or a thickness over time is that of this cycle.
  else if (scene_.contact.penchk == 2 || scene_.contact.airbag_thickness > 0)
    tracked.partner.release_depth = release_depth(slot, segment);
  encounter.release_depth = tracked.partner.release_depth;
  encounter.movable = setting_.movable[scene_.nodes.node[slot].value];
  return encounter;
}

void ContactPass::look_at(std::size_t first, std::size_t last, const State& state, double used, Scratch& scratch,
                          std::size_t b) {
  FollowedPairs& pairs = scratch.followed;
  std::size_t count = 0;
  for (std::size_t place = first; place < last; ++place) {
    std::size_t& lane = scratch.lanes[place - first];
    lane = not_followed;
    if (!may_follow(place)) continue;
    lane = count++;
    prepare(slot_at(place), pairs, lane);
  }
  geometry::follow(pairs, count);
  Block& block = blocks_[b];
  for (std::size_t place = first; place < last; ++place) {
    const std::uint32_t slot = slot_at(place);
    const std::size_t lane = scratch.lanes[place - first];
    Meeting meeting;
    if (lane != not_followed) meeting.contact = followed(slot, pairs, lane);
    if (meeting.contact && keeps_lead(place, *meeting.contact, used)) {
      meeting.in_zone = true;
      ++block.nodes;
      ++block.pairs;
      ++block.followed;
      act(slot, meeting, state, b);
    } else {
      look(place, state, used, scratch, b);
    }
  }
}

void ContactPass::look(std::size_t place, const State& state, double used, Scratch& scratch, std::size_t b) {
  const bool lost = place >= candidates_.slots().size();
  const std::uint32_t slot = slot_at(place);
  Tracked& tracked = tracked_[slot];
  Block& block = blocks_[b];
  if (tracked.sleep > used && !lost && !tracked.active) {
    ++block.asleep;
    block.released += tracked.memory.state == NodeContact::State::released;
    return;
  }
  Meeting meeting = meet(slot, lost ? std::span<Candidate>{} : candidates_.of(place), used, scratch, tracked, block);
  act(slot, meeting, state, b);
}

void ContactPass::act(std::uint32_t slot, Meeting& meeting, const State& state, std::size_t b) {
  Tracked& tracked = tracked_[slot];
  Block& block = blocks_[b];
  const bool was_active = tracked.active;
  Velocities speeds;
  if (was_active) {
    speeds = velocities(slot, tracked.link.segment, state);
    block.work.add(tracked.link, speeds.node, speeds.of_segment(tracked.link.weights), state.dt);
  }
  orient(slot, meeting.contact ? &*meeting.contact : nullptr);
  const contact::NodeEncounter encounter = this->encounter(slot, meeting, tracked);
  tracked.penetration = encounter.penetration;
  const NodeAction action = advance(tracked.memory, encounter);
  tracked.active = action == NodeAction::force;
  if (tracked.active) {
    const std::uint32_t segment = meeting.contact->segment;
    if (!was_active || tracked.link.segment != segment) speeds = velocities(slot, segment, state);
    const Vector friction = was_active ? tracked.link.friction : Vector::Zero();
    tracked.link = place_link(*meeting.contact);
    const Vector moving = speeds.of_segment(tracked.link.weights);
    press(slot, tracked, speeds.node - moving, friction, state.dt);
    block.work.add(tracked.link, speeds.node, moving, state.dt);
    block.touching += tracked.link.push > 0;
    pushes_[b].add({tracked.link.force(), tracked.link.weights, scene_.nodes.node[slot].value, segment},
                   scene_.segments.nodes[segment]);
  } else {
    tracked.link = {};
    if (encounter.penetrates) tracked.link.segment = meeting.contact->segment;
  }
  if (action == NodeAction::move) {
    block.moves.push_back({slot, contact::shooting_move * encounter.penetration * meeting.contact->direction()});
    tracked.sleep = 0;
  }
  block.released += tracked.memory.state == NodeContact::State::released;
}

ContactPass::Link ContactPass::place_link(const Contact& contact) const {
  Link link;
  link.segment = contact.segment;
  link.on_face = contact.on_face;
  link.s = contact.s;
  link.t = contact.t;
  link.weights = corner_weights(scene_.line(link.segment), contact.s, contact.t);
  link.normal = contact.direction();
  return link;
}

void ContactPass::press(std::uint32_t slot, Tracked& tracked, const Vector& velocity, const Vector& friction_before,
                        double dt) const {
  Link& link = tracked.link;
  const ContactSprings::Spring& spring = tracked.partner.spring;
  LinkSpring law{spring.stiffness, ContactSprings::damping(spring, scene_.contact.vdc), friction_.any(), {}, 0};
  if (law.rubs) {
    law.friction = friction_.between(scene_.nodes.part[slot],
                                     contact::part_of(setting_.model.mesh, scene_.segments, link.segment));
    law.area = segment_area(link.segment);
  }
  link.press(law, tracked.penetration - tracked.memory.forgiven, velocity, friction_before, dt);
}

double ContactPass::release_depth(std::uint32_t slot, std::uint32_t segment) const {
  return contact::release_depth(scene_, slot, segment);
}

NodeAction ContactPass::advance(NodeContact& memory, const contact::NodeEncounter& encounter) const {
  return contact::advance(memory, scene_.settings, encounter);
}

void ContactPass::forget_partners() {
  for (Tracked& tracked : tracked_) tracked.partner = {};
}

ContactPass::Velocities ContactPass::velocities(std::uint32_t slot, std::uint32_t segment, const State& state) const {
  const model::SegmentNodes& n = scene_.segments.nodes[segment];
  return {state.v[scene_.nodes.node[slot].value],
          {state.v[n[0].value], state.v[n[1].value], state.v[n[2].value], state.v[n[3].value]}};
}

void ContactPass::add_work(const Link& link, const Velocities& velocities, double dt, Work& work) const {
  work.add(link, velocities.node, velocities.of_segment(link.weights), dt);
}

void ContactPass::look_at_block(std::size_t b, const State& state, double used, Scratch& scratch) {
  const std::size_t near = candidates_.slots().size(), places = near + lost_.size();
  const std::size_t first = b * places_per_block, last = std::min(places, first + places_per_block);
  Block& block = blocks_[b];
  pushes_[b].clear();
  if (block.sleep > used && last <= near) {
    // Nothing has changed, and what is released stays so.
    const std::uint64_t released = block.released;
    const double sleep = block.sleep;
    block.clear();
    block.sleep = sleep;
    block.released = released;
    block.asleep = last - first;
    return;
  }
  block.clear();
  for (std::size_t place = first; place < last; place += FollowedPairs::capacity)
    look_at(place, std::min(last, place + FollowedPairs::capacity), state, used, scratch, b);
  if (last > near) return;
  block.sleep = std::numeric_limits<double>::infinity();
  for (std::size_t place = first; place < last; ++place) {
    const Tracked& tracked = tracked_[slot_at(place)];
    block.sleep = std::min(block.sleep, tracked.active ? 0 : tracked.sleep);
  }
}

double ContactPass::update(State& state, double used, ContactCounters& counters) {
  const std::size_t places = candidates_.slots().size() + lost_.size();
  blocks_.resize((places + places_per_block - 1) / places_per_block);
  pushes_.resize(blocks_.size());
  parallel_for(blocks_.size(), 1, [&](std::size_t begin, std::size_t end) {
    static thread_local Scratch scratch;
    for (std::size_t b = begin; b < end; ++b) look_at_block(b, state, used, scratch);
  });
  double longest = 0;
  for (const Block& block : blocks_) {
    counters.nodes += block.nodes;
    counters.pairs += block.pairs;
    counters.followed += block.followed;
    counters.asleep += block.asleep;
    for (const Move& move : block.moves) {
      state.x[scene_.nodes.node[move.slot].value] += move.way;
      longest = std::max(longest, move.way.norm());
    }
  }
  // What is lost has nothing to be looked at again; of those far from everything the memory is gone.
  lost_.clear();
  return longest;
}

void ContactPass::apply(const State& state, Forces& forces, ContactState& result) const {
  add_pushes(pushes_, scene_.segments, forces);
  for (const Block& block : blocks_) {
    result.moved += block.moves.size();
    result.released += block.released;
    result.touching += block.touching;
    add_energies(block.work, result);
  }
  if (result.single_surface) return;
  std::vector<PushTotals> sums(pushes_.size());
  parallel_for(pushes_.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) sums[b] = totals(pushes_[b], scene_.segments, state.x);
  });
  for (const PushTotals& sum : sums) {
    (exchanged_ ? result.force_b : result.force_a) += sum.force;
    (exchanged_ ? result.force_a : result.force_b) -= sum.force;
    (exchanged_ ? result.moment_b : result.moment_a) += sum.tracked_moment;
    (exchanged_ ? result.moment_a : result.moment_b) += sum.reference_moment;
  }
}

void ContactPass::add_energies(const Work& work, ContactState& result) const {
  result.friction += work.friction;
  result.damping += work.damping;
  const bool all_a = result.single_surface;
  (exchanged_ && !all_a ? result.energy_b : result.energy_a) += work.on_tracked;
  (exchanged_ || all_a ? result.energy_a : result.energy_b) += work.on_reference;
}

}  // namespace gapcheck::solver
