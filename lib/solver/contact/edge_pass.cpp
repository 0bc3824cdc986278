#include "solver/contact/edge_pass.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "contact/search/box_pairs.hpp"
#include "contact/pair/release.hpp"
#include "contact/stiffness/segment_mass.hpp"
#include "contact/stiffness/stiffness.hpp"

namespace gapcheck::solver {

using contact::NodeAction;
using contact::NodeContact;
using contact::SurfaceEdge;

namespace {

/// Pairs that are looked at in one go.
constexpr std::size_t pairs_per_block = 256;
/// Covers the rounding of distances between edges that are still some margin apart.
constexpr double rounding_of_distance = 1 + 1e-9;

ContactPoint point_of(const SurfaceEdge& edge, double place) {
  return {{edge.a, edge.b, edge.b, edge.b}, {(1 - place) / 2, (1 + place) / 2, 0, 0}};
}

double half_sum(const SurfaceEdge& e, const SurfaceEdge& f) { return e.half + f.half; }

}  // namespace

/// How two edges lie to one another in this cycle.
struct EdgePass::Meeting {
  contact::NodeEncounter encounter;
  geometry::EdgesClosest closest;
  double distance = 0;
};

EdgePass::EdgePass(const ContactSetting& setting, std::uint32_t contact, const contact::ContactSurfaces& surfaces,
                   const std::vector<Vector>& x)
    : setting_(setting),
      edge_scene_(setting.model, contact, surfaces, x, !surfaces.two_sided()),
      scene_(edge_scene_.scene()),
      exclusions_(setting.model, setting.model.contacts[contact].id),
      rules_(scene_, exclusions_, setting.ties),
      friction_(setting.model, setting.model.contacts[contact]),
      edges_(edge_scene_.edges()) {
  const model::Contact& card = scene_.contact;
  const double slsfac = setting.model.controls.slsfac, solid_modulus = card.sldthk > 0 ? card.sldstf : 0;
  for (const SurfaceEdge& edge : edges_) {
    Spring spring;
    spring.scale = slsfac * (edge_scene_.on_b(edge) ? card.sfm : card.sfs);
    spring.stiffness =
        setting.masses.springs(scene_.segments, edge.segment, spring.scale, false, solid_modulus).stiffness;
    spring.mass = setting.masses.mass[edge.a.value] + setting.masses.mass[edge.b.value];
    spring.segment_mass =
        contact::segment_mass(setting.model, setting.masses.sizes, setting.masses.mass, scene_.segments, edge.segment);
    spring.part = contact::part_of(setting.model.mesh, scene_.segments, edge.segment);
    springs_.push_back(spring);
  }
}

/// Keys of the pairs that can touch before the margin is used up, ascending.
std::vector<std::uint64_t> EdgePass::find(double margin) const {
  std::vector<geometry::Edge> ends(edges_.size());
  std::vector<contact::Bounds> boxes(edges_.size());
  parallel_for(edges_.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      ends[i] = contact::ends_of(scene_, edges_[i]);
      if (!ends[i][0].allFinite() || !ends[i][1].allFinite()) continue;
      boxes[i].add(ends[i][0]);
      boxes[i].add(ends[i][1]);
      boxes[i] = contact::grown(boxes[i], edges_[i].half + margin / 2);
    }
  });
  tbb::enumerable_thread_specific<std::vector<std::uint64_t>> found;
  contact::for_each_box_pair(boxes, [&](std::uint32_t i, std::uint32_t k) {
    const bool swap = scene_.line(edges_[k].segment) && !scene_.line(edges_[i].segment);
    const std::uint32_t tracked = swap ? k : i, other = swap ? i : k;
    const SurfaceEdge &e = edges_[tracked], &f = edges_[other];
    const double reach = (half_sum(e, f) + margin) * rounding_of_distance;
    if (!(geometry::closest_points(ends[tracked], ends[other]).squared_distance <= reach * reach)) return;
    if (!edge_scene_.opposite(e, f) || contact::edges_are_joined(scene_, e, f) || !rules_(e, f)) return;
    found.local().push_back(std::uint64_t{tracked} << 32 | other);
  });
  std::vector<std::uint64_t> keys;
  for (const auto& mine : found) keys.insert(keys.end(), mine.begin(), mine.end());
  std::sort(keys.begin(), keys.end());
  return keys;
}

void EdgePass::search(double margin, ContactCounters& counters) {
  const std::vector<std::uint64_t> keys = find(margin);
  counters.candidates += keys.size();
  std::vector<Pair> before = std::move(pairs_);
  pairs_.clear();
  pairs_.reserve(keys.size());
  auto old = before.begin();
  // What is in contact stays, however deep it has come.
  const auto keep = [&](Pair& pair) {
    if (!pair.touch || (!pair.touch->active && pair.touch->memory.state == NodeContact::State::apart)) return;
    pair.wake = 0;
    pairs_.push_back(std::move(pair));
  };
  for (const std::uint64_t key : keys) {
    for (; old != before.end() && old->key() < key; ++old) keep(*old);
    Pair& pair = pairs_.emplace_back();
    if (old != before.end() && old->key() == key) pair = std::move(*old++);
    pair.tracked = static_cast<std::uint32_t>(key >> 32);
    pair.other = static_cast<std::uint32_t>(key);
    pair.wake = 0;
  }
  for (; old != before.end(); ++old) keep(*old);
}

EdgePass::Meeting EdgePass::meet(Pair& pair) const {
  const SurfaceEdge &e = edges_[pair.tracked], &f = edges_[pair.other];
  const geometry::Edge x = contact::ends_of(scene_, e), y = contact::ends_of(scene_, f);
  const double h = half_sum(e, f);
  const contact::EdgeMeeting now = contact::meet_edges(scene_, x, y, h);
  Meeting meeting;
  meeting.closest = now.closest;
  meeting.distance = std::sqrt(now.closest.squared_distance);
  meeting.encounter.in_zone = meeting.distance < h;
  if (!now.closest.interior) {
    pair.side.setZero();
    return meeting;
  }
  const Vector way = now.closest.first - now.closest.second;
  Vector side = (x[1] - x[0]).cross(y[1] - y[0]).stableNormalized();
  const bool known = pair.side != Vector::Zero();
  if (side.dot(known ? pair.side : way) < 0) side = -side;
  pair.side = side;
  const double distance = way.dot(side);
  const bool passed = distance < 0;
  contact::NodeEncounter& encounter = meeting.encounter;
  encounter.penetrates = passed || now.penetrates;
  encounter.in_zone = encounter.in_zone || passed;
  encounter.penetration = h - distance;
  encounter.movable = false;
  contact::ReleasePair release;
  release.node_thickness = 2 * e.half;
  release.segment_thickness = release.element_thickness = 2 * f.half;
  encounter.release_depth =
      scene_.type.by_segments()
          ? std::numeric_limits<double>::infinity()
          : contact::release_depth(scene_.contact, scene_.type, scene_.settings, setting_.model.controls, release);
  return meeting;
}

LinkSpring EdgePass::spring(const Pair& pair) const {
  const Spring &e = springs_[pair.tracked], &f = springs_[pair.other];
  const double thickness = 2 * edges_[pair.tracked].half;
  const model::Contact& contact = scene_.contact;
  const std::int64_t soft = contact.soft == 2 && !scene_.type.by_segments() ? 1 : contact.soft;
  const double first = e.stiffness > 0 ? e.stiffness : f.stiffness;
  const double second = f.stiffness > 0 ? f.stiffness : e.stiffness;
  ContactSprings::Spring masses{0, e.mass, f.mass};
  LinkSpring spring;
  if (soft == 2) {
    spring.stiffness = contact::soft_2_stiffness(e.scale, e.segment_mass, f.segment_mass, timestep_);
  } else {
    spring.stiffness = contact::spring_stiffness(setting_.model.controls.penopt, {first, second, first, thickness});
    if (soft == 1)
      spring.stiffness = contact::soft_1_spring(spring.stiffness, contact.sofscl,
                                                contact::soft_1_stiffness(e.mass, f.mass, timestep_));
  }
  masses.stiffness = spring.stiffness;
  spring.damping = ContactSprings::damping(masses, contact.vdc);
  spring.rubs = friction_.any();
  if (spring.rubs) {
    spring.friction = friction_.between(e.part, f.part);
    // Two crossing strips as wide as they are thick.
    spring.area = thickness * 2 * edges_[pair.other].half;
  }
  return spring;
}

NodeAction EdgePass::advance(NodeContact& memory, const contact::NodeEncounter& encounter) const {
  if (!scene_.type.by_segments()) return contact::advance(memory, scene_.settings, encounter);
  return contact::advance_from_baseline(memory, encounter, first_, reduction_);
}

void EdgePass::look(std::uint32_t number, const State& state, double used, Block& block) {
  Pair& pair = pairs_[number];
  if (pair.touch && !pair.touch->active && pair.touch->memory.state == NodeContact::State::apart) pair.touch.reset();
  if (!pair.touch && pair.wake > used) return;
  ++block.looks;
  Touch* touch = pair.touch.get();
  if (touch != nullptr) touch->worked = touch->active;
  LinkWork work;
  const auto add_work = [&] {
    work.add(touch->force, touch->point[0].of(state.v), touch->point[1].of(state.v), state.dt);
  };
  const Vector friction = touch != nullptr && touch->active ? touch->force.friction : Vector(Vector::Zero());
  if (touch != nullptr && touch->active) add_work();
  const Meeting meeting = meet(pair);
  const bool started = touch == nullptr;
  if (started) {
    pair.wake = used + meeting.distance - half_sum(edges_[pair.tracked], edges_[pair.other]);
    if (!meeting.encounter.penetrates) return;
    touch = (pair.touch = std::make_unique<Touch>()).get();
  }
  const NodeAction action = advance(touch->memory, meeting.encounter);
  // What was not there in the last step cannot be deeper than the edges have come closer since: the rest a pair of
  // neighbouring edges has left to this one, and nothing of that is forgiven.
  if (started && !first_ && !scene_.type.by_segments()) {
    const Vector nearing = point_of(edges_[pair.other], meeting.closest.t).of(state.v) -
                           point_of(edges_[pair.tracked], meeting.closest.s).of(state.v);
    touch->memory.forgiven = std::min(touch->memory.forgiven, std::max(0.0, nearing.dot(pair.side) * state.dt));
  }
  touch->penetration = meeting.encounter.penetration;
  touch->active = action == NodeAction::force;
  touch->point = {point_of(edges_[pair.tracked], meeting.closest.s), point_of(edges_[pair.other], meeting.closest.t)};
  if (touch->active) {
    touch->force.normal = pair.side;
    touch->force.press(spring(pair), touch->penetration - touch->memory.forgiven,
                       touch->point[0].of(state.v) - touch->point[1].of(state.v), friction, state.dt);
    add_work();
  } else {
    touch->force = {};
  }
  touch->worked = touch->worked || touch->active;
  touch->work = work;
  block.released += touch->memory.state == NodeContact::State::released;
  if (touch->worked) block.busy.push_back(number);
}

double EdgePass::update(State& state, double used, ContactCounters& counters) {
  if (scene_.type.by_segments()) reduction_ = contact::baseline_reduction(setting_.model, scene_.contact, state.time);
  blocks_.resize((pairs_.size() + pairs_per_block - 1) / pairs_per_block);
  parallel_for(blocks_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      blocks_[b].looks = blocks_[b].released = 0;
      blocks_[b].busy.clear();
      for (std::size_t i = b * pairs_per_block; i < std::min(pairs_.size(), (b + 1) * pairs_per_block); ++i)
        look(static_cast<std::uint32_t>(i), state, used, blocks_[b]);
    }
  });
  first_ = false;
  for (const Block& block : blocks_) counters.pairs += block.looks;
  return 0;
}

void EdgePass::add_energies(const LinkWork& work, bool exchanged, ContactState& result) {
  result.friction += work.friction;
  result.damping += work.damping;
  const bool all_a = result.single_surface;
  (exchanged && !all_a ? result.energy_b : result.energy_a) += work.on_tracked;
  (exchanged || all_a ? result.energy_a : result.energy_b) += work.on_reference;
}

void EdgePass::apply(const State& state, Forces& forces, ContactState& result) const {
  for (const Block& block : blocks_) {
    result.released += block.released;
    for (const std::uint32_t number : block.busy) {
      const Pair& pair = pairs_[number];
      const Touch& touch = *pair.touch;
      const bool from_b = exchanged(pair);
      add_energies(touch.work, from_b, result);
      if (!touch.active) continue;
      result.touching += touch.force.push > 0;
      const Vector force = touch.force.force();
      for (std::size_t side = 0; side < 2; ++side) {
        const ContactPoint& point = touch.point[side];
        const Vector on_point = side == 0 ? force : Vector(-force);
        for (std::size_t end = 0; end < 2; ++end)
          forces.force[point.nodes[end].value] += point.weights[end] * on_point;
        if (result.single_surface) continue;
        const bool on_b = from_b == (side == 0);
        (on_b ? result.force_b : result.force_a) += on_point;
        (on_b ? result.moment_b : result.moment_a) += point.of(state.x).cross(on_point);
      }
    }
  }
}

void EdgePass::carry_over(InterfacePass& before, const State& state, ContactState& result) {
  auto* const old = dynamic_cast<EdgePass*>(&before);
  if (old == nullptr) return before.rest(state, result);
  first_ = old->first_;
  // Beams may lie on edges of shells.
  const auto ends = [](const EdgePass& pass, const SurfaceEdge& edge) {
    return std::tuple(std::min(edge.a, edge.b), std::max(edge.a, edge.b), pass.scene_.line(edge.segment));
  };
  std::map<std::tuple<NodeIndex, NodeIndex, bool>, std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < edges_.size(); ++i) numbers.emplace(ends(*this, edges_[i]), i);
  std::set<std::uint64_t> taken;
  pairs_.clear();
  for (Pair& was : old->pairs_) {
    const auto tracked = numbers.find(ends(*old, old->edges_[was.tracked]));
    const auto other = numbers.find(ends(*old, old->edges_[was.other]));
    if (tracked == numbers.end() || other == numbers.end()) continue;
    const bool swapped = scene_.line(edges_[tracked->second].segment) == scene_.line(edges_[other->second].segment) &&
                         tracked->second > other->second;
    if (swapped || !taken.insert(std::uint64_t{tracked->second} << 32 | other->second).second) continue;
    Pair& pair = pairs_.emplace_back(std::move(was));
    pair.tracked = tracked->second;
    pair.other = other->second;
    pair.wake = 0;
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const Pair& a, const Pair& b) { return a.key() < b.key(); });
  old->rest(state, result);  // of what has ended
}

void EdgePass::rest(const State& state, ContactState& result) {
  for (Pair& pair : pairs_) {
    if (pair.touch && pair.touch->active) {
      LinkWork work;
      work.add(pair.touch->force, pair.touch->point[0].of(state.v), pair.touch->point[1].of(state.v), state.dt);
      add_energies(work, exchanged(pair), result);
    }
    pair.touch.reset();
    pair.side.setZero();
    pair.wake = 0;
  }
  blocks_.clear();
  first_ = true;
}

std::vector<ContactNode> EdgePass::nodes() const {
  std::vector<ContactNode> all;
  for (const Pair& pair : pairs_) {
    if (!pair.touch) continue;
    const Touch& touch = *pair.touch;
    const bool released = touch.memory.state == NodeContact::State::released;
    if (!touch.active && !released) continue;
    const SurfaceEdge &e = edges_[pair.tracked], &f = edges_[pair.other];
    ContactNode node;
    const double push = touch.force.push + touch.force.damping;
    node.kind = released   ? ContactNode::Kind::released
                : push > 0 ? ContactNode::Kind::touching
                           : ContactNode::Kind::kept;
    node.node = touch.point[0].weights[0] >= touch.point[0].weights[1] ? e.a : e.b;
    node.segment = {f.a, f.b, f.b, f.b};
    node.force = touch.force.force();
    node.penetration = touch.penetration;
    node.forgiven = touch.memory.forgiven;
    all.push_back(node);
  }
  return all;
}

void EdgePass::links(std::vector<ContactLink>& links) const {
  for (const Pair& pair : pairs_)
    if (pair.touch && pair.touch->active)
      links.push_back({pair.touch->point[0], pair.touch->point[1], exchanged(pair), pair.touch->force.force()});
}

}  // namespace gapcheck::solver
