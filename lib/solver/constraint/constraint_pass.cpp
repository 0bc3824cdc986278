#include "solver/constraint/constraint_pass.hpp"

#include <algorithm>
#include <optional>

#include "base/parallel.hpp"
#include "base/quad.hpp"
#include "contact/mesh/faces.hpp"
#include "contact/pair/hit.hpp"
#include "contact/pair/orientation.hpp"
#include "contact/pair/release.hpp"

namespace gapcheck::solver {
namespace {

using contact::NodeContact;
using contact::PairResult;

/// Corners of a segment with their weights; in a triangle the third has those of both last ones.
ContactPoint point_of(const model::SegmentNodes& nodes, const geometry::ClosestPoint& closest) {
  ContactPoint point{nodes, quad_weights(closest.s, closest.t)};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k)
      if (nodes[k] == nodes[i]) {
        point.weights[i] += point.weights[k];
        point.weights[k] = 0;
      }
  return point;
}

}  // namespace

/// Position of a tracked node relative to the segments of the other side.
struct ConstraintPass::Meeting {
  std::optional<contact::Hit> hit;
  PairResult pair;       ///< with the hit's segment
  bool in_zone = false;  ///< some segment is nearer than the contact distance
};

ConstraintPass::ConstraintPass(const model::Model& model, ContactIndex contact,
                               const contact::ContactSurfaces& surfaces, bool exchanged,
                               const contact::CandidateSearch& search, const contact::TiedPairs& ties,
                               const std::vector<bool>& movable, const std::vector<Vector>& x)
    : model_(model),
      side_(model, contact, surfaces, exchanged, x),
      scene_(side_.scene()),
      exclusions_(model, model.contact(contact).id),
      rules_(scene_, side_.tracked(), exclusions_, ties),
      friction_(model, model.contact(contact)),
      search_(search),
      movable_(movable),
      exchanged_(exchanged),
      memory_(scene_.nodes.size()) {
  side_.scene().flipped = contact::flipped_segments(scene_, search);
  side_.scene().nearby = contact::nearby_behind(scene_);
  default_tolerance_ = scene_.tolerance;
}

void ConstraintPass::find_candidates(double margin) {
  contact::SweepCounters counters;
  candidates_.search(scene_, rules_, search_, margin, counters);
}

ConstraintPass::Meeting ConstraintPass::find_meeting(SlotIndex slot,
                                                     std::span<const contact::Candidate> candidates) const {
  std::vector<contact::Hit> hits, measured;
  std::vector<PairResult> results;
  for (const contact::Candidate& candidate : candidates) {
    const PairResult pair = contact::decide_pair(scene_, slot, candidate.segment);
    const contact::Hit hit{slot, candidate.segment, pair.distance, pair.in_band};
    if (pair.penetrates) {
      hits.push_back(hit);
      results.push_back(pair);
    } else if (scene_.oriented(candidate.segment)) {
      measured.push_back(hit);
    }
  }
  Meeting meeting;
  meeting.in_zone = !hits.empty();
  if (!meeting.in_zone) return meeting;
  meeting.hit = contact::choose_hit(scene_, hits, measured);
  if (meeting.hit && !meeting.hit->in_band) meeting.hit.reset();
  for (std::size_t i = 0; meeting.hit && i < hits.size(); ++i)
    if (hits[i].segment == meeting.hit->segment) meeting.pair = results[i];
  return meeting;
}

std::vector<ConstraintPass::Move> ConstraintPass::find_moves() {
  side_.scene().tolerance = default_tolerance_;
  const std::span<const SlotIndex> slots = candidates_.slots();
  std::vector<Move> moves(slots.size(), Move{none<NodeIndex>, Vector::Zero()});
  std::vector<bool> near(memory_.size(), false);
  for (const SlotIndex slot : slots) near[slot.value] = true;
  for (std::size_t slot = 0; slot < memory_.size(); ++slot)
    if (!near[slot]) memory_[slot] = {};
  parallel_for(slots.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const SlotIndex slot = slots[i];
      const Meeting meeting = find_meeting(slot, candidates_.of(i));
      contact::NodeEncounter encounter;
      encounter.in_zone = meeting.in_zone;
      Memory& memory = memory_[slot.value];
      if (meeting.hit) {
        memory.segment = meeting.hit->segment;
        encounter.penetrates = true;
        encounter.penetration =
            scene_.nodes.half[slot.value] + scene_.segments.half[memory.segment.value] - meeting.pair.distance;
        encounter.release_depth = contact::release_depth(scene_, slot, memory.segment);
      }
      memory.penetration = encounter.penetration;
      if (contact::advance(memory.contact, scene_.settings, encounter) == contact::NodeAction::none) continue;
      const NodeIndex node = scene_.nodes.node[slot.value];
      const double depth = encounter.penetration - memory.contact.forgiven;
      if (!movable_[node.value] || !(depth > 0)) continue;
      moves[i] = {node, depth * contact::free_direction(scene_, slot, memory.segment, meeting.pair)};
    }
  });
  std::erase_if(moves, [](const Move& move) { return move.node == none<NodeIndex>; });
  return moves;
}

ConstraintPass::Hit ConstraintPass::hit_of(SlotIndex slot, const Meeting& meeting) const {
  const SegmentIndex segment = meeting.hit->segment;
  Hit hit;
  hit.slot = slot;
  hit.depth = scene_.nodes.half[slot.value] + scene_.segments.half[segment.value] - meeting.pair.distance -
              memory_[slot.value].contact.forgiven;
  SurfaceConstraint& c = hit.constraint;
  c.node = scene_.nodes.node[slot.value];
  c.normal = contact::free_direction(scene_, slot, segment, meeting.pair);
  c.segment = point_of(scene_.segments.nodes[segment.value], meeting.pair.closest);
  hit.area = contact::area(scene_.segments.nodes[segment.value], scene_.x);
  if (friction_.any())
    hit.friction =
        friction_.between(scene_.nodes.part[slot.value], contact::part_of(model_.mesh, scene_.segments, segment.value));
  return hit;
}

std::vector<ConstraintPass::Hit> ConstraintPass::find_hits() {
  side_.scene().tolerance = 0;  // otherwise nodes that sink only by rounding in each step would come back in jumps
  const std::span<const SlotIndex> slots = candidates_.slots();
  std::vector<std::optional<Hit>> found(slots.size());
  parallel_for(slots.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (memory_[slots[i].value].contact.state == NodeContact::State::released) continue;
      const Meeting meeting = find_meeting(slots[i], candidates_.of(i));
      if (meeting.hit) found[i] = hit_of(slots[i], meeting);
    }
  });
  std::vector<Hit> hits;
  for (std::optional<Hit>& one : found)
    if (one && one->depth > 0) hits.push_back(*one);
  return hits;
}

void ConstraintPass::continue_from(const ConstraintPass& before) {
  const std::vector<NodeIndex>& nodes = scene_.nodes.node;
  for (std::size_t slot = 0; slot < before.memory_.size(); ++slot) {
    const NodeIndex node = before.scene_.nodes.node[slot];
    const auto at =
        std::lower_bound(nodes.begin(), nodes.end(), node, [](NodeIndex a, NodeIndex b) { return a.value < b.value; });
    if (at == nodes.end() || *at != node) continue;
    Memory& memory = memory_[static_cast<std::size_t>(at - nodes.begin())];
    memory.contact = before.memory_[slot].contact;
  }
}

void ConstraintPass::deactivate() { memory_.assign(memory_.size(), {}); }

std::uint64_t ConstraintPass::released() const {
  return static_cast<std::uint64_t>(std::count_if(memory_.begin(), memory_.end(), [](const Memory& memory) {
    return memory.contact.state == NodeContact::State::released;
  }));
}

void ConstraintPass::add_released(std::vector<ContactNode>& nodes) const {
  for (std::size_t slot = 0; slot < memory_.size(); ++slot) {
    if (memory_[slot].contact.state != NodeContact::State::released) continue;
    ContactNode& node = nodes.emplace_back();
    node.kind = ContactNode::Kind::released;
    node.node = scene_.nodes.node[slot];
    node.segment = scene_.segments.nodes[memory_[slot].segment.value];
    node.penetration = memory_[slot].penetration;
  }
}

}  // namespace gapcheck::solver
