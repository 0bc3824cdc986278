#include "solver/contact_pass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "base/parallel.hpp"
#include "contact/orientation.hpp"
#include "contact/outcome.hpp"
#include "contact/record_pair.hpp"
#include "contact/release.hpp"
#include "contact/segment_elements.hpp"
#include "solver/corner_weights.hpp"

namespace gapcheck::solver {

using contact::Candidate;
using contact::Hit;
using contact::NodeAction;
using contact::NodeContact;
using contact::PairResult;

namespace {

/// Places that are looked at in one go.
constexpr std::size_t block_size = 256;

double segment_area(const geometry::Facet& f) { return (f.x[2] - f.x[0]).cross(f.x[3] - f.x[1]).norm() / 2; }

}  // namespace

/// Where meet() keeps the pairs of one node.
struct ContactPass::Scratch {
  std::vector<Hit> hits, measured;
  std::vector<PairResult> results;  ///< of the hits
  void clear() {
    hits.clear();
    measured.clear();
    results.clear();
  }
};

/// How a tracked node lies to the segments of the other side. Good until the next meeting.
struct ContactPass::Meeting {
  std::optional<Hit> hit;
  PairResult* pair = nullptr;  ///< with the hit's segment
  bool in_zone = false;              ///< some segment is nearer than the contact distance
};

void ContactPass::Block::clear() {
  nodes = pairs = released = 0;
  busy.clear();
  moves.clear();
}

Vector ContactPass::Velocities::of_segment(const std::array<double, 4>& weights) const {
  Vector velocity = Vector::Zero();
  for (std::size_t c = 0; c < 4; ++c) velocity += weights[c] * corners[c];
  return velocity;
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
      tracked_(scene_.nodes.size()) {
  side_.scene().flipped = contact::flipped_segments(scene_, setting.search);
  double largest_half = 0;
  for (const double half : scene_.nodes.half) largest_half = std::max(largest_half, half);
  for (std::uint32_t s = 0; s < scene_.segments.size(); ++s)
    greatest_reach_ = std::max(greatest_reach_, scene_.reach(s, largest_half));
}

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
    tracked_[slot].sleep = 0;
    tracked_[slot].partner.segment = 0;
  }
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
      const double h = scene_.nodes.half[slot] + scene_.segments.half[s];
      const bool oriented = scene_.oriented(s);
      candidate.wake = used + std::abs(pair.distance) - (oriented ? greatest_reach_ : h);
      if (pair.penetrates) {
        scratch.hits.push_back({slot, s, pair.distance, pair.in_band});
        scratch.results.push_back(pair);
      } else if (oriented) {
        scratch.measured.push_back({slot, s, pair.distance, pair.in_band});
      }
    }
    wake = std::min(wake, candidate.wake);
  }
  block.pairs += pairs;
  block.nodes += pairs > 0;
  Meeting meeting;
  meeting.in_zone = !scratch.hits.empty();
  if (meeting.in_zone) {
    meeting.hit = contact::choose_hit(scene_, scratch.hits, scratch.measured);
    for (std::size_t i = 0; meeting.hit && i < scratch.hits.size(); ++i)
      if (scratch.hits[i].segment == meeting.hit->segment) meeting.pair = &scratch.results[i];
  }
  tracked.sleep = meeting.in_zone ? 0 : wake;
  return meeting;
}

contact::NodeEncounter ContactPass::encounter(std::uint32_t slot, const Meeting& meeting, Tracked& tracked) const {
  contact::NodeEncounter encounter;
  encounter.in_zone = meeting.in_zone;
  if (!meeting.hit || !meeting.hit->in_band) return encounter;
  const std::uint32_t segment = meeting.hit->segment;
  encounter.penetrates = true;
  encounter.penetration = scene_.nodes.half[slot] + scene_.segments.half[segment] - meeting.pair->distance;
  if (tracked.partner.segment != segment + 1)
    tracked.partner = {segment + 1, release_depth(slot, segment), spring(slot, segment)};
  encounter.release_depth = tracked.partner.release_depth;
  encounter.movable = setting_.movable[scene_.nodes.node[slot].value];
  return encounter;
}

void ContactPass::look(std::size_t place, const State& state, double used, Scratch& scratch, Block& block) {
  const bool lost = place >= candidates_.slots().size();
  const std::uint32_t slot = slot_at(place);
  Tracked& tracked = tracked_[slot];
  tracked.worked = false;
  if (tracked.sleep > used && !lost) {
    if (tracked.active) block.busy.push_back(slot);
    block.released += tracked.memory.state == NodeContact::State::released;
    return;
  }
  const bool was_active = tracked.active;
  Work work;
  Velocities speeds;
  if (was_active) {
    speeds = velocities(slot, tracked.link.segment, state);
    add_work(tracked.link, speeds, state.dt, work);
  }
  const Meeting meeting =
      meet(slot, lost ? std::span<Candidate>{} : candidates_.of(place), used, scratch, tracked, block);
  const bool in_band = meeting.hit && meeting.hit->in_band;
  orient(slot, in_band ? meeting.hit->segment : 0, in_band ? meeting.pair : nullptr);
  const contact::NodeEncounter encounter = this->encounter(slot, meeting, tracked);
  tracked.penetration = encounter.penetration;
  const NodeAction action = advance(tracked.memory, encounter);
  tracked.active = action == NodeAction::force;
  if (tracked.active) {
    const std::uint32_t segment = meeting.hit->segment;
    if (!was_active || tracked.link.segment != segment) speeds = velocities(slot, segment, state);
    tracked.link = link(slot, meeting, tracked, was_active ? tracked.link.friction : Vector::Zero(), speeds, state.dt);
    add_work(tracked.link, speeds, state.dt, work);
  } else {
    tracked.link = {};
    if (encounter.penetrates) tracked.link.segment = meeting.hit->segment;
  }
  if (action == NodeAction::move) {
    block.moves.push_back({slot, contact::shooting_move * encounter.penetration *
                                     contact::free_direction(scene_, slot, meeting.hit->segment, *meeting.pair)});
    tracked.sleep = 0;
  }
  tracked.work = work;
  tracked.worked = was_active || tracked.active;
  if (tracked.worked) block.busy.push_back(slot);
  block.released += tracked.memory.state == NodeContact::State::released;
}

ContactPass::Link ContactPass::link(std::uint32_t slot, const Meeting& meeting, const Tracked& now,
                                    const Vector& friction_before, const Velocities& velocities, double dt) const {
  Link link;
  link.segment = meeting.hit->segment;
  link.weights = corner_weights(scene_.line(link.segment), meeting.pair->closest.s, meeting.pair->closest.t);
  link.normal = contact::free_direction(scene_, slot, link.segment, *meeting.pair);
  const ContactSprings::Spring& spring = now.partner.spring;
  LinkSpring law{spring.stiffness, ContactSprings::damping(spring, scene_.contact.vdc), friction_.any(), {}, 0};
  if (law.rubs) {
    law.friction = friction_.between(scene_.nodes.part[slot],
                                     contact::part_of(setting_.model.mesh, scene_.segments, link.segment));
    law.area = segment_area(scene_.facet(link.segment));
  }
  link.press(law, now.penetration - now.memory.forgiven, velocities.node - velocities.of_segment(link.weights),
             friction_before, dt);
  return link;
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

double ContactPass::update(State& state, double used, ContactCounters& counters) {
  const std::size_t places = candidates_.slots().size() + lost_.size();
  blocks_.resize((places + block_size - 1) / block_size);
  parallel_for(blocks_.size(), 1, [&](std::size_t begin, std::size_t end) {
    static thread_local Scratch scratch;
    Scratch& own = scratch;
    for (std::size_t b = begin; b < end; ++b) {
      Block& block = blocks_[b];
      block.clear();
      const std::size_t last = std::min(places, (b + 1) * block_size);
      for (std::size_t place = b * block_size; place < last; ++place) look(place, state, used, own, block);
    }
  });
  double longest = 0;
  for (const Block& block : blocks_) {
    counters.nodes += block.nodes;
    counters.pairs += block.pairs;
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
  for (const Block& block : blocks_) {
    result.moved += block.moves.size();
    result.released += block.released;
    for (const std::uint32_t slot : block.busy) apply_one(slot, state, forces, result);
  }
}

void ContactPass::add_energies(const Work& work, ContactState& result) const {
  result.friction += work.friction;
  result.damping += work.damping;
  const bool all_a = result.single_surface;
  (exchanged_ && !all_a ? result.energy_b : result.energy_a) += work.on_tracked;
  (exchanged_ || all_a ? result.energy_a : result.energy_b) += work.on_reference;
}

void ContactPass::apply_one(std::uint32_t slot, const State& state, Forces& forces, ContactState& result) const {
  const Tracked& tracked = tracked_[slot];
  if (tracked.worked) add_energies(tracked.work, result);
  if (!tracked.active) return;
  const Link& link = tracked.link;
  const Vector force = link.force();
  result.touching += link.push > 0;
  const std::uint32_t node = scene_.nodes.node[slot].value;
  forces.force[node] += force;
  const model::SegmentNodes& corners = scene_.segments.nodes[link.segment];
  for (std::size_t c = 0; c < 4; ++c) forces.force[corners[c].value] -= link.weights[c] * force;
  if (result.single_surface) return;
  Vector foot = Vector::Zero();
  for (std::size_t c = 0; c < 4; ++c) foot += link.weights[c] * state.x[corners[c].value];
  (exchanged_ ? result.force_b : result.force_a) += force;
  (exchanged_ ? result.force_a : result.force_b) -= force;
  (exchanged_ ? result.moment_b : result.moment_a) += state.x[node].cross(force);
  (exchanged_ ? result.moment_a : result.moment_b) -= foot.cross(force);
}

void ContactPass::links(std::vector<ContactLink>& links) const {
  for (std::uint32_t slot = 0; slot < tracked_.size(); ++slot) {
    const Tracked& tracked = tracked_[slot];
    if (!tracked.active) continue;
    ContactLink& link = links.emplace_back();
    link.tracked = {{scene_.nodes.node[slot]}, {1}};
    link.reference = {scene_.segments.nodes[tracked.link.segment], tracked.link.weights};
    link.exchanged = exchanged_;
    link.force = tracked.link.force();
  }
}

void ContactPass::carry_over(InterfacePass& before, const State& state, ContactState& result) {
  auto* const old = dynamic_cast<ContactPass*>(&before);
  if (old == nullptr) return before.rest(state, result);
  std::unordered_map<contact::SegmentKey, std::uint32_t, contact::SegmentKeyHash> segments;
  for (std::uint32_t s = 0; s < scene_.segments.size(); ++s)
    segments.try_emplace(contact::segment_key(scene_.segments.nodes[s]), s);
  // Which side of a segment is its front does not change.
  std::vector<bool>& flipped = side_.scene().flipped;
  for (std::uint32_t s = 0; s < old->scene_.segments.size() && !(flipped.empty() && old->scene_.flipped.empty()); ++s) {
    const auto now = segments.find(contact::segment_key(old->scene_.segments.nodes[s]));
    flipped.resize(scene_.segments.size(), false);
    if (now != segments.end()) flipped[now->second] = !old->scene_.flipped.empty() && old->scene_.flipped[s];
  }
  const std::vector<NodeIndex>& nodes = scene_.nodes.node;
  for (std::uint32_t slot = 0; slot < old->tracked_.size(); ++slot) {
    const Tracked& was = old->tracked_[slot];
    const auto at = std::lower_bound(nodes.begin(), nodes.end(), old->scene_.nodes.node[slot],
                                     [](NodeIndex a, NodeIndex b) { return a.value < b.value; });
    const bool there = at != nodes.end() && *at == old->scene_.nodes.node[slot];
    const auto segment = was.active
                             ? segments.find(contact::segment_key(old->scene_.segments.nodes[was.link.segment]))
                             : segments.end();
    const bool goes_on = there && segment != segments.end();
    if (was.active && !goes_on) {
      Work work;
      old->add_work(was.link, old->velocities(slot, was.link.segment, state), state.dt, work);
      old->add_energies(work, result);
    }
    if (!there) continue;
    Tracked& tracked = tracked_[static_cast<std::size_t>(at - nodes.begin())];
    tracked = {};
    tracked.memory = was.memory;
    if (!goes_on) continue;
    tracked.active = true;
    tracked.penetration = was.penetration;
    tracked.link = was.link;
    tracked.link.segment = segment->second;
  }
}

void ContactPass::rest(const State& state, ContactState& result) {
  for (Tracked& tracked : tracked_) {
    if (tracked.active) {
      Work work;
      add_work(tracked.link, velocities(static_cast<std::uint32_t>(&tracked - tracked_.data()), tracked.link.segment, state),
               state.dt, work);
      add_energies(work, result);
    }
    tracked.active = tracked.worked = false;
    tracked.work = {};
    tracked.memory = {};
    tracked.sleep = 0;
  }
  blocks_.clear();
}

std::vector<ContactNode> ContactPass::nodes() const {
  std::vector<ContactNode> all;
  for (std::uint32_t slot = 0; slot < tracked_.size(); ++slot) {
    const Tracked& tracked = tracked_[slot];
    const bool released = tracked.memory.state == NodeContact::State::released;
    if (!tracked.active && !released) continue;
    ContactNode node;
    const double push = tracked.link.push + tracked.link.damping;
    node.kind = released ? ContactNode::Kind::released
                : push > 0 ? ContactNode::Kind::touching
                           : ContactNode::Kind::kept;
    node.node = scene_.nodes.node[slot];
    node.segment = scene_.segments.nodes[tracked.link.segment];
    node.force = tracked.link.force();
    node.penetration = tracked.penetration;
    node.forgiven = tracked.memory.forgiven;
    const double area = segment_area(scene_.facet(tracked.link.segment));
    node.pressure = area > 0 ? push / area : 0;
    all.push_back(node);
  }
  return all;
}

}  // namespace gapcheck::solver
