#include "solver/contact_pass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "contact/orientation.hpp"
#include "contact/outcome.hpp"
#include "contact/release.hpp"

namespace gapcheck::solver {

using contact::Candidate;
using contact::Hit;
using contact::NodeAction;
using contact::NodeContact;
using contact::PairResult;

namespace {

constexpr std::size_t grain = 256;

/// Weights of a segment's corners at parametric coordinates; of a triangle the last two belong to one node.
std::array<double, 4> corner_weights(double s, double t) {
  const double left = (1 - s) / 2, right = (1 + s) / 2, low = (1 - t) / 2, high = (1 + t) / 2;
  return {left * low, right * low, right * high, left * high};
}

double segment_area(const geometry::Facet& f) { return (f.x[2] - f.x[0]).cross(f.x[3] - f.x[1]).norm() / 2; }

}  // namespace

/// How a tracked node lies to the segments of the other side.
struct ContactPass::Meeting {
  std::optional<Hit> hit;
  PairResult pair;       ///< with the hit's segment
  bool in_zone = false;  ///< some segment is nearer than the contact distance
};

ContactPass::ContactPass(const ContactSetting& setting, std::uint32_t contact, const contact::ContactSurfaces& surfaces,
                         bool exchanged, const std::vector<Vector>& x)
    : setting_(setting),
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

void ContactPass::search(double margin, ContactCounters& counters) {
  contact::SweepCounters sweep;
  candidates_.search(scene_, rules_, setting_.search, margin, sweep);
  counters.candidates += candidates_.size();
  std::vector<bool> found(tracked_.size(), false);
  for (const std::uint32_t slot : candidates_.slots()) {
    found[slot] = true;
    tracked_[slot].sleep = 0;
    tracked_[slot].release_segment = 0;
  }
  lost_.clear();
  for (std::uint32_t slot = 0; slot < tracked_.size(); ++slot)
    if (!found[slot] && (tracked_[slot].active || tracked_[slot].memory.state != NodeContact::State::apart))
      lost_.push_back(slot);
}

ContactPass::Meeting ContactPass::meet(std::uint32_t slot, std::span<Candidate> candidates, double used,
                                       Tracked& tracked, Look& out) const {
  static thread_local std::vector<Hit> hits, measured;
  static thread_local std::vector<PairResult> results;
  hits.clear();
  measured.clear();
  results.clear();
  double wake = std::numeric_limits<double>::infinity();
  for (Candidate& candidate : candidates) {
    if (!(candidate.wake > used)) {
      const std::uint32_t s = candidate.segment;
      const PairResult pair = contact::decide_pair(scene_, slot, s);
      ++out.pairs;
      const double h = scene_.nodes.half[slot] + scene_.segments.half[s];
      const bool oriented = scene_.oriented(s);
      candidate.wake = used + std::abs(pair.distance) - (oriented ? greatest_reach_ : h);
      if (pair.penetrates) {
        hits.push_back({slot, s, pair.distance, pair.in_band});
        results.push_back(pair);
      } else if (oriented) {
        measured.push_back({slot, s, pair.distance, pair.in_band});
      }
    }
    wake = std::min(wake, candidate.wake);
  }
  Meeting meeting;
  meeting.in_zone = !hits.empty();
  if (meeting.in_zone) {
    meeting.hit = contact::choose_hit(scene_, hits, measured);
    for (std::size_t i = 0; meeting.hit && i < hits.size(); ++i)
      if (hits[i].segment == meeting.hit->segment) meeting.pair = results[i];
  }
  tracked.sleep = meeting.in_zone ? 0 : wake;
  return meeting;
}

ContactPass::Look ContactPass::look(std::size_t place, const State& state, double used) {
  Look out;
  const bool lost = place >= candidates_.slots().size();
  const std::uint32_t slot = lost ? lost_[place - candidates_.slots().size()] : candidates_.slots()[place];
  Tracked& tracked = tracked_[slot];
  tracked.worked = false;
  if (tracked.sleep > used && !lost) return out;
  tracked.work = {};
  const Tracked before = tracked;
  if (before.active) add_work(slot, before.link, state, tracked.work);
  const Meeting meeting =
      meet(slot, lost ? std::span<Candidate>{} : candidates_.of(place), used, tracked, out);
  contact::NodeEncounter encounter;
  encounter.in_zone = meeting.in_zone;
  if (meeting.hit && meeting.hit->in_band) {
    const std::uint32_t segment = meeting.hit->segment;
    encounter.penetrates = true;
    encounter.penetration = scene_.nodes.half[slot] + scene_.segments.half[segment] - meeting.pair.distance;
    // It follows from thickness and the size of elements, which change little from one search to the next.
    if (tracked.release_segment != segment + 1) {
      tracked.release_depth = contact::release_depth(scene_, slot, segment);
      tracked.release_segment = segment + 1;
    }
    encounter.release_depth = tracked.release_depth;
    encounter.movable = setting_.movable[scene_.nodes.node[slot].value];
  }
  tracked.penetration = encounter.penetration;
  const NodeAction action = contact::advance(tracked.memory, scene_.settings, encounter);
  tracked.active = action == NodeAction::force;
  tracked.link = {};
  if (encounter.penetrates) tracked.link.segment = meeting.hit->segment;
  if (tracked.active) {
    tracked.link = link(slot, meeting, before, state);
    tracked.link.push = std::max(0.0, tracked.link.push);
    add_work(slot, tracked.link, state, tracked.work);
  }
  if (action == NodeAction::move) {
    out.moves = true;
    out.move = contact::shooting_move * encounter.penetration *
               contact::free_direction(scene_, slot, meeting.hit->segment, meeting.pair);
    tracked.sleep = 0;
  }
  tracked.worked = before.active || tracked.active;
  return out;
}

ContactPass::Link ContactPass::link(std::uint32_t slot, const Meeting& meeting, const Tracked& before,
                                    const State& state) const {
  Link link;
  link.segment = meeting.hit->segment;
  link.weights = corner_weights(meeting.pair.closest.s, meeting.pair.closest.t);
  link.normal = contact::free_direction(scene_, slot, link.segment, meeting.pair);
  const ContactSprings::Spring spring = springs_(slot, link.segment);
  const Tracked& now = tracked_[slot];
  link.push = spring.stiffness * (now.penetration - now.memory.forgiven);
  const double percent = scene_.contact.vdc;
  if (percent <= 0 && !friction_.any()) return link;
  const Vector velocity = relative_velocity(slot, link, state);
  // Damping slows both ways but never pulls.
  if (percent > 0)
    link.damping = std::max(-link.push, -ContactSprings::damping(spring, percent) * velocity.dot(link.normal));
  if (friction_.any())
    link.friction = friction(slot, link, before.active ? before.link.friction : Vector::Zero(), spring.stiffness,
                             velocity, state.dt);
  return link;
}

Vector ContactPass::friction(std::uint32_t slot, const Link& link, const Vector& before, double stiffness,
                             const Vector& velocity, double dt) const {
  const Vector& n = link.normal;
  const Vector sliding = velocity - velocity.dot(n) * n;
  const PartIndex part = contact::part_of(setting_.model.mesh, scene_.segments, link.segment);
  const model::FrictionLaw law = friction_.between(scene_.nodes.part[slot], part);
  const double limit = contact::friction_limit(law, sliding.norm(), link.push + link.damping,
                                               segment_area(scene_.facet(link.segment)));
  // Elastic sticking up to the limit, with the stiffness of the normal spring.
  Vector force = before - before.dot(n) * n - stiffness * dt * sliding;
  const double size = force.norm();
  if (size > limit) force *= size > 0 ? limit / size : 0;
  return force;
}

Vector ContactPass::relative_velocity(std::uint32_t slot, const Link& link, const State& state) const {
  Vector velocity = state.v[scene_.nodes.node[slot].value];
  const model::SegmentNodes& corners = scene_.segments.nodes[link.segment];
  for (std::size_t c = 0; c < 4; ++c) velocity -= link.weights[c] * state.v[corners[c].value];
  return velocity;
}

void ContactPass::add_work(std::uint32_t slot, const Link& link, const State& state, Work& work) const {
  const double half = state.dt / 2;
  const Vector velocity = relative_velocity(slot, link, state);
  const Vector& of_node = state.v[scene_.nodes.node[slot].value];
  const Vector force = link.force();
  work.normal -= half * link.push * link.normal.dot(velocity);
  work.damping -= half * link.damping * link.normal.dot(velocity);
  work.friction -= half * link.friction.dot(velocity);
  work.on_node -= half * force.dot(of_node);
  work.on_segment += half * force.dot(of_node - velocity);
}

double ContactPass::update(State& state, double used, ContactCounters& counters) {
  const std::size_t near = candidates_.slots().size(), places = near + lost_.size();
  looks_.assign(places, {});
  parallel_for(places, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) looks_[i] = look(i, state, used);
  });
  busy_.clear();
  double longest = 0;
  moved_ = released_ = 0;
  for (std::size_t i = 0; i < places; ++i) {
    const std::uint32_t slot = i < near ? candidates_.slots()[i] : lost_[i - near];
    counters.nodes += looks_[i].pairs > 0;
    counters.pairs += looks_[i].pairs;
    released_ += tracked_[slot].memory.state == NodeContact::State::released;
    if (tracked_[slot].active || tracked_[slot].worked) busy_.push_back(slot);
    if (!looks_[i].moves) continue;
    state.x[scene_.nodes.node[slot].value] += looks_[i].move;
    longest = std::max(longest, looks_[i].move.norm());
    ++moved_;
  }
  // What is lost has nothing to be looked at again; of those far from everything the memory is gone.
  lost_.clear();
  return longest;
}

void ContactPass::apply(Forces& forces, ContactState& result) const {
  result.moved += moved_;
  result.released += released_;
  for (const std::uint32_t slot : busy_) {
    const Tracked& tracked = tracked_[slot];
    if (tracked.worked) {
      const Work& work = tracked.work;
      result.friction += work.friction;
      result.damping += work.damping;
      const bool all_a = result.single_surface;
      (exchanged_ && !all_a ? result.energy_b : result.energy_a) += work.on_node;
      (exchanged_ || all_a ? result.energy_a : result.energy_b) += work.on_segment;
    }
    if (!tracked.active) continue;
    const Vector force = tracked.link.force();
    result.touching += tracked.link.push > 0;
    forces.force[scene_.nodes.node[slot].value] += force;
    const model::SegmentNodes& corners = scene_.segments.nodes[tracked.link.segment];
    for (std::size_t c = 0; c < 4; ++c) forces.force[corners[c].value] -= tracked.link.weights[c] * force;
    if (result.single_surface) continue;
    result.force_a += exchanged_ ? Vector(-force) : force;
    result.force_b -= exchanged_ ? Vector(-force) : force;
  }
}

void ContactPass::rest(const State& state, ContactState& result) {
  moved_ = released_ = 0;
  busy_.clear();
  Forces nothing;
  for (std::uint32_t slot = 0; slot < tracked_.size(); ++slot) {
    Tracked& tracked = tracked_[slot];
    tracked.worked = tracked.active;
    tracked.work = {};
    if (tracked.active) {
      add_work(slot, tracked.link, state, tracked.work);
      busy_.push_back(slot);
    }
    tracked.active = false;
    tracked.memory = {};
    tracked.sleep = 0;
  }
  apply(nothing, result);
  busy_.clear();
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
