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
#include "contact/pair/release.hpp"

namespace gapcheck::solver {

using contact::NodeAction;
using contact::NodeContact;
using contact::SurfaceEdge;

namespace {

/// Pairs that are checked together.
constexpr std::size_t pairs_per_block = 256;
/// Covers the rounding of distances between edges that are still apart by some of the margin.
constexpr double rounding_of_distance = 1 + 1e-9;

ContactPoint point_of(const SurfaceEdge& edge, double place) {
  return {{edge.a, edge.b, edge.b, edge.b}, {(1 - place) / 2, (1 + place) / 2, 0, 0}};
}

double half_sum(const SurfaceEdge& e, const SurfaceEdge& f) { return e.half + f.half; }

/// Relative position of two edges in this cycle.
struct Encounter {
  contact::NodeEncounter state;
  geometry::EdgesClosest closest;
  double distance = 0;
};

/// Decides two edges against each other. `last_side`: EdgePair::side, is updated.
Encounter measure_edges(const contact::PairScene& scene, const SurfaceEdge& e, const SurfaceEdge& f,
                        Vector& last_side) {
  const geometry::Edge x = contact::ends_of(scene, e), y = contact::ends_of(scene, f);
  const double h = half_sum(e, f);
  const contact::EdgeMeeting now = contact::meet_edges(scene, x, y, h);
  Encounter result;
  result.closest = now.closest;
  result.distance = std::sqrt(now.closest.squared_distance);
  result.state.in_zone = result.distance < h;
  if (!now.closest.interior) {
    last_side.setZero();
    return result;
  }
  const Vector way = now.closest.first - now.closest.second;
  Vector side = (x[1] - x[0]).cross(y[1] - y[0]).stableNormalized();
  const bool known = last_side != Vector::Zero();
  if (side.dot(known ? last_side : way) < 0) side = -side;
  last_side = side;
  const double distance = way.dot(side);
  const bool passed = distance < 0;
  contact::NodeEncounter& encounter = result.state;
  encounter.penetrates = passed || now.penetrates;
  encounter.in_zone = encounter.in_zone || passed;
  encounter.penetration = h - distance;
  encounter.movable = false;
  contact::ReleasePair release;
  release.node_thickness = 2 * e.half;
  release.segment_thickness = release.element_thickness = 2 * f.half;
  encounter.release_depth = scene.type.by_segments() ? std::numeric_limits<double>::infinity()
                                                     : contact::release_depth(scene.contact, scene.type, scene.settings,
                                                                              scene.model.controls, release);
  return result;
}

/// Whether two edges were in each other's sight in the cycle before.
bool were_followed(const contact::PairScene& scene, const SurfaceEdge& e, const SurfaceEdge& f, const State& state) {
  const auto ends_before = [&](const SurfaceEdge& edge) {
    const geometry::Edge now = contact::ends_of(scene, edge);
    return geometry::Edge{Vector(now[0] - state.dt * state.v[edge.a.value]),
                          Vector(now[1] - state.dt * state.v[edge.b.value])};
  };
  const geometry::Edge x = ends_before(e), y = ends_before(f);
  double largest = 0;
  for (const geometry::Edge* edge : {&x, &y})
    for (const Vector& end : *edge) largest = std::max(largest, end.cwiseAbs().maxCoeff());
  const double h = half_sum(e, f), distance = std::sqrt(geometry::closest_points(x, y).squared_distance);
  return contact::was_followed(distance, h, h, contact::default_tolerance(h, largest));
}

}  // namespace

EdgePass::EdgePass(const ContactSetting& setting, ContactIndex contact, const contact::ContactSurfaces& surfaces,
                   const std::vector<Vector>& x)
    : model_(setting.model),
      edge_scene_(setting.model, contact, surfaces, x, !surfaces.two_sided()),
      scene_(edge_scene_.scene()),
      exclusions_(setting.model, setting.model.contact(contact).id),
      rules_(scene_, exclusions_, setting.ties),
      edges_(edge_scene_.edges()),
      springs_(setting, contact, edge_scene_, edges_) {}

std::vector<std::uint64_t> EdgePass::find_keys(double margin, ContactCounters& counters) const {
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
  const auto visit = [&](std::uint32_t i, std::uint32_t k) {
    const bool swap = scene_.line(edges_[k].segment) && !scene_.line(edges_[i].segment);
    const std::uint32_t tracked = swap ? k : i, other = swap ? i : k;
    const SurfaceEdge &e = edges_[tracked], &f = edges_[other];
    const double reach = (half_sum(e, f) + margin) * rounding_of_distance;
    if (!(geometry::closest_points(ends[tracked], ends[other]).squared_distance <= reach * reach)) return;
    if (!edge_scene_.opposite(e, f) || contact::edges_are_joined(scene_, e, f) || !rules_(e, f)) return;
    found.local().push_back(std::uint64_t{tracked} << 32 | other);
  };
  if (contact::visit_edge_boxes(boxes, visit)) counters.crowded += edges_.size();
  std::vector<std::uint64_t> keys;
  for (const auto& mine : found) keys.insert(keys.end(), mine.begin(), mine.end());
  std::sort(keys.begin(), keys.end());
  return keys;
}

void EdgePass::find_candidates(double margin, ContactCounters& counters) {
  const std::vector<std::uint64_t> keys = find_keys(margin, counters);
  counters.candidates += keys.size();
  std::vector<EdgePair> before = std::move(pairs_);
  pairs_.clear();
  pairs_.reserve(keys.size());
  auto old = before.begin();
  // Pairs in contact stay, however deep they are.
  const auto keep = [&](EdgePair& pair) {
    if (!pair.touch || pair.touch->apart()) return;
    pair.wake = 0;
    pairs_.push_back(std::move(pair));
  };
  for (const std::uint64_t key : keys) {
    for (; old != before.end() && old->key() < key; ++old) keep(*old);
    EdgePair& pair = pairs_.emplace_back();
    if (old != before.end() && old->key() == key) pair = std::move(*old++);
    pair.tracked = static_cast<std::uint32_t>(key >> 32);
    pair.other = static_cast<std::uint32_t>(key);
    pair.wake = 0;
  }
  for (; old != before.end(); ++old) keep(*old);
}

NodeAction EdgePass::decide_action(NodeContact& memory, const contact::NodeEncounter& encounter) const {
  if (!scene_.type.by_segments()) return contact::advance(memory, scene_.settings, encounter);
  return contact::advance_from_baseline(memory, encounter, reduction_);
}

void EdgePass::advance_pair(std::uint32_t number, const State& state, double used, Block& block) {
  EdgePair& pair = pairs_[number];
  if (pair.touch && pair.touch->apart()) pair.touch.reset();
  if (!pair.touch && pair.wake > used) return;
  ++block.checked;
  EdgeTouch* touch = pair.touch.get();
  const bool started = touch == nullptr, was_active = !started && touch->active;
  const double stored = started ? 0 : touch->stored();
  const Vector friction = was_active ? touch->force.friction : Vector(Vector::Zero());
  LinkWork work;
  if (was_active) touch->add_work(state, work);
  const SurfaceEdge &tracked = edges_[pair.tracked], &other = edges_[pair.other];
  Encounter encounter = measure_edges(scene_, tracked, other, pair.side);
  if (started) {
    pair.wake = used + encounter.distance - half_sum(tracked, other);
    if (!encounter.state.penetrates) return;
    touch = (pair.touch = std::make_unique<EdgeTouch>()).get();
    encounter.state.followed = !first_ && were_followed(scene_, tracked, other, state);
  }
  touch->active = decide_action(touch->memory, encounter.state) == NodeAction::force;
  touch->penetration = encounter.state.penetration;
  touch->point = {point_of(tracked, encounter.closest.s), point_of(other, encounter.closest.t)};
  // A new pair cannot be deeper than the edges have come closer since the last step: the rest comes from a pair of
  // neighbouring edges, and none of that is forgiven.
  if (started && !first_ && !scene_.type.by_segments()) {
    const Vector nearing = touch->point[1].of(state.v) - touch->point[0].of(state.v);
    touch->memory.forgiven = std::min(touch->memory.forgiven, std::max(0.0, nearing.dot(pair.side) * state.dt));
  }
  if (touch->active) {
    touch->force.normal = pair.side;
    touch->force.set_forces(springs_.between(pair.tracked, pair.other), touch->penetration - touch->memory.forgiven,
                            touch->point[0].of(state.v) - touch->point[1].of(state.v), friction, state.dt);
    touch->add_work(state, work);
  } else {
    touch->force = {};
  }
  touch->work = work;
  const bool released = touch->memory.state == NodeContact::State::released;
  block.released += released;
  if (released) block.lost += stored;
  if (was_active || touch->active) block.busy.push_back(number);
}

double EdgePass::advance_state(State& state, double used, ContactCounters& counters) {
  if (scene_.type.by_segments()) reduction_ = contact::baseline_reduction(model_, scene_.contact, state.time);
  blocks_.resize((pairs_.size() + pairs_per_block - 1) / pairs_per_block);
  parallel_for(blocks_.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      blocks_[b].checked = blocks_[b].released = 0;
      blocks_[b].lost = 0;
      blocks_[b].busy.clear();
      for (std::size_t i = b * pairs_per_block; i < std::min(pairs_.size(), (b + 1) * pairs_per_block); ++i)
        advance_pair(static_cast<std::uint32_t>(i), state, used, blocks_[b]);
    }
  });
  first_ = false;
  for (const Block& block : blocks_) counters.pairs += block.checked;
  return 0;
}

void EdgePass::add_forces(const State& state, Forces& forces, ContactState& result) const {
  for (const Block& block : blocks_) {
    result.released += block.released;
    result.lost += block.lost;
    for (const std::uint32_t number : block.busy) {
      const EdgePair& pair = pairs_[number];
      const EdgeTouch& touch = *pair.touch;
      const bool from_b = exchanged(pair);
      add_energies(touch.work, from_b, result);
      if (!touch.active) continue;
      result.touching += touch.force.push > 0;
      const Vector force = touch.force.force();
      for (std::size_t side = 0; side < 2; ++side) {
        const ContactPoint& point = touch.point[side];
        const Vector on_point = side == 0 ? force : Vector(-force);
        for (std::size_t end = 0; end < 2; ++end) forces.force[point.nodes[end].value] += point.weights[end] * on_point;
        if (result.single_surface) continue;
        const bool on_b = from_b == (side == 0);
        (on_b ? result.force_b : result.force_a) += on_point;
        (on_b ? result.moment_b : result.moment_a) += point.of(state.x).cross(on_point);
      }
    }
  }
}

void EdgePass::continue_from(InterfacePass& before, const State& state, ContactState& result) {
  auto* const old = dynamic_cast<EdgePass*>(&before);
  if (old == nullptr) return before.deactivate(state, result);
  first_ = old->first_;
  // Beams may lie on edges of shells.
  const auto ends = [](const EdgePass& pass, const SurfaceEdge& edge) {
    return std::tuple(std::min(edge.a, edge.b), std::max(edge.a, edge.b), pass.scene_.line(edge.segment));
  };
  std::map<std::tuple<NodeIndex, NodeIndex, bool>, std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < edges_.size(); ++i) numbers.emplace(ends(*this, edges_[i]), i);
  std::set<std::uint64_t> taken;
  pairs_.clear();
  for (EdgePair& was : old->pairs_) {
    const auto tracked = numbers.find(ends(*old, old->edges_[was.tracked]));
    const auto other = numbers.find(ends(*old, old->edges_[was.other]));
    if (tracked == numbers.end() || other == numbers.end()) continue;
    const bool swapped = scene_.line(edges_[tracked->second].segment) == scene_.line(edges_[other->second].segment) &&
                         tracked->second > other->second;
    if (swapped || !taken.insert(std::uint64_t{tracked->second} << 32 | other->second).second) continue;
    EdgePair& pair = pairs_.emplace_back(std::move(was));
    pair.tracked = tracked->second;
    pair.other = other->second;
    pair.wake = 0;
  }
  std::sort(pairs_.begin(), pairs_.end(), [](const EdgePair& a, const EdgePair& b) { return a.key() < b.key(); });
  old->deactivate(state, result);  // of ended contacts
}

void EdgePass::deactivate(const State& state, ContactState& result) {
  for (EdgePair& pair : pairs_) {
    if (pair.touch && pair.touch->active) {
      LinkWork work;
      pair.touch->add_work(state, work);
      add_energies(work, exchanged(pair), result);
      result.lost += pair.touch->stored();
    }
    pair.touch.reset();
    pair.side.setZero();
    pair.wake = 0;
  }
  blocks_.clear();
  first_ = true;
}

double EdgePass::stored() const {
  double sum = 0;
  for (const EdgePair& pair : pairs_)
    if (pair.touch) sum += pair.touch->stored();
  return sum;
}

std::vector<ContactNode> EdgePass::nodes() const {
  std::vector<ContactNode> all;
  for (const EdgePair& pair : pairs_) {
    if (!pair.touch) continue;
    const EdgeTouch& touch = *pair.touch;
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
    node.stored = touch.stored();
    node.contact_distance = half_sum(e, f);
    all.push_back(node);
  }
  return all;
}

void EdgePass::add_links(std::vector<ContactLink>& links) const {
  for (const EdgePair& pair : pairs_)
    if (pair.touch && pair.touch->active)
      links.push_back({pair.touch->point[0], pair.touch->point[1], exchanged(pair), pair.touch->force.force()});
}

}  // namespace gapcheck::solver
