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
      side_(setting.model, contact, surfaces, exchanged, x),
      scene_(side_.scene()),
      exclusions_(setting.model, setting.model.contact(contact).id),
      rules_(scene_, side_.tracked(), exclusions_, setting.ties),
      exchanged_(exchanged),
      nodes_(scene_.nodes.size()) {
  side_.scene().flipped = contact::flipped_segments(scene_, setting.search);
  double largest_half = 0;
  for (const double half : scene_.nodes.half) largest_half = std::max(largest_half, half);
  for (const SegmentIndex s : positions<SegmentIndex>(scene_.segments.size()))
    greatest_reach_ = std::max(greatest_reach_, scene_.reach(s, largest_half));
}

void TrackedPairs::set_memory(const Penetration& record, const NodeContact& memory) {
  const auto pair = contact::find_pair(surfaces_, mesh_, record);
  if (pair && pair->node_on_b == exchanged_) nodes_[pair->slot.value].memory = memory;
}

std::size_t TrackedPairs::find_candidates(const contact::CandidateSearch& search, double margin,
                                          contact::SweepCounters& sweep) {
  candidates_.search(scene_, rules_, search, margin, sweep);
  std::vector<bool> found(nodes_.size(), false);
  for (const SlotIndex slot : candidates_.slots()) {
    found[slot.value] = true;
    TrackedNode& tracked = node(slot);
    tracked.sleep = tracked.lead = 0;
  }
  lost_.clear();
  for (const SlotIndex slot : positions<SlotIndex>(nodes_.size()))
    if (!found[slot.value] && (node(slot).active || node(slot).memory.state != NodeContact::State::apart))
      lost_.push_back(slot);
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
    if (!there) continue;
    TrackedNode& tracked = nodes_[static_cast<std::size_t>(at - nodes.begin())];
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

void TrackedPairs::forget_pair_data() {
  for (TrackedNode& tracked : nodes_) tracked.pair = {};
}

void TrackedPairs::reset_node(SlotIndex slot) {
  TrackedNode& tracked = node(slot);
  tracked.active = false;
  tracked.memory = {};
  tracked.sleep = tracked.lead = 0;
}

}  // namespace gapcheck::solver
