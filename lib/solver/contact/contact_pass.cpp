#include "solver/contact/contact_pass.hpp"

#include <algorithm>
#include <limits>

#include "base/parallel.hpp"
#include "base/prefetch.hpp"
#include "contact/surface/segment_elements.hpp"
#include "solver/contact/curve_rule.hpp"
#include "solver/contact/penalty_rule.hpp"
#include "solver/contact/segment_rule.hpp"

namespace gapcheck::solver {

using geometry::FollowedPairs;

namespace {

/// Places that are checked together.
constexpr std::size_t places_per_block = 256;
static_assert(places_per_block % FollowedPairs::capacity == 0);

struct NodeMemories final : PassMemory {
  std::vector<KnownNode> nodes;
  bool fresh = true;
};

/// Asks the processor for the state of the node at a place: these states lie anywhere in memory.
void prefetch_node(const TrackedPairs& pairs, std::size_t place) { prefetch(&pairs.node(pairs.slot_at(place))); }

/// Asks for the velocities that a node in contact needs.
void prefetch_velocities(const TrackedPairs& pairs, std::size_t place, const State& state) {
  const SlotIndex slot = pairs.slot_at(place);
  const TrackedNode& tracked = pairs.node(slot);
  if (!tracked.active) return;
  const contact::PairScene& scene = pairs.scene();
  prefetch(&state.v[scene.nodes.node[slot.value].value]);
  for (const NodeIndex corner : scene.segments.nodes[tracked.link.segment.value]) prefetch(&state.v[corner.value]);
}

std::unique_ptr<NodeRule> make_rule(const ContactSetting& setting, const TrackedPairs& pairs) {
  if (pairs.scene().type.by_segments()) return std::make_unique<SegmentRule>(setting, pairs);
  if (acts_by_curve(pairs.scene().contact)) return std::make_unique<CurveRule>(setting, pairs);
  return std::make_unique<PenaltyRule>(setting, pairs);
}

}  // namespace

ContactPass::ContactPass(const ContactSetting& setting, ContactIndex contact, const contact::ContactSurfaces& surfaces,
                         bool exchanged, const std::vector<Vector>& x)
    : setting_(setting),
      contact_(contact),
      pairs_(setting, contact, surfaces, exchanged, x),
      rule_(make_rule(setting, pairs_)),
      finder_(pairs_),
      settler_(setting, contact, pairs_, *rule_) {}

void ContactPass::set_memory(const Penetration& record, const contact::NodeContact& memory) {
  if (rule_->keeps_initial_memory()) pairs_.set_memory(record, memory);
}

void ContactPass::set_timestep(double timestep) {
  rule_->set_timestep(timestep);
  pairs_.forget_pair_data();
}

void ContactPass::find_candidates(double margin, ContactCounters& counters) {
  contact::SweepCounters sweep;
  counters.candidates += pairs_.find_candidates(setting_.search, margin, sweep);
  counters.crowded += sweep.crowded_nodes;
  for (PassBlock& block : blocks_) block.sleep = 0;
}

void ContactPass::advance_places(std::size_t first, std::size_t last, const State& state, double used,
                                 FinderScratch& scratch, std::size_t b) {
  finder_.follow_pairs(first, last, scratch);
  PassBlock& block = blocks_[b];
  const std::size_t end = std::min(pairs_.places(), (b + 1) * places_per_block);
  for (std::size_t place = first; place < last; ++place) {
    // Other threads are at the places of other blocks.
    if (place + FollowedPairs::capacity < end) prefetch_node(pairs_, place + FollowedPairs::capacity);
    if (constexpr std::size_t soon = 4; place + soon < last) {
      finder_.prefetch_place(place + soon);
      prefetch_velocities(pairs_, place + soon, state);
    }
    if (std::optional<NodeMeeting> meeting = finder_.find_meeting(place, used, scratch, block.counts))
      settler_.settle_node(place, *meeting, state, block, pushes_[b]);
    else
      block.released += pairs_.node(pairs_.slot_at(place)).released();
  }
}

void ContactPass::advance_block(std::size_t b, const State& state, double used, FinderScratch& scratch) {
  const std::size_t near = pairs_.near_places(), places = pairs_.places();
  const std::size_t first = b * places_per_block, last = std::min(places, first + places_per_block);
  PassBlock& block = blocks_[b];
  pushes_[b].clear();
  if (block.sleep > used && last <= near) {
    block.keep_asleep(last - first);
    return;
  }
  block.clear();
  for (std::size_t place = first; place < std::min(last, first + FollowedPairs::capacity); ++place)
    prefetch_node(pairs_, place);
  for (std::size_t place = first; place < last; place += FollowedPairs::capacity)
    advance_places(place, std::min(last, place + FollowedPairs::capacity), state, used, scratch, b);
  if (last > near) return;
  block.sleep = std::numeric_limits<double>::infinity();
  for (std::size_t place = first; place < last; ++place) {
    const bool active = pairs_.node(pairs_.slot_at(place)).active;
    block.sleep = std::min(block.sleep, active ? 0 : pairs_.sleep(place));
  }
}

double ContactPass::move_nodes(const PassBlock& block, State& state) const {
  const contact::PairScene& scene = pairs_.scene();
  double longest = 0;
  for (const NodeMove& move : block.moves) {
    const NodeIndex node = scene.nodes.node[move.slot.value];
    Vector& x = state.x[node.value];
    const Vector from = x;
    x += move.way;
    longest = std::max(longest, move.way.norm());
    if (setting_.shot == nullptr) continue;
    const SegmentIndex segment = pairs_.node(move.slot).link.segment;
    setting_.shot->push_back({contact_, node, scene.nodes.part[move.slot.value],
                              contact::part_of(scene.model.mesh, scene.segments, segment.value), from, x});
  }
  return longest;
}

double ContactPass::advance_state(State& state, double used, ContactCounters& counters) {
  if (rule_->begin_cycle(state)) pairs_.forget_pair_data();
  // Half of what springs get at their length before this step, half at that after it.
  if (const SpringGrowth growth = rule_->growth(); growth.before != growth.now)
    given_ = growth.before > 0 ? (growth.now / growth.before - 1) / 2 * stored() : 0;
  blocks_.resize((pairs_.places() + places_per_block - 1) / places_per_block);
  pushes_.resize(blocks_.size());
  parallel_for(blocks_.size(), 1, [&](std::size_t begin, std::size_t end) {
    static thread_local FinderScratch scratch;
    for (std::size_t b = begin; b < end; ++b) advance_block(b, state, used, scratch);
  });
  double longest = 0;
  for (const PassBlock& block : blocks_) {
    block.counts.add_to(counters);
    longest = std::max(longest, move_nodes(block, state));
  }
  pairs_.clear_lost();
  settler_.end_cycle();
  return longest;
}

void ContactPass::add_forces(const State& state, Forces& forces, ContactState& result) const {
  const contact::Segments& segments = pairs_.scene().segments;
  add_pushes(pushes_, segments, forces);
  for (const PassBlock& block : blocks_) block.add_to(pairs_.exchanged(), result);
  if (const SpringGrowth growth = rule_->growth(); growth.before != growth.now && growth.now > 0)
    result.lost -= given_ + (growth.before > 0 ? 0.5 : 1) * (1 - growth.before / growth.now) * stored();
  if (!result.single_surface) add_totals(pushes_, segments, state.x, pairs_.exchanged(), result);
}

void ContactPass::end_force(SlotIndex slot, const State& state, ContactState& result) const {
  LinkWork work;
  pairs_.add_work(slot, state, work);
  add_energies(work, pairs_.exchanged(), result);
  result.lost += pairs_.node(slot).stored();
}

void ContactPass::continue_from(InterfacePass& before, const State& state, ContactState& result) {
  const auto* const old = dynamic_cast<const ContactPass*>(&before);
  if (old == nullptr) return before.deactivate(state, result);
  for (const SlotIndex slot : pairs_.continue_from(old->pairs_)) old->end_force(slot, state, result);
  rule_->continue_from(*old->rule_);
  settler_.continue_from(old->settler_);
}

std::unique_ptr<PassMemory> ContactPass::memory() const {
  // The rules of SOFT = 2 and of curves have a memory of their own.
  if (pairs_.scene().type.by_segments() || rule_->has_memory()) return nullptr;
  auto memory = std::make_unique<NodeMemories>();
  memory->nodes = pairs_.known_nodes();
  memory->fresh = settler_.fresh();
  return memory;
}

void ContactPass::continue_as(const InterfacePass& other, const PassMemory& memory) {
  const auto* const pass = dynamic_cast<const ContactPass*>(&other);
  const auto* const known = dynamic_cast<const NodeMemories*>(&memory);
  if (pass == nullptr || known == nullptr) return;
  pairs_.continue_as(pass->pairs_, known->nodes);
  if (!known->fresh) set_followed();
}

void ContactPass::deactivate(const State& state, ContactState& result) {
  for (const SlotIndex slot : positions<SlotIndex>(pairs_.size()))
    if (pairs_.node(slot).active) end_force(slot, state, result);
  pairs_.reset_nodes();
  blocks_.clear();
  pushes_.clear();
  rule_->forget();
  settler_.forget();
}

double ContactPass::stored() const {
  double sum = 0;
  for (const SlotIndex slot : positions<SlotIndex>(pairs_.size())) sum += pairs_.node(slot).stored();
  return sum;
}

std::vector<ContactNode> ContactPass::nodes() const {
  const contact::PairScene& scene = pairs_.scene();
  std::vector<ContactNode> all;
  for (const SlotIndex slot : positions<SlotIndex>(pairs_.size())) {
    const TrackedNode& tracked = pairs_.node(slot);
    if (!tracked.active && !tracked.released()) continue;
    ContactNode& node = all.emplace_back();
    const double push = tracked.link.push + tracked.link.damping;
    node.kind = tracked.released() ? ContactNode::Kind::released
                : push > 0         ? ContactNode::Kind::touching
                                   : ContactNode::Kind::kept;
    node.node = scene.nodes.node[slot.value];
    node.segment = scene.segments.nodes[tracked.link.segment.value];
    node.force = tracked.link.force();
    node.penetration = tracked.penetration;
    node.forgiven = tracked.memory.forgiven;
    const double area = pairs_.segment_area(tracked.link.segment);
    node.pressure = area > 0 ? push / area : 0;
    node.stored = tracked.stored();
    node.release_depth = tracked.pair.release_depth;
    node.part = scene.nodes.part[slot.value];
    const SegmentIndex segment = tracked.link.segment;
    node.contact_distance = scene.nodes.half[slot.value] + scene.segments.half[segment.value];
    node.segment_part = contact::part_of(scene.model.mesh, scene.segments, segment.value);
  }
  return all;
}

std::vector<Touch> ContactPass::touches() const {
  const contact::PairScene& scene = pairs_.scene();
  std::vector<Touch> all;
  for (const SlotIndex slot : positions<SlotIndex>(pairs_.size())) {
    const TrackedNode& tracked = pairs_.node(slot);
    const double depth = tracked.penetration - tracked.memory.forgiven;
    if (!tracked.active || !(tracked.link.push > 0) || !(depth > 0)) continue;
    const std::size_t segment = tracked.link.segment.value;
    Touch& touch = all.emplace_back();
    touch.node = scene.nodes.node[slot.value];
    touch.point = {scene.segments.nodes[segment], tracked.link.weights};
    touch.element_kind = scene.segments.element_kind[segment];
    touch.element = scene.segments.element[segment];
    touch.segment_part = contact::part_of(scene.model.mesh, scene.segments, segment);
    touch.push = tracked.link.push * tracked.link.normal;
    touch.depth = depth;
    touch.spring = tracked.pair.spring;
  }
  return all;
}

void ContactPass::add_links(std::vector<ContactLink>& links) const {
  const contact::PairScene& scene = pairs_.scene();
  for (const SlotIndex slot : positions<SlotIndex>(pairs_.size())) {
    const TrackedNode& tracked = pairs_.node(slot);
    if (!tracked.active) continue;
    ContactLink& link = links.emplace_back();
    link.tracked = {{scene.nodes.node[slot.value]}, {1}};
    link.reference = {scene.segments.nodes[tracked.link.segment.value], tracked.link.weights};
    link.exchanged = pairs_.exchanged();
    link.force = tracked.link.force();
  }
}

}  // namespace gapcheck::solver
