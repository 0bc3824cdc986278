#include "solver/contact/tracked_pairs.hpp"

#include <algorithm>
#include <unordered_map>

#include "contact/pair/orientation.hpp"
#include "contact/pair/record_pair.hpp"
#include "contact/surface/segment_elements.hpp"

namespace gapcheck::solver {

using contact::NodeContact;

namespace {

using SegmentNumbers = std::unordered_map<contact::SegmentKey, SegmentIndex, contact::SegmentKeyHash>;

SegmentNumbers number_segments(const contact::Segments& segments) {
  SegmentNumbers numbers;
  for (const SegmentIndex s : positions<SegmentIndex>(segments.size()))
    numbers.try_emplace(contact::segment_key(segments.nodes[s.value]), s);
  return numbers;
}

/// Which side of a segment is its front does not change.
void continue_flipped(std::vector<bool>& flipped, const contact::PairScene& before, const SegmentNumbers& numbers,
                      std::size_t segments) {
  for (std::size_t s = 0; s < before.segments.size() && !(flipped.empty() && before.flipped.empty()); ++s) {
    const auto now = numbers.find(contact::segment_key(before.segments.nodes[s]));
    flipped.resize(segments, false);
    if (now != numbers.end()) flipped[now->second.value] = !before.flipped.empty() && before.flipped[s];
  }
}

}  // namespace

TrackedPairs::TrackedPairs(const ContactSetting& setting, ContactIndex contact,
                           const contact::ContactSurfaces& surfaces, bool exchanged, const std::vector<Vector>& x)
    : mesh_(setting.model.mesh),
      surfaces_(surfaces),
      side_(setting.model, contact, surfaces, exchanged, x, &setting.shared.neighbours),
      scene_(side_.scene()),
      exclusions_(setting.model, setting.model.contact(contact).id),
      rules_(scene_, side_.tracked(), exclusions_, setting.ties),
      exchanged_(exchanged),
      nodes_(scene_.nodes.size()) {
  side_.scene().flipped = contact::flipped_segments(scene_, setting.search);
  side_.scene().nearby = contact::nearby_behind(scene_);
  double largest_half = 0;
  for (const double half : scene_.nodes.half) largest_half = std::max(largest_half, half);
  for (const SegmentIndex s : positions<SegmentIndex>(scene_.segments.size()))
    greatest_reach_ = std::max(greatest_reach_, scene_.reach(s, largest_half));
}

void TrackedPairs::set_memory(const Penetration& record, const NodeContact& memory) {
  if (memory.state == NodeContact::State::apart) return;
  const auto pair = contact::find_pair(surfaces_, mesh_, record);
  if (pair && pair->node_on_b == exchanged_) touch(pair->slot).memory = memory;
}

std::size_t TrackedPairs::find_candidates(const contact::CandidateSearch& search, double margin,
                                          contact::SweepCounters& sweep) {
  candidates_.search(scene_, rules_, search, margin, sweep);
  const std::span<const SlotIndex> near = candidates_.slots();
  sleep_.assign(near.size(), 0);
  lost_.clear();
  auto next = near.begin();
  for (const SlotIndex slot : positions<SlotIndex>(nodes_.size())) {
    const bool is_near = next != near.end() && *next == slot;
    if (is_near) ++next;
    if (TrackedNode* const tracked = known(slot)) {
      tracked->lead = 0;
      tracked->rivals.clear();
      tracked->nearest = {};
      if (tracked->at_rest())
        nodes_[slot.value].reset();
      else if (!is_near)
        lost_.push_back(slot);
    }
  }
  return candidates_.size();
}

std::vector<SlotIndex> TrackedPairs::continue_from(const TrackedPairs& before) {
  const SegmentNumbers numbers = number_segments(scene_.segments);
  continue_flipped(side_.scene().flipped, before.scene_, numbers, scene_.segments.size());
  const std::vector<NodeIndex>& nodes = scene_.nodes.node;
  const std::vector<model::SegmentNodes>&now = scene_.segments.nodes, &then = before.scene_.segments.nodes;
  std::vector<SlotIndex> ended;
  for (const SlotIndex slot : positions<SlotIndex>(before.nodes_.size())) {
    const TrackedNode& was = before.node(slot);
    const NodeIndex node = before.scene_.nodes.node[slot.value];
    const auto at = std::lower_bound(nodes.begin(), nodes.end(), node);
    const bool there = at != nodes.end() && *at == node;
    const auto segment = was.active ? numbers.find(contact::segment_key(then[was.link.segment.value])) : numbers.end();
    const bool goes_on = there && segment != numbers.end();
    if (was.active && !goes_on) ended.push_back(slot);
    if (!there || was.at_rest()) continue;
    TrackedNode& tracked = touch(to_index<SlotIndex>(static_cast<std::size_t>(at - nodes.begin())));
    tracked = {};
    tracked.memory = was.memory;
    if (!goes_on) continue;
    tracked.active = true;
    tracked.penetration = was.penetration;
    tracked.link = was.link;
    tracked.link.segment = segment->second;
    // Following continues if s and t keep their meaning.
    tracked.link.on_face = was.link.on_face && now[segment->second.value] == then[was.link.segment.value];
  }
  return ended;
}

std::vector<KnownNode> TrackedPairs::known_nodes() const {
  std::vector<KnownNode> all;
  for (const SlotIndex slot : positions<SlotIndex>(nodes_.size()))
    if (const TrackedNode* const now = nodes_[slot.value].get())
      all.push_back({slot, {now->memory, now->active, now->penetration, 0, now->pair, now->link, {}, {}}});
  return all;
}

void TrackedPairs::continue_as(const TrackedPairs& other, std::span<const KnownNode> nodes) {
  contact::PairScene& scene = side_.scene();
  scene.flipped = other.scene_.flipped;
  scene.nearby = other.scene_.nearby;
  scene.solids = other.scene_.solids;
  greatest_reach_ = other.greatest_reach_;
  candidates_ = other.candidates_;
  for (std::size_t place = 0; place < near_places(); ++place)
    for (contact::Candidate& candidate : candidates_at(place)) candidate = {candidate.segment};
  const std::span<const SlotIndex> near = candidates_.slots();
  sleep_.assign(near.size(), 0);
  lost_.clear();
  for (const KnownNode& known : nodes) {
    touch(known.slot) = known.state;
    if (!std::binary_search(near.begin(), near.end(), known.slot)) lost_.push_back(known.slot);
  }
}

void TrackedPairs::forget_pair_data() {
  for (const std::unique_ptr<TrackedNode>& tracked : nodes_)
    if (tracked) tracked->pair = {};
}

void TrackedPairs::reset_nodes() {
  for (std::unique_ptr<TrackedNode>& tracked : nodes_) tracked.reset();
  std::fill(sleep_.begin(), sleep_.end(), 0);
}

}  // namespace gapcheck::solver
